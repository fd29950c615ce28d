/** Errors against known heights and the distributions of what was measured, for the measurements a filter leaves. */
import { useEffect } from "preact/hooks";
import { Button, Check, Empty, Loaded, Notice, PageHead } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { Said } from "../../components/Said";
import { query } from "../../core/address";
import { fromAddress } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { survey } from "../../core/survey";
import { resultsTabs } from "../../core/tabs";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { loadPlot } from "../../parts/figures/PlotFigure";
import { SameRule } from "../../parts/figures/SameRule";
import { lotWords } from "../../parts/lots/words";
import { ComparisonSection } from "./ComparisonSection";
import { Conclusion } from "./Conclusion";
import { ErrorFigures } from "./ErrorFigures";
import { ErrorTable } from "./ErrorTable";
import { FilterBar } from "./FilterBar";
import { asInPaper, narrowed, setFilter, statisticsQuery, WIDE } from "./filters";
import { GroupSection } from "./GroupSection";
import { KnownErrorsTable } from "./KnownErrors";
import { LateralSection } from "./LateralSection";
import { STANDARD_FOR, type Statistics } from "./model";
import { SamplePlan } from "./SamplePlan";
import { Standards, switchedOn } from "./Standards";
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
    <div class="page page--alone stat-page">
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
      {data && data.counted.without_time > 0 && (
        <Notice kind="info">
          <Said
            what="statistics-without-time"
            values={{ count: data.counted.without_time }}
            parts={{ link: (text) => (only ? <a href={`/surveys/${only}/recordings`}>{text}</a> : text) }}
          />
        </Notice>
      )}
      {data && data.counted.without_class > 0 && (
        <Notice kind="info">
          <Said
            what="statistics-without-class"
            values={{ count: data.counted.without_class }}
            parts={{ link: (text) => (only ? <a href={`/surveys/${only}/measure`}>{text}</a> : text) }}
          />
        </Notice>
      )}
      {only && !narrowed(query.value) && <Conclusion surveyId={Number(only)} of={data} />}
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

/** Said where lots were accepted: those heights were not looked at one by one. */
function ByLot({ surveyId }: { surveyId: number }) {
  const summary = useAsked("GET /surveys/{survey_id}/lots/summary", { survey_id: surveyId });
  if (!summary.data || summary.data.by_lot === 0) return null;
  return (
    <p class="small" data-testid="stat-by-lot">
      {lotWords(summary.data)}
    </p>
  );
}

interface FiguresProps {
  found: Statistics;
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

function ErrorsOf({ found }: { found: Statistics }) {
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

function countedWords({ counted }: Statistics, scanned: number): string {
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
function Nothing({ found, surveyId }: { found: Statistics; surveyId: string | null }) {
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
