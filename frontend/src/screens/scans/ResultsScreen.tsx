/** What the line scans of a survey say together: errors against known sizes, distributions, the paper's table. */
import { useState } from "preact/hooks";
import { Button, choices, Empty, Loaded, Notice, PageHead, Segments } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { linkTo, Said } from "../../components/Said";
import { query, setQuery } from "../../core/address";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked } from "../../core/resource";
import { resultsTabs } from "../../core/tabs";
import { FilmedFields, filmedOf } from "../../parts/filming/FilmedFields";
import { countedWords } from "./counted";
import { ReferenceErrors, RunsOfCars } from "./ReferenceErrors";
import { ScannedHeights } from "./ScannedHeights";
import { SizeErrors } from "./SizeErrors";
import { SpreadFigure } from "./SpreadFigure";
import { TableOne } from "./TableOne";
import { Traffic } from "./Traffic";
import "./scan.css";

type Which = "accepted" | "all";

export default function ResultsScreen({ surveyId }: ScreenProps) {
  const [which, setWhich] = useState<Which>("accepted");
  const filmed = filmedOf(query.value);
  const found = useAsked("GET /surveys/{survey_id}/scan-statistics", {
    survey_id: surveyId,
    accepted_only: which === "accepted",
    ...filmed,
  });
  const limited = Object.values(filmed).some((one) => one !== null);
  const data = found.data;
  const vehicles = data?.table.length ?? 0;
  return (
    <div class="page page--alone page--wide">
      <PageHead says="page-scan-results" lead={say("motion-lead")}>
        <div class="row row--wrap">
          <Segments
            says="motion-which"
            value={which}
            options={choices(wordsOf("motion-which-", "accepted", "all"))}
            onInput={setWhich}
          />
          <Button says="scans-all" href={`/surveys/${surveyId}/scans`} />
        </div>
      </PageHead>
      <PageTabs label={say("page-statistics")} tabs={resultsTabs("scan-results")} />
      <details class="panel panel__body more" open={limited}>
        <summary>{say("motion-filter")}</summary>
        <div class="grid grid--4">
          <FilmedFields value={filmed} onChange={setQuery} />
        </div>
      </details>
      {data && (data.counted["without_time"] ?? 0) > 0 && (
        <Notice kind="info">
          <Said
            what="motion-without-time"
            values={{ count: data.counted["without_time"] ?? 0 }}
            parts={linkTo(`/surveys/${surveyId}/scans`)}
          />
        </Notice>
      )}
      <Loaded of={found} what={say("motion-loading")} />
      {data && vehicles === 0 && limited && <Empty panel says="motion-none-filmed" />}
      {data && vehicles === 0 && !limited && (
        <Empty
          panel
          says={which === "accepted" ? "motion-none-accepted-title" : "motion-none-title"}
          why={which === "accepted" ? "motion-none-accepted" : "motion-none"}
        />
      )}
      {data && vehicles > 0 && (
        <p class="small muted" data-testid="scan-counted">
          {countedWords(data, which === "accepted")}
        </p>
      )}
      {data && data.counted["vehicles"] !== 0 && (
        <Traffic surveyId={surveyId} acceptedOnly={which === "accepted"} filmed={filmed} />
      )}
      {data && vehicles > 0 && (
        <div class="stack">
          <div class="grid grid--fit scan-figures" style={{ "--least": "420px" }}>
            {data.spreads.map((spread) => (
              <SpreadFigure key={spread.quantity} spread={spread} />
            ))}
          </div>
          <SizeErrors found={data} />
          {[data.length_ratio, data.wheelbase_ratio].map(
            (one, n) =>
              one.warning && (
                <Notice
                  key={n}
                  kind="warning"
                  title={say(n === 0 ? "motion-by-lengths" : "motion-by-wheelbases")}
                >
                  {sentenceOf(one.warning)}
                </Notice>
              ),
          )}
          <RunsOfCars found={data} />
          <ReferenceErrors found={data} />
        </div>
      )}
      {data && data.heights.length > 0 && <ScannedHeights heights={data.heights} />}
      {data && vehicles > 0 && <TableOne found={data} />}
    </div>
  );
}
