/** Calibrations of a rig before: which is in force, and putting another one in force again. */
import { Button, Problem } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { telling, toast, toastProblem } from "../../core/toasts";
import type { CalibrationFigures, RigCalibrationShown, Scan } from "../../core/types";
import { formatCount, formatHeight } from "../../core/units";
import { CALIBRATED, OF_CALIBRATION, type RigChange, type RigName, rigValues } from "./rig";

/** Where the vehicles drive: without it their baseline would be the one at the cameras. */
export type Lane = { distance_m: number; u_distance_m: number };
/** Changes values of the rig, and tells whoever shows it. */
export type PutRig = (values: RigChange, version: number) => Promise<Scan>;

interface Props {
  scan: Scan;
  put: PutRig;
  onClose: () => void;
  lane: Lane | null;
}

export function RigHistory({ scan, put, onClose, lane }: Props) {
  const found = useAsked(
    "GET /scans/{scan_id}/rig-calibrations",
    { scan_id: scan.id },
    { also: [scan.version] },
  );
  if (found.error) return <Problem error={found.error} again={found.reload} />;
  if (!found.data || found.data.length === 0) return null;
  const use = async (one: RigCalibrationShown): Promise<void> => {
    await telling(async () => {
      const stored = await put({ ...calibrated(one.figures), ...lane }, scan.version);
      onClose();
      tellStored(scan, stored, OF_CALIBRATION, put);
    });
  };
  return (
    <section class="stack stack--tight" aria-label={say("scans-calibrate-history")}>
      <h3>{say("scans-calibrate-history")}</h3>
      <ul class="plain small" data-testid="rig-history">
        {found.data.map((one) => (
          <li key={one.id} class="row row--wrap">
            <span>
              {say("scans-calibrate-one", {
                number: one.revision,
                who: one.created_by?.name ?? "–",
                passes: formatCount(one.figures.passes.length),
              })}
            </span>
            <span class="nowrap">{formatHeight(one.figures.baseline_m, one.figures.U95_baseline_m, 4)}</span>
            {one.in_force ? (
              <strong>{say("scans-calibrate-in-force")}</strong>
            ) : (
              <Button
                says="scans-traffic-use"
                small
                disabled={!lane}
                label={say("scans-calibrate-use-one", { number: one.revision })}
                onClick={() => void use(one)}
              />
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

function calibrated(from: CalibrationFigures): RigChange {
  return Object.fromEntries(CALIBRATED.map((name) => [name, from[name]]));
}

/** Says that values of a rig are stored; with `put`, one press puts those before back in force. */
export function tellStored(before: Scan, stored: Scan, names: readonly RigName[], put?: PutRig): void {
  const back = async (use: PutRig): Promise<void> => {
    const now = await api.ask("GET /scans/{scan_id}", { scan_id: before.id });
    await use(rigValues(before, names), now.version);
  };
  toast(
    say(stored.counts.older > 0 ? "scans-rig-stored-older" : "scans-rig-stored"),
    put && { action: { label: say("command-undo"), run: () => void back(put).catch(toastProblem) } },
  );
}
