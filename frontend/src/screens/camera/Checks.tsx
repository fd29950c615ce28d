import { DataTable } from "../../components";
import { say } from "../../core/messages";
import type { Calibration } from "../../core/types";
import { formatAway, formatLength } from "../../core/units";
import { apart, boardInWords, halvesInWords, heldOutInWords } from "./checks";

/** What speaks for or against a calibration: two halves calibrated separately, and how flat the board was. */
export function Checks({ calibration }: { calibration: Calibration }) {
  const { cross_validation: halves, board_shape: shape } = calibration;
  if (!halves && !shape) return null;
  return (
    <section class="lens-checks" aria-label={say("camera-checks")}>
      {halves && (
        <div>
          <h3>{say("camera-halves")}</h3>
          <p>{halvesInWords(halves)}</p>
          {halves.held_out_rms_px !== null && <p>{heldOutInWords(halves)}</p>}
          {halves.height_differences.length > 0 && (
            <>
              <DataTable
                class="lens-checks__table"
                rows={halves.height_differences}
                keyOf={(d) => d.distance_m}
                columns={({ col, num }) => [
                  col(say("camera-vehicle-at"), (d) => formatAway(d.distance_m)),
                  num(say("camera-heights-differ"), (d) =>
                    d.difference_m === null ? say("camera-not-in-picture") : apart(d.difference_m),
                  ),
                  num(say("camera-expected"), (d) => apart(d.expected_m ?? null), "muted"),
                ]}
              />
              <p class="small muted">
                {say("camera-halves-note", {
                  eye: formatLength(1.16, 2),
                  camera: formatLength(1.5, 1),
                  board: formatAway(3),
                })}
              </p>
            </>
          )}
        </div>
      )}
      {shape && (
        <div>
          <h3>{say("camera-flatness")}</h3>
          <p>{boardInWords(shape)}</p>
        </div>
      )}
    </section>
  );
}
