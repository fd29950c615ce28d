/** What the vehicles say of the rig, beside what is in force. Nothing changes unless somebody takes a value over. */
import { Button, DataTable, Loaded, Notice } from "../../components";
import { api } from "../../core/api";
import { type Said, say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { telling, toast } from "../../core/toasts";
import type { Scan } from "../../core/types";
import { fixed, formatCount, formatLength, lengthUnit } from "../../core/units";
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

/** A value that the traffic says of the rig; null: none, and why. */
interface Told {
  what: string;
  value: string | null;
  reason: Said | null;
  n: number;
  inForce: string;
  use?: (() => void) | undefined;
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
  const rows: Told[] = [
    {
      ...misalignment,
      what: say("scans-rig-misalignment"),
      value: pixels(misalignment.value, misalignment.u),
      inForce:
        rig.misalignment_px === null
          ? say("scans-rig-from-traffic")
          : (pixels(rig.misalignment_px, rig.u_misalignment_px) ?? "–"),
      use: () =>
        use({
          misalignment: fixed(misalignment.value ?? 0, 4),
          uMisalignment: fixed(misalignment.u ?? 0, 4),
        }),
    },
    {
      ...gain,
      what: say("scans-traffic-gain"),
      value: withU(gain.value, gain.u),
      inForce: say("scans-traffic-gain-own"),
    },
    ...baselines.map(({ of, ratio, differs, baseline_m, u_baseline_m }) => ({
      ...ratio,
      what: say("scans-traffic-baseline", { of }),
      value: baseline_m === null || u_baseline_m === null ? null : length(baseline_m, u_baseline_m),
      inForce: length(rig.baseline_m, rig.u_baseline_m),
      use: differs
        ? () =>
            use({
              baseline: typedLength(baseline_m ?? 0, 5),
              uBaseline: typedLength(u_baseline_m ?? 0, 5),
            })
        : undefined,
    })),
  ];
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
      <DataTable
        label={say("scans-traffic-table")}
        class="table--dense"
        rows={rows}
        keyOf={(one) => one.what}
        columns={({ num, rowHead, actions, across }) => [
          rowHead(say("scans-traffic-says"), (one) => one.what),
          ...across(
            (one) => (one.value === null ? sentenceOf(one.reason) : undefined),
            undefined,
            num(say("scans-traffic-value"), (one) => one.value),
            num(say("scans-traffic-from"), (one) => formatCount(one.n)),
          ),
          ...(narrow ? [] : [num(say("scans-traffic-in-force"), (one) => one.inForce)]),
          actions(
            say("scans-traffic-take"),
            ({ what, value, use }) =>
              use &&
              value !== null &&
              may("operator") && (
                <Button
                  says="scans-traffic-use"
                  small
                  label={say("scans-traffic-use-for", { what })}
                  onClick={use}
                />
              ),
            "num",
          ),
        ]}
      />
      {words.map((one) => (
        <p key={one} class="small muted">
          {one}
        </p>
      ))}
      <p class="small muted">{say("scans-traffic-note")}</p>
    </div>
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
