/** What the vehicles say of the rig, beside what is in force. Nothing changes unless somebody takes a value over. */
import { Button, Loaded, Notice, num, Table } from "../../components";
import { api } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { telling, toast } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { fixed, formatLength, lengthUnit } from "../../core/units";
import { type RigTyped, typedLength } from "./rig";

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
  await telling(async () => {
    const { version } = await api.ask("GET /scans/{scan_id}", { scan_id: id });
    await api.write("POST /scans/{scan_id}/swap", { scan_id: id }, { body: { version } });
    await changed();
    toast(say("scans-traffic-swapped"), {
      action: { label: say("command-undo"), run: () => void swapCameras({ id }, changed) },
    });
  });
}

export function RigOfTraffic({ scan, use, narrow, changed }: Props) {
  const found = useAsked(
    "GET /scans/{scan_id}/rig-of-traffic",
    { scan_id: scan.id },
    { also: [scan.version] },
  );
  if (found.error || !found.data) return <Loaded of={found} what={say("scans-traffic-loading")} />;
  const { rig } = scan;
  const { misalignment, gain, baselines, order } = found.data;
  const words = [misalignment.warning, ...baselines.map((one) => one.words)].flatMap(
    (one) => sentenceOf(one) ?? [],
  );
  return (
    <div class="stack stack--tight" data-testid="rig-of-traffic">
      {order && (
        <Notice
          kind="warning"
          actions={
            may("operator") && (
              <Button says="scans-traffic-swap" small onClick={() => void swapCameras(scan, changed)} />
            )
          }
        >
          {sentenceOf(order)}
        </Notice>
      )}
      <Table
        label={say("scans-traffic-table")}
        class={narrow ? "table--dense" : undefined}
        heads={[
          say("scans-traffic-says"),
          num(say("scans-traffic-value")),
          num(say("scans-traffic-from")),
          ...(narrow ? [] : [num(say("scans-traffic-in-force"))]),
          <span class="visually-hidden">{say("scans-traffic-take")}</span>,
        ]}
      >
        <Row
          what={say("scans-rig-misalignment")}
          value={pixels(misalignment.value, misalignment.u)}
          n={misalignment.n}
          inForce={
            narrow
              ? null
              : rig.misalignment_px === null
                ? say("scans-rig-from-traffic")
                : (pixels(rig.misalignment_px, rig.u_misalignment_px) ?? "–")
          }
          reason={sentenceOf(misalignment.reason)}
          use={() =>
            use({
              misalignment: fixed(misalignment.value ?? 0, 4),
              uMisalignment: fixed(misalignment.u ?? 0, 4),
            })
          }
        />
        <Row
          what={say("scans-traffic-gain")}
          value={withU(gain.value, gain.u)}
          n={gain.n}
          inForce={narrow ? null : say("scans-traffic-gain-own")}
          reason={sentenceOf(gain.reason)}
        />
        {baselines.map((one) => (
          <Row
            key={one.of}
            what={say("scans-traffic-baseline", { of: one.of })}
            value={
              one.baseline_m === null || one.u_baseline_m === null
                ? null
                : length(one.baseline_m, one.u_baseline_m)
            }
            n={one.ratio.n}
            inForce={narrow ? null : length(rig.baseline_m, rig.u_baseline_m)}
            reason={sentenceOf(one.ratio.reason)}
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
      </Table>
      {words.map((one) => (
        <p key={one} class="small muted">
          {one}
        </p>
      ))}
      <p class="small muted">{say("scans-traffic-note")}</p>
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
          <td class="num">{say("scans-count-vehicles", { count: n })}</td>
        </>
      )}
      {inForce !== null && <td class="num">{inForce}</td>}
      <td class="num">
        {use && value !== null && may("operator") && (
          <Button
            says="scans-traffic-use"
            small
            label={say("scans-traffic-use-for", { what })}
            onClick={use}
          />
        )}
      </td>
    </tr>
  );
}

function withU(value: number | null, u: number | null): string | null {
  return value === null || u === null ? null : say("with-u", { value: fixed(value, 3), u: fixed(u, 3) });
}

function pixels(value: number | null, u: number | null): string | null {
  if (value === null || u === null) return null;
  const px = (of: number) => say("value-px", { value: fixed(of, 3) });
  return say("with-u", { value: px(value), u: px(u) });
}

function length(metres: number, u_m: number): string {
  const unit = lengthUnit.value;
  return say("with-u", { value: formatLength(metres, 4, unit), u: formatLength(u_m, 4, unit) });
}
