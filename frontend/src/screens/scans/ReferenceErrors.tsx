/** The survey's values against references, by what measured those; and the runs of each car. */
import { num, Panel, Table } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { CarRuns, ReferenceGroup, RunsTogether, ScanStatistics } from "../../core/types";
import { fixed, formatSpeed } from "../../core/units";
import { vehicleName } from "../../core/words";
import { apartWords, differenceWords, QUANTITY_WORDS, SOURCE_WORDS } from "./referenceWords";
import { formatMeasured } from "./words";

export function ReferenceErrors({ found }: { found: ScanStatistics }) {
  if (found.references.length === 0) return null;
  return (
    <Panel title={say("motion-references-title")} note={say("motion-references-note")}>
      <Table
        label={say("motion-references-title")}
        data-testid="scan-reference-errors"
        heads={[
          say("motion-references-of"),
          num(say("motion-references-n")),
          num(say("motion-references-mean")),
          num(say("motion-sd")),
          num(say("motion-rmse")),
          num(say("motion-references-share")),
        ]}
      >
        {found.references.map((one) => (
          <Group key={`${one.quantity} ${one.source}`} one={one} />
        ))}
      </Table>
      <p class="panel__body small muted">{say("motion-references-shared")}</p>
    </Panel>
  );
}

function Group({ one: { quantity, source, errors } }: { one: ReferenceGroup }) {
  return (
    <tr>
      <td>
        {say("motion-references-by", {
          quantity: QUANTITY_WORDS[quantity],
          source: source ? SOURCE_WORDS[source] : say("motion-references-all"),
        })}
      </td>
      <td class="num">{errors.n}</td>
      <td class="num">{differenceWords(quantity, errors.mean)}</td>
      <td class="num">{errors.sd === null ? "–" : apartWords(quantity, errors.sd)}</td>
      <td class="num">{apartWords(quantity, errors.rmse)}</td>
      <td class="num">
        {say("motion-references-within", { within: errors.within, n: errors.n })}
        <p class="small muted nowrap">
          {say("interval", { low: percent(errors.share_low), high: percent(errors.share_high) })}
        </p>
      </td>
    </tr>
  );
}

function percent(share: number): string {
  return say("motion-references-percent", { percent: fixed(100 * share, 0) });
}

export function RunsOfCars({ found }: { found: ScanStatistics }) {
  if (found.cars.length === 0) return null;
  return (
    <Panel title={say("motion-cars-title")} note={say("motion-cars-note")}>
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
      <Table
        label={say("motion-cars-table", { car: car.car })}
        heads={[
          say("motion-cars-size"),
          num(say("motion-references-n")),
          num(say("motion-cars-mean")),
          num(say("motion-sd")),
          num(say("motion-cars-stated")),
          num(say("motion-cars-chi-square")),
          say("motion-cars-says"),
        ]}
      >
        {sizes.map(([size, one]) => (
          <Size key={size} size={size} one={one} />
        ))}
      </Table>
    </div>
  );
}

function Size({ size, one }: { size: "length" | "wheelbase"; one: RunsTogether }) {
  return (
    <tr>
      <td>{QUANTITY_WORDS[size]}</td>
      <td class="num">{one.n}</td>
      <td class="num">{formatMeasured(one.mean, one.U95_mean)}</td>
      <td class="num">{one.sd === null ? "–" : apartWords(size, one.sd)}</td>
      <td class="num">{apartWords(size, one.u_stated)}</td>
      <td class="num">
        {one.chi_square === null || one.p === null
          ? "–"
          : say("motion-cars-chi", {
              chi_square: fixed(one.chi_square, 1),
              degrees: one.degrees,
              p: fixed(one.p, 3),
            })}
      </td>
      <td>{VERDICTS[one.verdict]}</td>
    </tr>
  );
}
