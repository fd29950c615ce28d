import { Button, DataTable, Empty, Loaded, PageHead, Panel, Problem, Select } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say, sayCode, sentenceOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked } from "../../core/resource";
import { canWork, may } from "../../core/session";
import { checksTabs } from "../../core/tabs";
import { toastProblem } from "../../core/toasts";
import type { Anchoring, PersonRepeats, RepeatDifference, Target } from "../../core/types";
import { fixed, formatSmall, type LengthUnit, lengthScale, lengthUnit, smallScale } from "../../core/units";
import { TARGET_WORDS, TARGETS } from "../../core/words";
import { type Dot, type Plot, PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import type { PlotOptions } from "../../parts/figures/style";
import { NO_SPREAD, spread, TargetTable } from "./TargetTable";
import { pixelWords, shiftWords } from "./words";
import "./repeats.css";

export default function RepeatsScreen({ surveyId }: ScreenProps) {
  const found = useAsked("GET /surveys/{survey_id}/repeats", { survey_id: surveyId });
  const plan = useAsked("GET /surveys/{survey_id}/review-plan", { survey_id: surveyId });
  const { busy, problem, run } = useAction();
  const choose = (person: PersonRepeats, own: boolean) =>
    run(async () => {
      await api.write(
        "PUT /surveys/{survey_id}/people/{person_id}/click-sigma",
        { survey_id: surveyId, person_id: person.person.id },
        { body: { own } },
      );
      await found.reload();
    });
  const data = found.data;
  return (
    <div class="page">
      <PageHead says="page-repeats" lead={say("repeats-lead", { people: data?.people.length ?? 0 })}>
        {canWork.value && data !== null && data.repeats > 0 && <Again surveyId={surveyId} />}
      </PageHead>
      <PageTabs label={say("page-checks")} tabs={checksTabs(surveyId, "repeats")} />
      <Problem error={problem} />
      <Loaded of={found} what={say("repeats-loading")} />
      <Problem error={plan.error} again={plan.reload} />
      {data && data.repeats === 0 && plan.data && (
        <Nothing surveyId={surveyId} oneIn={plan.data.blind_one_in} />
      )}
      {data && data.repeats > 0 && (
        <>
          <TargetTable found={data} />
          <PeopleTable people={data.people} busy={busy} choose={choose} />
          {data.differences.length > 0 && <DifferenceFigure differences={data.differences} />}
          {data.not_compared > 0 && (
            <p class="small muted">{say("repeats-not-compared", { count: data.not_compared })}</p>
          )}
        </>
      )}
      {data && <AnchoringPanel surveyId={surveyId} />}
    </div>
  );
}

function Again({ surveyId }: { surveyId: number }) {
  const path = `/surveys/${surveyId}/repeats/click`;
  return (
    <div class="row row--wrap">
      <Button says="repeats-click-mine" kind="primary" href={path} />
      <Button says="repeats-click-anybodys" href={`${path}?of=all`} />
    </div>
  );
}

function Nothing({ surveyId, oneIn }: { surveyId: number; oneIn: number }) {
  return (
    <Empty
      says="repeats-none-title"
      actions={
        <>
          {canWork.value && <Again surveyId={surveyId} />}
          <Button says="repeats-to-review" href={`/surveys/${surveyId}/review`} />
        </>
      }
    >
      <p>{say("repeats-none", { one_in: oneIn })}</p>
      <p>{say("repeats-no-result")}</p>
    </Empty>
  );
}

/** How far people lean on proposals that they are shown: heights shown against those measured free, with the goal beside it. */
function AnchoringPanel({ surveyId }: { surveyId: number }) {
  const found = useAsked("GET /surveys/{survey_id}/anchoring", { survey_id: surveyId });
  const data = found.data;
  const choose = async (free_one_in: number): Promise<void> => {
    const version = data?.plan.version ?? 0;
    await api
      .write(
        "PUT /surveys/{survey_id}/free-plan",
        { survey_id: surveyId },
        { body: { free_one_in, version } },
      )
      .catch(toastProblem);
    await found.reload();
  };
  if (!data) return <Problem error={found.error} again={found.reload} />;
  return (
    <Panel says="anchoring-title" aside={<Plan plan={data.plan} choose={choose} />} data-testid="anchoring">
      <DataTable
        label={say("anchoring-title")}
        class="repeats"
        rows={data.targets}
        keyOf={(one) => one.target ?? "all"}
        columns={({ col, num }) => [
          col(say("repeats-target"), ({ target }) => (
            <strong>{target === null ? say("repeats-all-targets") : TARGET_WORDS[target]}</strong>
          )),
          num(
            say("anchoring-shown"),
            ({ shift }) => <Mean count={shift.shown} mean_m={shift.shown_m} />,
            "nowrap",
          ),
          num(
            say("anchoring-free"),
            ({ shift }) => <Mean count={shift.free} mean_m={shift.free_m} />,
            "nowrap",
          ),
          col(say("anchoring-shift"), ({ shift }) => shiftWords(shift) ?? "–", "nowrap"),
          col(
            say("anchoring-goal", { goal: formatSmall(data.goal_m) }),
            ({ verdict, shift }) =>
              verdict
                ? say("anchoring-verdict", { verdict })
                : sayCode({ code: shift.reason ?? "", values: {} }),
            "small",
          ),
        ]}
      />
      <p class="panel__note words small muted">
        {say("anchoring-help")}{" "}
        {say("anchoring-counts", { confirmed: data.confirmed, moved: data.moved, afresh: data.afresh })}
      </p>
    </Panel>
  );
}

function Mean({ count, mean_m }: { count: number; mean_m: number | null }) {
  return (
    <>
      {say("anchoring-vehicles", { count })}
      {mean_m !== null && <p class="small muted">{formatSmall(mean_m)}</p>}
    </>
  );
}

const PLANS = [0, 5, 10, 20, 50];

/** One vehicle in how many: told to everybody, chosen by an administrator. */
function Plan({ plan, choose }: { plan: Anchoring["plan"]; choose: (one_in: number) => void }) {
  const oneIn = plan.free_one_in;
  const words = (one_in: number) => say("anchoring-plan", { one_in });
  if (!may("manager")) return <span class="muted small">{words(oneIn)}</span>;
  return (
    <Select
      aria-label={say("anchoring-plan-choose")}
      title={say("anchoring-plan-choose")}
      data-testid="free-plan"
      value={oneIn}
      options={(PLANS.includes(oneIn) ? PLANS : [oneIn, ...PLANS]).map((value) => ({
        value,
        label: words(value),
      }))}
      onInput={choose}
    />
  );
}

interface Props {
  people: readonly PersonRepeats[];
  busy: boolean;
  choose: (person: PersonRepeats, own: boolean) => Promise<unknown>;
}

/** Per person: clicks and heights of their own repeats, how they lean, and which sigma their clicks count with. */
function PeopleTable({ people, busy, choose }: Props) {
  return (
    <Panel says="repeats-people-title" note={say("repeats-people-note")}>
      <DataTable
        label={say("repeats-people-title")}
        class="repeats"
        data-testid="repeats-people"
        rows={people}
        keyOf={(one) => one.person.id}
        columns={(made) => [
          made.col(say("repeats-person"), (one) => <strong>{one.person.name}</strong>),
          made.num(say("repeats-own"), (one) => one.pairs),
          ...made.across(
            ({ sigma }) => (sigma.sd === null ? sentenceOf(sigma.reason) : undefined),
            NO_SPREAD,
            ...spread(made, say("repeats-contact"), (one) => one.contact, pixelWords),
            ...spread(made, say("repeats-target"), (one) => one.target_point, pixelWords),
            ...spread(made, say("repeats-height"), (one) => one.heights),
          ),
          made.col(say("repeats-against-others"), (one) => (
            <>
              {one.operator_bias_m === null ? "–" : biasWords(one.operator_bias_m)}
              <p class="small muted nowrap">{say("repeats-items", { count: one.items })}</p>
            </>
          )),
          made.col(say("repeats-sigma"), (one) => <Sigma one={one} busy={busy} choose={choose} />),
        ]}
      />
    </Panel>
  );
}

function biasWords(operator_bias_m: number): string {
  return `${operator_bias_m > 0 ? "+" : ""}${formatSmall(operator_bias_m)}`;
}

function Sigma({ one, busy, choose }: { one: PersonRepeats } & Pick<Props, "busy" | "choose">) {
  const chosen = one.chosen?.sigma_px ?? null;
  const found = one.sigma.sd;
  const reviewer = may("reviewer");
  return (
    <>
      <strong>
        {chosen === null
          ? say("repeats-sigma-usual")
          : say("repeats-sigma-own", { sigma_px: fixed(chosen, 2) })}
      </strong>
      {chosen !== null && one.chosen && (
        <p class="small muted">
          {say("repeats-sigma-from", {
            count: one.chosen.pairs,
            person: one.chosen.created_by?.name ?? say("person-system"),
          })}
        </p>
      )}
      {found !== null && one.may_choose && reviewer && chosen !== Math.round(found * 1000) / 1000 && (
        <p>
          <Button
            small
            disabled={busy}
            title={say("repeats-sigma-use-title", { count: one.pairs })}
            onClick={() => void choose(one, true)}
          >
            {say("repeats-sigma-use", { sigma_px: fixed(found, 2) })}
          </Button>
        </p>
      )}
      {found !== null && !one.may_choose && <p class="small muted">{say("repeats-sigma-needs")}</p>}
      {chosen !== null && reviewer && (
        <p>
          <Button
            says="repeats-sigma-back"
            small
            kind="quiet"
            disabled={busy}
            onClick={() => void choose(one, false)}
          />
        </p>
      )}
    </>
  );
}

/** Symbols tell the targets apart: colours belong to the road's axes. */
const SYMBOLS: readonly Dot[] = ["triangle", "circle", "square", "cross", "diamond"];

/** Each repeat's difference from what it repeats, with the bar that the clicks' uncertainty lets one expect. */
function DifferenceFigure({ differences }: { differences: readonly RepeatDifference[] }) {
  const unit = lengthUnit.value;
  const shown = TARGETS.filter((target) => differences.some((one) => one.target === target));
  return (
    <PlotFigure
      name="repeats"
      title={say("repeats-differences-title")}
      says={say("repeats-differences-label", { small: smallScale(unit)[1], unit, count: differences.length })}
      note={say("repeats-differences-note")}
      legend={shown.map((target) => ({ word: TARGET_WORDS[target], dot: symbolOf(target) }))}
      data={differences}
      options={(plot, unit) => drawn(plot, differences, unit)}
      table={() => ({
        columns: ["target", "mean_m", "difference_m", "expected_m"],
        rows: differences.map((one) => [one.target, one.mean_m, one.difference_m, one.expected_m]),
      })}
    />
  );
}

function symbolOf(target: Target): Dot {
  return SYMBOLS[TARGETS.indexOf(target) % SYMBOLS.length] ?? "circle";
}

function drawn(plot: Plot, differences: readonly RepeatDifference[], unit: LengthUnit): PlotOptions {
  const [[perX], [perY, small]] = [lengthScale(unit), smallScale(unit)];
  const at = {
    x: (one: RepeatDifference) => one.mean_m * perX,
    y: (one: RepeatDifference) => one.difference_m * perY,
    low: (one: RepeatDifference) => (one.difference_m - one.expected_m) * perY,
    high: (one: RepeatDifference) => (one.difference_m + one.expected_m) * perY,
  };
  const marks = TARGETS.map((target) => {
    const points = differences.filter((one) => one.target === target);
    const dots = plot.dot(points, {
      x: at.x,
      y: at.y,
      symbol: symbolOf(target),
      r: 4,
      fill: "var(--surface)",
      stroke: "var(--ink)",
      strokeWidth: 1.5,
    });
    return [
      plot.ruleX(points, { x: at.x, y1: at.low, y2: at.high, stroke: "var(--line-strong)" }),
      readable(dots, readRows(points, at, "points", TARGET_WORDS[target])),
    ];
  });
  return {
    x: { label: say("repeats-differences-x", { unit }), nice: true },
    y: { label: say("repeats-differences-y", { unit: small }), nice: true },
    marks: [plot.ruleY([0], { stroke: "var(--line-strong)" }), ...marks.flat()],
  };
}
