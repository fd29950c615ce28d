/** Review by lots: what could be drawn, the lots, and one of them with its curve, its progress and its decision in words. */
import { useState } from "preact/hooks";
import {
  Button,
  Check,
  DataTable,
  Loaded,
  Notice,
  PageHead,
  Panel,
  Problem,
  TextField,
} from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { useAction } from "../../core/action";
import { query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useResource } from "../../core/resource";
import { may } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { reviewTabs } from "../../core/tabs";
import type { PlannedLot, ShownLot } from "../../core/types";
import { formatCount, parseNumber } from "../../core/units";
import { lotWords } from "../../parts/lots/words";
import { LotPanel } from "./LotPanel";
import { commonInWords, LOT_STATES } from "./lots";
import "./checks.css";

const GROUPING_WORDS = wordsOf("lots-by-", "target", "lighting", "operator", "day");
type Grouping = keyof typeof GROUPING_WORDS;
const GROUPINGS = Object.keys(GROUPING_WORDS) as Grouping[];
const RISKS = ["producer_quality", "producer_risk", "consumer_quality", "consumer_risk"] as const;
type Risk = (typeof RISKS)[number];
const RISK_WORDS: Readonly<Record<Risk, string>> = wordsOf("lots-risk-");
/** In per cent: 1 wrong height in 100 nearly always passes, 1 in 10 hardly ever. */
const USUAL: Readonly<Record<Risk, string>> = {
  producer_quality: "1",
  producer_risk: "5",
  consumer_quality: "10",
  consumer_risk: "10",
};

export default function LotsScreen({ surveyId }: ScreenProps) {
  const where = { survey_id: surveyId };
  const read = useResource(
    async (signal) => {
      const [lots, summary] = await Promise.all([
        api.ask("GET /surveys/{survey_id}/lots", where, { signal }),
        api.ask("GET /surveys/{survey_id}/lots/summary", where, { signal }),
      ]);
      return { lots, summary };
    },
    [surveyId],
    { keep: true },
  );
  const { lots, summary } = read.data ?? { lots: [], summary: null };
  const wanted = Number(query.value.get("lot"));
  const shown = lots.find((one) => one.lot.id === wanted) ?? lots[0];
  const again = async () => {
    await Promise.all([read.reload(), refreshSurvey()]);
  };
  return (
    <div class="page checks">
      <PageHead says="page-lots" lead={say("lots-lead")} />
      <PageTabs label={say("page-review")} tabs={reviewTabs(surveyId, "lots")} />
      <Loaded of={read} what={say("lots-loading")} />
      {summary && (
        <Notice kind="info">
          <span data-testid="lots-summary">{lotWords(summary)}</span>
        </Notice>
      )}
      {read.data && <Draw surveyId={surveyId} changed={read.data} done={again} />}
      {lots.length > 0 && <Lots lots={lots} shown={shown} />}
      {shown && <LotPanel key={shown.lot.id} surveyId={surveyId} shown={shown} done={again} />}
    </div>
  );
}

interface DrawProps {
  surveyId: number;
  /** What was read of the lots: what waits is another thing after a draw. */
  changed: unknown;
  done(): Promise<void>;
}

function Draw({ surveyId, changed, done }: DrawProps) {
  const [by, setBy] = useState<readonly Grouping[]>(["target", "lighting"]);
  const [typed, setTyped] = useState(USUAL);
  const { busy, problem, run } = useAction();
  const risks = fractions(typed);
  const plan = useAsked(
    "GET /surveys/{survey_id}/lots/plan",
    { survey_id: surveyId, by: [...by], ...risks },
    { keep: true, also: [changed] },
  );
  const draw = () =>
    run(async () => {
      const body = { by: [...by], ...risks };
      const made = await api.write("POST /surveys/{survey_id}/lots", { survey_id: surveyId }, { body });
      setQuery({ lot: String(made[0]?.lot.id ?? "") });
      await done();
    });
  const planned = plan.data ?? [];
  return (
    <Panel
      says="lots-draw-title"
      aside={
        may("reviewer") && (
          <Button
            says="lots-draw"
            kind="primary"
            busy={busy}
            disabled={!!plan.error || !planned.some((one) => one.saves)}
            onClick={() => void draw()}
          />
        )
      }
      data-testid="lots-draw"
    >
      <div class="panel__body stack">
        <fieldset class="row row--wrap row--far">
          <legend class="field__label">{say("lots-by")}</legend>
          {GROUPINGS.map((one) => (
            <Check
              key={one}
              label={GROUPING_WORDS[one]}
              checked={by.includes(one)}
              onInput={(on) => setBy(GROUPINGS.filter((each) => (each === one ? on : by.includes(each))))}
            />
          ))}
        </fieldset>
        <div class="grid grid--4 grid--low lots__risks">
          {RISKS.map((one) => (
            <TextField
              key={one}
              label={RISK_WORDS[one]}
              value={typed[one]}
              unit="%"
              onInput={(value) => setTyped({ ...typed, [one]: value })}
            />
          ))}
        </div>
        <p class="small muted">{say("lots-nonconforming")}</p>
        <Problem error={problem ?? plan.error} />
      </div>
      {!plan.error && <Planned planned={planned} />}
    </Panel>
  );
}

function fractions(typed: Readonly<Record<Risk, string>>): Record<Risk, number> {
  const fraction = (text: string) => (parseNumber(text) ?? -100) / 100;
  return Object.fromEntries(RISKS.map((one) => [one, fraction(typed[one])])) as Record<Risk, number>;
}

function Planned({ planned }: { planned: readonly PlannedLot[] }) {
  if (planned.length === 0) return <p class="panel__body muted">{say("lots-nothing-waits")}</p>;
  return (
    <DataTable
      label={say("lots-planned")}
      scroll="tall"
      data-testid="lots-planned"
      rows={planned}
      keyOf={(one) => JSON.stringify(one.common)}
      columns={({ col, num }) => [
        col(say("lots-lot"), (one) => commonInWords(one.common)),
        num(say("lots-size"), (one) => formatCount(one.size)),
        num(say("lots-sample"), (one) => formatCount(one.sample_size)),
        num(say("lots-number"), (one) => formatCount(one.acceptance_number)),
        col(say("lots-what"), (one) =>
          one.saves ? (
            say("lots-saves", { count: one.size - one.sample_size })
          ) : (
            <span class="muted">{say("lots-saves-nothing")}</span>
          ),
        ),
      ]}
    />
  );
}

function Lots({ lots, shown }: { lots: readonly ShownLot[]; shown: ShownLot | undefined }) {
  return (
    <Panel says="page-lots">
      <DataTable
        label={say("page-lots")}
        scroll="tall"
        data-testid="lots"
        rows={lots}
        keyOf={(one) => one.lot.id}
        rowAttributes={(one) => ({ "aria-current": one === shown ? "true" : undefined })}
        columns={({ col, num, actions }) => [
          col(say("lots-lot"), (one) =>
            say("lots-named", { number: String(one.lot.number), common: commonInWords(one.lot.common) }),
          ),
          num(say("lots-size"), (one) => formatCount(one.lot.size)),
          num(
            say("lots-judged"),
            (one) => say("lots-of", { part: one.progress.judged, all: one.progress.sample }),
            "nowrap",
          ),
          num(say("lots-bad"), (one) => formatCount(one.progress.nonconforming)),
          col(say("lots-state"), (one) => LOT_STATES[one.state]),
          actions(say("table-actions"), (one) =>
            one === shown ? (
              <span class="muted">{say("computing-shown")}</span>
            ) : (
              <Button says="computing-show" small onClick={() => setQuery({ lot: String(one.lot.id) })} />
            ),
          ),
        ]}
      />
    </Panel>
  );
}
