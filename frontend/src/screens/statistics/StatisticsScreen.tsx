import { useEffect } from "preact/hooks";
import { Button, Check, Empty, Loaded, Notice, PageHead, Panel, Problem, TextField } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { Said } from "../../components/Said";
import { query } from "../../core/address";
import { fromAddress } from "../../core/api";
import { useForm } from "../../core/form";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { survey } from "../../core/survey";
import { resultsTabs } from "../../core/tabs";
import type { StatisticsBody } from "../../core/types";
import { lengthText, lengthUnit, parseLength, parseNumber } from "../../core/units";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { Differences } from "../../parts/figures/Differences";
import { loadPlot } from "../../parts/figures/PlotFigure";
import { SameRule } from "../../parts/figures/SameRule";
import { lotWords } from "../../parts/lots/words";
import { ErrorFigures } from "./ErrorFigures";
import { ErrorTable } from "./ErrorTable";
import { FilterBar } from "./FilterBar";
import { asInPaper, narrowed, setFilter, statisticsQuery, WIDE } from "./filters";
import { drawn, GroupSection, GroupsFigure } from "./GroupSection";
import { KnownErrorsTable } from "./KnownErrors";
import { type Comparison, groupWord, type Lateral, STANDARD_FOR } from "./model";
import { Standards, switchedOn } from "./Standards";
import { SpreadTable } from "./spread";
import { TargetSection } from "./TargetSection";
import "./statistics.css";

export default function StatisticsScreen() {
  const asked = statisticsQuery(query.value);
  const found = useAsked("GET /statistics", fromAddress<"GET /statistics">(asked), { keep: true });
  useEffect(() => {
    loadPlot().catch(() => null); // while the server counts; who draws tells what is wrong
  }, []);
  const data = found.data;
  const errors = query.value.get("tab") === "errors";
  const only = query.value.getAll("survey").length === 1 ? query.value.get("survey") : null;
  return (
    <div class="page page--alone page--wide stat-page">
      <PageHead
        says="page-statistics"
        more={
          <p class="page__lead" data-testid="stat-counted">
            {data ? countedWords(data, scannedHeights(only)) : say("statistics-lead")}
          </p>
        }
      >
        <div class="row stat-noprint">
          <Check
            says="results-paper"
            title={say("results-paper-help")}
            checked={asInPaper()}
            onInput={(on) => setFilter({ paper: on ? "1" : null })}
          />
          <Button says="action-print" onClick={() => window.print()} />
        </div>
      </PageHead>
      <PageTabs label={say("page-statistics")} tabs={resultsTabs(errors ? "errors" : "heights")} />
      <p class="stat-printonly small">{location.href}</p>
      {query.value.getAll("survey").map((id) => (
        <OutOfDateNotice key={id} surveyId={Number(id)} computed={found.reload} />
      ))}
      {data && (
        <Without what="time" count={data.counted.without_time} page={only && `/surveys/${only}/recordings`} />
      )}
      {data && (
        <Without what="class" count={data.counted.without_class} page={only && `/surveys/${only}/measure`} />
      )}
      {only && !narrowed(query.value) && <Conclusion key={only} surveyId={Number(only)} of={data} />}
      {only && <ByLot surveyId={Number(only)} />}
      <FilterBar found={data} />
      <Loaded of={found} what={say("statistics-loading")} />
      {data && !found.error && (
        <div class="figures-body" aria-busy={found.loading}>
          {data.counted.measurements === 0 ? (
            <Nothing found={data} surveyId={only} />
          ) : errors ? (
            <ErrorsOf found={data} />
          ) : (
            <Heights found={data} surveyId={only} reload={found.reload} />
          )}
        </div>
      )}
    </div>
  );
}

/** How many vehicles lack what a filter needs, and where it is filled in. */
function Without({ what, count, page }: { what: "time" | "class"; count: number; page: string | null }) {
  if (count === 0) return null;
  const link = (text: string) => (page ? <a href={page}>{text}</a> : text);
  return (
    <Notice kind="info">
      <Said what={`statistics-without-${what}`} values={{ count }} parts={{ link }} />
    </Notice>
  );
}

/** Said where lots were accepted: those heights were not looked at one by one. */
export function ByLot({ surveyId }: { surveyId: number }) {
  const summary = useAsked("GET /surveys/{survey_id}/lots/summary", { survey_id: surveyId });
  if (summary.error) return <Problem error={summary.error} again={summary.reload} />;
  if (!summary.data || summary.data.by_lot === 0) return null;
  return (
    <p class="small" data-testid="stat-by-lot">
      {lotWords(summary.data)}
    </p>
  );
}

interface FiguresProps {
  found: StatisticsBody;
  surveyId: string | null;
  reload: () => void;
}

function Heights({ found, surveyId, reload }: FiguresProps) {
  const standards = switchedOn(found.standards, query.value.getAll("off"));
  const shown = found.targets.filter(
    (one) => ALWAYS.includes(one.target) || found.targets.length === 1 || one.raw.n > 0,
  );
  const eye = found.targets.find((one) => one.target === "driver_eye");
  return (
    <>
      <SameRule rules={found.rules} ofChosen={found.of_chosen} />
      {shown.map((one) => (
        <TargetSection
          key={one.target}
          target={one}
          standards={standards.filter((standard) => standard.what === STANDARD_FOR[one.target])}
        />
      ))}
      {found.comparison && <ComparisonSection compared={found.comparison} />}
      <GroupSection targets={found.targets} />
      {found.lateral && <LateralSection lateral={found.lateral} />}
      <Standards standards={found.standards} surveyId={surveyId} reload={reload} />
      <SamplePlan sdM={eye?.corrected.sd_m ?? null} />
    </>
  );
}

function ErrorsOf({ found }: { found: StatisticsBody }) {
  return (
    <>
      <ErrorTable errors={found.errors} />
      <KnownErrorsTable found={found.known_errors} />
      <ErrorFigures errors={found.errors} />
    </>
  );
}

/** Shown even where nothing was measured; other targets only where something was. */
const ALWAYS: readonly string[] = ["driver_eye", "taillight"];

type LeftOut = "to_review" | "reopened" | "rejected" | "accepted" | "fixed" | "out_of_sample";

/** Accepted heights of the line scans of the survey that is open: those are counted elsewhere. */
function scannedHeights(only: string | null): number {
  return survey.value?.id === Number(only) ? survey.value.scans.heights_accepted : 0;
}

function countedWords({ counted }: StatisticsBody, scanned: number): string {
  const { measurements, vehicles, with_reference, by_size } = counted;
  const words = [
    say("statistics-counted", { measurements, vehicles, roofs: with_reference }),
    by_size > 0 ? say("statistics-by-size", { count: by_size }) : "",
  ];
  const states = Object.entries(counted.left_out).map(([state, count]) =>
    say("statistics-left-out-state", { state: state as LeftOut, count }),
  );
  if (states.length > 0) words.push(say("statistics-left-out", { states: states.join(", ") }));
  if (scanned > 0) words.push(say("statistics-of-scans", { count: scanned }));
  return words.filter(Boolean).join(" ");
}

/** No measurement is left: says which are there, and what to do. */
function Nothing({ found, surveyId }: { found: StatisticsBody; surveyId: string | null }) {
  const waiting = (found.counted.left_out["to_review"] ?? 0) + (found.counted.left_out["reopened"] ?? 0);
  const filtered = narrowed(query.value);
  return (
    <Empty
      panel
      says={waiting > 0 ? "statistics-none-accepted-title" : "statistics-none-title"}
      actions={
        <>
          {surveyId && waiting > 0 && (
            <Button says="statistics-to-review" kind="primary" href={`/surveys/${surveyId}/review`} />
          )}
          {waiting > 0 && (
            <Button says="statistics-show-to-review" onClick={() => setFilter({ state: "to_review" })} />
          )}
          {filtered && <Button says="action-clear-filter" onClick={() => setFilter(WIDE)} />}
          {surveyId && waiting === 0 && !filtered && (
            <Button says="statistics-to-measure" href={`/surveys/${surveyId}/measure`} />
          )}
        </>
      }
    >
      <p>
        {waiting > 0
          ? say("statistics-none-accepted", { count: waiting })
          : say(filtered ? "statistics-none-filtered" : "statistics-none")}
      </p>
    </Empty>
  );
}

/** How many vehicles a percentile's interval of a wanted width takes. */
export function SamplePlan({ sdM }: { sdM: number | null }) {
  const unit = lengthUnit.value;
  const shown = (metres: number) => lengthText(metres, unit, 3);
  const { values, change, field } = useForm({ percent: "10", width: shown(0.02), sd: shown(sdM ?? 0.08) });
  useEffect(() => change({ width: shown(0.02) }), [unit]);
  useEffect(() => change({ sd: shown(sdM ?? 0.08) }), [unit, sdM]);
  const [percent, width_m, sd_m] = [
    parseNumber(values.percent),
    parseLength(values.width),
    parseLength(values.sd),
  ];
  const complete = percent !== null && width_m !== null && sd_m !== null;
  const asked = complete ? { percent, width_m, sd_m } : { percent: 0, width_m: 0, sd_m: 0 };
  // an answer goes at once when something else is typed: its number is of what it was asked with
  const found = useAsked(complete ? "GET /statistics/sample-size" : null, asked);
  return (
    <Panel says="statistics-plan-title" class="stat-noprint">
      <form class="stat-plan" onSubmit={(event) => event.preventDefault()}>
        <TextField says="statistics-plan-percentile" numeric {...field("percent")} />
        <TextField says="statistics-plan-width" unit={unit} {...field("width")} />
        <TextField says="statistics-plan-sd" unit={unit} {...field("sd")} />
        <p class="stat-plan__answer" data-testid="sample-size" role="status">
          {complete ? sentenceOf(found.data?.words) : say("statistics-plan-incomplete")}
        </p>
      </form>
      {complete && <Problem error={found.error} />}
    </Panel>
  );
}

/** Where vehicles drive across the road: by lane as a figure, by lane and class as a table. */
function LateralSection({ lateral }: { lateral: Lateral }) {
  const lanes = lateral.lanes.groups;
  const curves = drawn(lanes, "lane");
  return (
    <Panel says="statistics-lateral-title" data-testid="lateral">
      <div class="grid pad stat-groups">
        <GroupsFigure
          name="lateral-position"
          title={say("statistics-lateral-figure")}
          says={say("statistics-lateral-says", { count: curves.length })}
          note={say("statistics-lateral-note")}
          groups={lanes}
          curves={curves}
          none={say("statistics-lateral-none")}
          across={["statistics-lateral-x", "across_m"]}
          by="lane"
        />
        <LanesTable lateral={lateral} />
      </div>
    </Panel>
  );
}

export function LanesTable({ lateral }: { lateral: Lateral }) {
  const all = { ...lateral.all, key: "", word: say("statistics-lateral-all") };
  const lanes = lateral.lanes.groups.flatMap((lane) => [
    { ...lane, key: lane.word, word: groupWord("lane", lane.word) },
    ...(lateral.classes[lane.word]?.groups ?? []).map((of) => ({
      ...of,
      key: `${lane.word} ${of.word}`,
      word: groupWord("category", of.word),
      within: true,
    })),
  ]);
  return (
    <SpreadTable
      label={say("statistics-lateral-title")}
      head={say("statistics-lateral-vehicles")}
      rows={[all, ...lanes]}
      percents={[5, 50, 95]}
      decimals={2}
    />
  );
}

/** Where what counts is of two surveys or years: whether they differ by more than noise. */
function ComparisonSection({ compared }: { compared: Comparison }) {
  const title = say("statistics-compared-title", {
    first: compared.first.name,
    second: compared.second.name,
  });
  return (
    <Panel label={title} data-testid="comparison">
      {compared.figures.length === 0 ? (
        <p class="stat-notes small">{say("statistics-compared-none")}</p>
      ) : (
        <Differences
          label={title}
          rows={compared.figures.map((one) => ({ ...one, low_m: one.U95_low_m, high_m: one.U95_high_m }))}
        />
      )}
      <p class="stat-notes small">{say("statistics-compared-note")}</p>
    </Panel>
  );
}

/** What came out of a survey's accepted heights, in the sentences that its report opens with. */
export function Conclusion({ surveyId, of }: { surveyId: number; of: unknown }) {
  const unit = lengthUnit.value;
  const found = useAsked(
    "GET /surveys/{survey_id}/conclusion",
    { survey_id: surveyId, unit },
    { keep: true, also: [of] },
  );
  if (found.error || !found.data) return <Problem error={found.error} again={found.reload} />;
  const [, ...rest] = found.data.sentences; // how many there are stands above
  return (
    <section
      class="panel panel__body stat-conclusion"
      aria-label={say("results-conclusion")}
      data-testid="conclusion"
    >
      <ul>
        {rest.map((one) => (
          <li key={one}>{one}</li>
        ))}
      </ul>
    </section>
  );
}
