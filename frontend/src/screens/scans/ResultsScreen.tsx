/** What the line scans of a survey say together: errors against known sizes, distributions, the paper's table. */
import { useState } from "preact/hooks";
import { Button, Empty, Loading, Notice, Problem, Segments } from "../../components";
import { api } from "../../core/api";
import type { ScreenProps } from "../../core/places";
import { useResource } from "../../core/resource";
import { plural } from "../../core/units";
import { SizeErrors } from "./SizeErrors";
import { SpreadFigure } from "./SpreadFigure";
import { TableOne } from "./TableOne";
import "./scan.css";

type Which = "accepted" | "all";

export default function ResultsScreen({ surveyId }: ScreenProps) {
  const [which, setWhich] = useState<Which>("accepted");
  const found = useResource(
    (signal) =>
      api.ask(
        "GET /surveys/{survey_id}/scan-statistics",
        { survey_id: surveyId, accepted_only: which === "accepted" },
        { signal },
      ),
    [surveyId, which],
  );
  const data = found.data;
  const vehicles = data?.table.length ?? 0;
  return (
    <div class="page">
      <header class="page__head">
        <div>
          <h1>Motion of the vehicles</h1>
          <p class="page__lead">
            Speeds, gaps and lengths of every line scan of this survey, and how far known sizes are met.
          </p>
        </div>
        <div class="row row--wrap">
          <Segments
            label="Which vehicles count"
            value={which}
            options={[
              { value: "accepted", label: "accepted" },
              { value: "all", label: "those to review too" },
            ]}
            onChange={setWhich}
          />
          <Button href={`/surveys/${surveyId}/scans`}>All line scans</Button>
        </div>
      </header>
      <Problem error={found.error} again={found.reload} />
      {!data && found.loading && <Loading what="the statistics" />}
      {data && vehicles === 0 && (
        <div class="panel">
          <Empty title={which === "accepted" ? "No vehicle is accepted yet" : "No vehicle is measured yet"}>
            <p>
              {which === "accepted"
                ? "Review some on the bench, or let those that wait for a review count too."
                : "Add a line scan and let its vehicles be found."}
            </p>
          </Empty>
        </div>
      )}
      {data && vehicles > 0 && (
        <div class="stack">
          <p class="small muted" data-testid="scan-counted">
            {plural(vehicles, "vehicle")} of {plural(data.scans, "line scan")}.
          </p>
          <SizeErrors found={data} />
          {[data.length_ratio, data.wheelbase_ratio].map(
            (one, n) =>
              one.warning && (
                <Notice key={n} kind="warning" title={n === 0 ? "By lengths" : "By wheelbases"}>
                  {one.warning}
                </Notice>
              ),
          )}
          <div class="scan-figures">
            {data.spreads.map((spread) => (
              <SpreadFigure key={spread.quantity} spread={spread} />
            ))}
          </div>
          <TableOne found={data} />
        </div>
      )}
    </div>
  );
}
