/** What passes of a staff or board say of the rig: its figures, how well each pass agrees, and the rows that were refused. */
import { DataTable, Facts, Notice } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { CalibrationFigures, CalibrationLook } from "../../core/types";
import { fixed, formatHeight, formatLength, formatSmall } from "../../core/units";

export function RigAnswer({ look }: { look: CalibrationLook }) {
  const { figures } = look;
  return (
    <section class="stack stack--tight" aria-label={say("scans-calibrate-answer")} data-testid="rig-answer">
      {look.reason && <Notice kind="warning">{sentenceOf(look.reason)}</Notice>}
      {figures && <FiguresOf figures={figures} />}
      {figures && <Residuals figures={figures} />}
      {look.refused.length > 0 && (
        <ul class="small">
          {look.refused.map((one) => (
            <li key={one.row}>
              {say("scans-passes-refused", { row: one.row })} <span>{sentenceOf(one.reason)}</span>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function FiguresOf({ figures }: { figures: CalibrationFigures }) {
  const lanes = figures.lanes.length > 0 ? figures.lanes : figures.lane ? [figures.lane] : [];
  const mrad = (value: number) => fixed(1000 * value, 3);
  return (
    <>
      <Facts
        small
        of={[
          ...lanes.map(
            (lane) =>
              [
                <>
                  {say("scans-calibrate-lane", { distance: formatLength(lane.distance_m, 2) })}
                  {lane.name && ` (${lane.name})`}
                </>,
                <>
                  {formatHeight(lane.baseline_m, lane.U95_baseline_m, 4)}{" "}
                  <span class="muted">
                    {say("scans-calibrate-share", { percent: fixed(lane.U95_percent, 3) })}
                  </span>
                </>,
              ] as const,
          ),
          [say("scans-calibrate-baseline"), formatHeight(figures.baseline_m, figures.U95_baseline_m, 4)],
          [
            say("scans-rig-divergence"),
            say("scans-calibrate-mrad", {
              value: mrad(figures.divergence_rad),
              U95: mrad(figures.U95_divergence_rad),
            }),
          ],
          [say("scans-rig-correlation"), fixed(figures.baseline_correlation, 3)],
          [
            say("scans-calibrate-agree"),
            say("scans-calibrate-chi2", {
              chi2: fixed(figures.chi2, 1),
              degrees: figures.degrees_of_freedom,
              percent: fixed(100 * figures.p_value, 1),
            }),
          ],
        ]}
      />
      {[...lanes.map((one) => one.warning), ...figures.warnings]
        .map(sentenceOf)
        .map((one) => one && <Notice key={one}>{one}</Notice>)}
    </>
  );
}

function Residuals({ figures }: { figures: CalibrationFigures }) {
  return (
    <DataTable
      label={say("scans-calibrate-passes")}
      scroll="scan__lines"
      class="table--dense"
      rows={figures.passes}
      keyOf={(one) => one.name}
      columns={({ col, num }) => [
        col(say("scans-passes-number"), (one) => one.name),
        num(say("scans-passes-distance-shown"), (one) => formatLength(one.distance_m, 2)),
        num(say("scans-calibrate-span"), (one) =>
          say("with-u", { value: formatLength(one.span_m, 4), u: formatLength(one.u_span_m, 4) }),
        ),
        num(say("scans-calibrate-residual"), (one) => formatSmall(one.residual_m)),
      ]}
    />
  );
}
