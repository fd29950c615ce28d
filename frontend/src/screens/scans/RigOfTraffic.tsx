/** What the vehicles say of the rig, beside what is in force. Nothing changes unless somebody takes a value over. */

import { Button, Loading, Notice, Problem, TableScroll } from "../../components";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { may } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { fixed, formatLength, lengthUnit, plural } from "../../core/units";
import { type RigOfTraffic as Found, type RigTyped, typedLength } from "./rig";

interface Props {
  scan: Scan;
  /** Offers a value: it is filled in, and stored by whoever agrees. */
  use: (part: Partial<RigTyped>) => void;
  /** Leave out what is in force: the fields above it say that. */
  narrow?: boolean;
  /** The cameras were exchanged, and the vehicles are looked for again. */
  changed: () => Promise<void>;
}

/** Exchanged on the server, where the search starts again; one press takes it back. */
async function swapCameras({ id }: Pick<Scan, "id">, changed: () => Promise<void>): Promise<void> {
  try {
    const { version } = await api.ask("GET /scans/{scan_id}", { scan_id: id });
    await api.write("POST /scans/{scan_id}/swap", { scan_id: id }, { body: { version } });
    await changed();
    toast("The cameras were exchanged; the vehicles are being found again.", {
      action: { label: "Undo", run: () => void swapCameras({ id }, changed) },
    });
  } catch (error) {
    toastProblem(error);
  }
}

export function RigOfTraffic({ scan, use, narrow, changed }: Props) {
  const found = useResource(
    (signal) => api.ask("GET /scans/{scan_id}/rig-of-traffic", { scan_id: scan.id }, { signal }),
    [scan.id, scan.version],
  );
  if (found.error) return <Problem error={found.error} again={found.reload} />;
  if (!found.data) return <Loading what="what the traffic says" />;
  return <Told found={found.data} scan={scan} use={use} narrow={narrow} changed={changed} />;
}

function Told({ found, scan, use, narrow, changed }: Props & { found: Found }) {
  const { rig } = scan;
  const { misalignment, gain } = found;
  const words = [misalignment.warning, ...found.baselines.map((one) => one.words)].filter(Boolean);
  return (
    <div class="stack stack--tight" data-testid="rig-of-traffic">
      {found.order && (
        <Notice
          kind="warning"
          actions={
            may("operator") && (
              <Button small onClick={() => void swapCameras(scan, changed)}>
                Swap the cameras
              </Button>
            )
          }
        >
          {found.order}
        </Notice>
      )}
      <TableScroll label="The rig as the traffic says it">
        <table class={narrow ? "table table--dense" : "table"}>
          <thead>
            <tr>
              <th>the traffic says</th>
              <th class="num">value ± u</th>
              <th class="num">from</th>
              {!narrow && <th class="num">in force</th>}
              <th>
                <span class="visually-hidden">take it over</span>
              </th>
            </tr>
          </thead>
          <tbody>
            <Row
              what="Misalignment"
              value={pair(misalignment.value, misalignment.u, 3, "px")}
              n={misalignment.n}
              inForce={
                narrow
                  ? null
                  : rig.misalignment_px === null
                    ? "from the traffic"
                    : (pair(rig.misalignment_px, rig.u_misalignment_px, 3, "px") ?? "–")
              }
              reason={misalignment.reason}
              use={() =>
                use({
                  misalignment: fixed(misalignment.value ?? 0, 4),
                  uMisalignment: fixed(misalignment.u ?? 0, 4),
                })
              }
            />
            <Row
              what="Light, camera 2 over 1"
              value={pair(gain.value, gain.u, 3)}
              n={gain.n}
              inForce={narrow ? null : "each vehicle’s own"}
              reason={gain.reason}
            />
            {found.baselines.map((one) => (
              <Row
                key={one.of}
                what={`Baseline by ${one.of}s`}
                value={
                  one.baseline_m === null || one.u_baseline_m === null
                    ? null
                    : length(one.baseline_m, one.u_baseline_m)
                }
                n={one.ratio.n}
                inForce={narrow ? null : length(rig.baseline_m, rig.u_baseline_m)}
                reason={one.ratio.reason}
                use={
                  one.differs
                    ? () =>
                        use({
                          baseline: typedLength(one.baseline_m ?? 0, 5),
                          uBaseline: typedLength(one.u_baseline_m ?? 0, 5),
                        })
                    : undefined
                }
              />
            ))}
          </tbody>
        </table>
      </TableScroll>
      {words.map((one) => (
        <p key={one} class="small muted">
          {one}
        </p>
      ))}
      <p class="small muted">
        ± u is the standard uncertainty. Nothing here is in force by itself: “Use…” fills it in, and you store
        it.
      </p>
    </div>
  );
}

interface RowProps {
  what: string;
  value: string | null;
  n: number;
  inForce: string | null;
  reason: string | null;
  use?: () => void;
}

function Row({ what, value, n, inForce, reason, use }: RowProps) {
  return (
    <tr>
      <th scope="row">{what}</th>
      {value === null ? (
        <td colSpan={2} class="small muted">
          {reason}
        </td>
      ) : (
        <>
          <td class="num">{value}</td>
          <td class="num">{plural(n, "vehicle")}</td>
        </>
      )}
      {inForce !== null && <td class="num">{inForce}</td>}
      <td class="num">
        {use && value !== null && may("operator") && (
          <Button small label={`Use this for ${what}`} onClick={use}>
            Use…
          </Button>
        )}
      </td>
    </tr>
  );
}

const NBSP = "\u00a0";

function pair(value: number | null, u: number | null, digits: number, unit = ""): string | null {
  if (value === null || u === null) return null;
  return `${fixed(value, digits)}${NBSP}±${NBSP}${fixed(u, digits)}${unit && NBSP}${unit}`;
}

function length(metres: number, u_m: number): string {
  return `${typedLength(metres)}${NBSP}±${NBSP}${formatLength(u_m, 4, lengthUnit.value)}`;
}
