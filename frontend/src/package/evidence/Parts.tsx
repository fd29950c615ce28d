/** What the file says, part by part; every number as it stands there. */
import { fixed } from "../digits";
import { decimal, told } from "../language";
import { Facts, Grid, Section } from "../Section";
import { say } from "../say";
import type { AuditEvent, Evidence, Measured } from "./document";

const KMH = 3.6;
const NONE = "–";

/** A number with as many decimals as two digits of its uncertainty need, and the uncertainty itself. */
function withU(value: number | null, u: number | null, unit: string): string {
  if (value === null) return NONE;
  if (u === null || !(u > 0)) return `${decimal(String(value))}\u00a0${unit}`;
  const decimals = Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(u))));
  return say("opened-evidence-with-u", { value: fixed(value, decimals), u: fixed(u, decimals), unit });
}

const times = (value: number | null, factor: number) => (value === null ? null : value * factor);

export function Decision({ evidence }: { evidence: Evidence }) {
  const { answer, words, rule } = evidence.decision;
  return (
    <Section id="decision" name={say("opened-evidence-decision")}>
      <p class="evidence__decision" data-answer={answer ?? "none"}>
        {told(words)}
      </p>
      {rule?.source && <p>{say("opened-evidence-rule-source", { source: rule.source })}</p>}
      <p class="opened__quiet">{say("opened-evidence-decision-note")}</p>
    </Section>
  );
}

export function Motion({ evidence }: { evidence: Evidence }) {
  const m = evidence.measurement;
  const { review, words } = evidence;
  const u = m.u_speed_mps;
  return (
    <Section id="motion" name={say("opened-evidence-motion")}>
      {words.reason && <p>{told(words.reason)}</p>}
      {words.warnings.map((one) => (
        <p key={one}>{told(one)}</p>
      ))}
      <div class="opened__scroll">
        <Facts
          rows={[
            [
              say("opened-evidence-speed"),
              say("opened-evidence-pair", {
                first: withU(times(m.speed_mps, KMH), times(u, KMH), "km/h"),
                second: withU(m.speed_mps, u, "m/s"),
              }),
            ],
            [say("opened-evidence-acceleration"), withU(m.acceleration_mps2, m.u_acceleration_mps2, "m/s²")],
            [say("opened-evidence-length"), withU(m.length_m, m.u_length_m, "m")],
            [
              say("opened-evidence-direction"),
              say("opened-evidence-direction-of", { direction: m.direction }),
            ],
            ...laneRow(m),
            [say("opened-evidence-axles"), axleWords(m)],
            [say("opened-evidence-lines-1"), pair(m.front_line_1, m.rear_line_1)],
            [say("opened-evidence-lines-2"), pair(m.front_line_2, m.rear_line_2)],
            [say("opened-evidence-time-gap"), gapWords(evidence, "time_gap_s", "s")],
            [say("opened-evidence-distance-gap"), gapWords(evidence, "distance_gap_m", "m")],
            [say("opened-evidence-method"), methodWords(m)],
            [say("opened-evidence-review"), reviewWords(review)],
          ]}
        />
      </div>
    </Section>
  );
}

const pair = (front: number, rear: number) =>
  say("opened-evidence-pair", { first: fixed(front, 2), second: fixed(rear, 2) });

/** None where the rig has no lanes. */
function laneRow({ lane, rig }: Measured): [string, string][] {
  if (!rig.lanes?.length) return [];
  return [[say("opened-evidence-lane"), lane ?? say("opened-evidence-lane-unknown")]];
}

function axleWords({ axle_lines, axles_by }: Measured): string {
  if (!axle_lines?.length) return NONE;
  return say("opened-evidence-axles-of", { count: axle_lines.length, by: axles_by ?? "machine" });
}

function gapWords({ gap, words }: Evidence, name: "time_gap_s" | "distance_gap_m", unit: string): string {
  if (gap === null) return say("opened-evidence-gap-none");
  return gap[name] === null ? told(words.gap ?? NONE) : withU(gap[name], gap[`u_${name}`], unit);
}

function methodWords(m: Measured): string {
  return say(m.placed_by === null ? "opened-evidence-found" : "opened-evidence-placed", {
    method: m.method,
    revision: String(m.revision),
    at: m.created_at.slice(0, 19).replace("T", " "),
    version: m.code_version,
  });
}

function reviewWords({ verdict, reviewer, at, reason }: Evidence["review"]): string {
  const by = reviewer?.name ?? say("opened-evidence-nobody");
  const words = say("opened-evidence-verdict", {
    verdict,
    by,
    at: (at ?? "").slice(0, 19).replace("T", " "),
  });
  return reason ? `${words} ${reason}` : words;
}

export function Budget({ measured }: { measured: Measured }) {
  if (measured.budget.length === 0) return null;
  return (
    <Section id="budget" name={say("opened-evidence-budget")}>
      <p class="opened__quiet">{say("opened-evidence-budget-note")}</p>
      <Grid
        heads={[
          say("opened-evidence-source"),
          say("opened-evidence-u-speed"),
          say("opened-evidence-u-acceleration"),
          say("opened-evidence-u-length"),
        ]}
      >
        {measured.budget.map((one) => (
          <tr key={one.source}>
            <th scope="row">{told(one.source)}</th>
            <td>{fixed(one.u_speed_mps, 5)}</td>
            <td>{fixed(one.u_acceleration_mps2, 5)}</td>
            <td>{fixed(one.u_length_m, 5)}</td>
          </tr>
        ))}
        <tr>
          <th scope="row">{say("opened-evidence-combined")}</th>
          {[measured.u_speed_mps, measured.u_acceleration_mps2, measured.u_length_m].map((u, n) => (
            <td key={n}>{u === null ? NONE : fixed(u, 5)}</td>
          ))}
        </tr>
      </Grid>
    </Section>
  );
}

export function Times({ evidence }: { evidence: Evidence }) {
  const { time, clock } = evidence;
  const rows: [string, string][] = [];
  if (clock) {
    const at = time.filmed_at ?? NONE;
    const u = time.u_filmed_at_s;
    rows.push([
      say("opened-evidence-passed"),
      u === null
        ? at
        : say("opened-evidence-passed-u", { at, u_s: decimal(String(Number(u.toPrecision(2)))) }),
    ]);
    rows.push([
      say("opened-evidence-start"),
      say("opened-evidence-start-u", {
        at: clock.started_at,
        zone: clock.time_zone,
        u_s: decimal(String(clock.u_start_s)),
      }),
    ]);
  }
  rows.push([say("opened-evidence-since"), `${fixed(time.since_start_s, 4)}\u00a0s`]);
  return (
    <Section id="time" name={say("opened-evidence-time")}>
      {clock === null && <p>{say("opened-evidence-clock-none")}</p>}
      <Facts rows={rows} />
    </Section>
  );
}

export function Rig({ evidence }: { evidence: Evidence }) {
  const { rig } = evidence.measurement;
  const at = evidence.at_vehicle;
  const { scan } = evidence;
  return (
    <Section id="rig" name={say("opened-evidence-rig")}>
      <div class="opened__scroll">
        <Facts
          rows={[
            [say("opened-evidence-baseline"), withU(rig.baseline_m, rig.u_baseline_m, "m")],
            [say("opened-evidence-baseline-there"), withU(at.baseline_m, at.u_baseline_m, "m")],
            [
              say("opened-evidence-rate"),
              withU(rig.line_rate_hz, rig.line_rate_hz * rig.u_line_rate_ratio, "Hz"),
            ],
            [
              say("opened-evidence-divergence"),
              withU(1e3 * rig.divergence_rad, 1e3 * rig.u_divergence_rad, "mrad"),
            ],
            [say("opened-evidence-distance"), withU(rig.distance_m, null, "m")],
            [say("opened-evidence-misalignment"), withU(rig.misalignment_px, rig.u_misalignment_px, "px")],
            [say("opened-evidence-shadow"), `${Math.round(100 * rig.shadow_share)}\u00a0%`],
            [
              say("opened-evidence-strips"),
              say("opened-evidence-strips-size", {
                name: scan.name,
                lines: scan.lines,
                rows: scan.rows_px,
                bits: scan.bits,
              }),
            ],
            [say("opened-evidence-strip", { camera: 1 }), scan.first_sha256],
            [say("opened-evidence-strip", { camera: 2 }), scan.second_sha256],
          ]}
        />
      </div>
      {evidence.words.notes.map((one) => (
        <p key={one}>{told(one)}</p>
      ))}
    </Section>
  );
}

export function Audit({ evidence }: { evidence: Evidence }) {
  const { audit, keys } = evidence;
  return (
    <Section id="audit" name={say("opened-evidence-audit")}>
      <p>
        {say("opened-evidence-audit-end", { chain: audit.chain, count: audit.count })}{" "}
        <code class="evidence__hash">{audit.hash}</code>
      </p>
      <Grid
        list
        heads={[
          say("opened-evidence-event-number"),
          say("opened-evidence-event-at"),
          say("opened-evidence-event-what"),
          say("opened-evidence-event-hash"),
        ]}
      >
        {audit.events.map((one) => (
          <tr key={one.number}>
            <td>{one.number}</td>
            <td>{one.at.slice(0, 19).replace("T", " ")}</td>
            <td>{eventWords(one)}</td>
            <td>
              <code class="evidence__hash">{one.hash}</code>
            </td>
          </tr>
        ))}
      </Grid>
      <p>{say("opened-evidence-keys")}</p>
      <ol class="opened__sizes">
        {keys.map((one) => (
          <li key={one.key}>
            <code class="evidence__hash">{one.key}</code>
          </li>
        ))}
      </ol>
    </Section>
  );
}

function eventWords({ action, entity, entity_id }: AuditEvent): string {
  return say("opened-evidence-event", { action, entity, number: String(entity_id ?? "") });
}
