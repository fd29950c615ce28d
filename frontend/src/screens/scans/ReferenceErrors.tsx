/** The survey's values against references, by what measured those; and the runs of each car. */
import { DataTable, Panel } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { CarRuns, RunsTogether, ScanStatistics } from "../../core/types";
import { fixed, formatSpeed } from "../../core/units";
import { vehicleName } from "../../core/words";
import { apartWords, differenceWords, QUANTITY_WORDS, SOURCE_WORDS } from "./referenceWords";
import { formatMeasured } from "./words";

export function ReferenceErrors({ found }: { found: ScanStatistics }) {
  if (found.references.length === 0) return null;
  return (
    <Panel says="motion-references-title" note={say("motion-references-note")}>
      <DataTable
        label={say("motion-references-title")}
        class="table--dense"
        data-testid="scan-reference-errors"
        rows={found.references}
        keyOf={(one) => `${one.quantity} ${one.source}`}
        columns={({ col, num }) => [
          col(
            say("motion-references-of"),
            ({ quantity, source }) =>
              say("motion-references-by", {
                quantity: QUANTITY_WORDS[quantity],
                source: source ? SOURCE_WORDS[source] : say("motion-references-all"),
              }),
            "nowrap",
          ),
          num(say("motion-references-n"), ({ errors }) => errors.n),
          num(say("motion-references-mean"), ({ quantity, errors }) =>
            differenceWords(quantity, errors.mean),
          ),
          num(say("motion-sd_m"), ({ quantity, errors }) =>
            errors.sd === null ? "–" : apartWords(quantity, errors.sd),
          ),
          num(say("motion-rmse_m"), ({ quantity, errors }) => apartWords(quantity, errors.rmse)),
          num(say("motion-references-share"), ({ errors }) => (
            <>
              {say("motion-references-within", { within: errors.within, n: errors.n })}
              <p class="small muted nowrap">
                {say("interval", { low: percent(errors.share_low), high: percent(errors.share_high) })}
              </p>
            </>
          )),
        ]}
      />
      <p class="panel__note small muted">{say("motion-references-shared")}</p>
    </Panel>
  );
}

function percent(share: number): string {
  return say("motion-references-percent", { percent: fixed(100 * share, 0) });
}

export function RunsOfCars({ found }: { found: ScanStatistics }) {
  if (found.cars.length === 0) return null;
  return (
    <Panel says="motion-cars-title" note={say("motion-cars-note")}>
      <div class="stack" data-testid="scan-cars">
        {found.cars.map((car) => (
          <Car key={car.car} car={car} />
        ))}
      </div>
    </Panel>
  );
}

const VERDICTS = wordsOf("motion-cars-", "agree", "too_far_apart", "too_alike", "too_few");

function Car({ car }: { car: CarRuns }) {
  const sizes = Object.entries(car.sizes) as ["length" | "wheelbase", RunsTogether][];
  return (
    <div>
      <div class="panel__body">
        <h3>{car.car}</h3>
        <p class="small">
          {say("motion-cars-runs", {
            count: car.runs.length,
            vehicles: car.runs.map((run) => vehicleName(run.number)).join(", "),
          })}{" "}
          {car.speed_sd_mps === null
            ? say("motion-cars-speed-one", { mean: formatSpeed(car.speed_mean_mps) })
            : say("motion-cars-speed", {
                mean: formatSpeed(car.speed_mean_mps),
                sd: formatSpeed(car.speed_sd_mps, null, 2),
              })}
        </p>
      </div>
      <DataTable
        label={say("motion-cars-table", { car: car.car })}
        class="table--dense"
        rows={sizes}
        keyOf={([size]) => size}
        columns={({ col, num }) => [
          col(say("motion-cars-size"), ([size]) => QUANTITY_WORDS[size]),
          num(say("motion-references-n"), ([, one]) => one.n),
          num(say("motion-cars-mean"), ([, one]) => formatMeasured(one.mean, one.U95_mean)),
          num(say("motion-sd_m"), ([size, one]) => (one.sd === null ? "–" : apartWords(size, one.sd))),
          num(say("motion-cars-stated"), ([size, one]) => apartWords(size, one.u_stated)),
          num(say("motion-cars-chi-square"), ([, one]) =>
            one.chi_square === null || one.p === null
              ? "–"
              : say("motion-cars-chi", {
                  chi_square: fixed(one.chi_square, 1),
                  degrees: one.degrees,
                  p: fixed(one.p, 3),
                }),
          ),
          col(say("motion-cars-says"), ([, one]) => VERDICTS[one.verdict]),
        ]}
      />
    </div>
  );
}
