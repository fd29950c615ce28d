/** Traffic past the line cameras by the clock: flow, speeds, occupancy and length classes per interval. */
import { useState } from "preact/hooks";
import { Button, Empty, Loaded, Notice, num, Segments, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatPlaceClock, formatPlaceDay } from "../../core/times";
import type { ScanTraffic, TrafficFigure, TrafficInterval, TrafficOfScans } from "../../core/types";
import { fixed, heads, plainLength, speedScale } from "../../core/units";
import type { Filmed } from "../../parts/filming/FilmedFields";
import { FlowFigure, FundamentalFigure, placeOf, SpeedFigure } from "./TrafficFigures";

interface Props {
  surveyId: number;
  acceptedOnly: boolean;
  filmed: Filmed;
}

const MINUTES = ["1", "5", "15", "60"] as const;

export function Traffic({ surveyId, acceptedOnly, filmed }: Props) {
  const [minutes, setMinutes] = useState<(typeof MINUTES)[number]>("5");
  const found = useAsked("GET /surveys/{survey_id}/scan-traffic", {
    survey_id: surveyId,
    minutes: Number(minutes),
    accepted_only: acceptedOnly,
    ...filmed,
  });
  const scans = found.data?.scans ?? [];
  return (
    <section class="stack" aria-labelledby="scan-traffic" data-testid="scan-traffic">
      <header class="row row--wrap row--apart">
        <div>
          <h2 id="scan-traffic">{say("flows-title")}</h2>
          <p class="small muted">{say("flows-note")}</p>
        </div>
        <Segments
          says="flows-minutes"
          value={minutes}
          options={MINUTES.map((one) => ({ value: one, label: say("flows-minutes-of", { minutes: one }) }))}
          onInput={setMinutes}
        />
      </header>
      <Loaded of={found} what={say("flows-loading")} />
      {found.data &&
        named(scans).map((scan) => (
          <OfScan key={placeOf(scan)} scan={scan} of={found.data as TrafficOfScans} surveyId={surveyId} />
        ))}
    </section>
  );
}

/** Where a recording saw both directions, only the other one, or lanes, each is called by its own. */
function named(scans: readonly ScanTraffic[]): ScanTraffic[] {
  // what has no intervals has one reason for all its directions and lanes
  const shown = scans.filter(
    (one, at) => !one.reason || scans.findIndex((other) => other.scan_id === one.scan_id) === at,
  );
  return shown.map((one) => {
    if (one.reason) return one;
    const alone = scans.filter((other) => other.scan_id === one.scan_id).length === 1;
    if (alone && one.direction === "camera_1_first" && one.lane === null) return one;
    const name = say("flows-direction", { scan: one.name, direction: one.direction });
    const lanes = scans.some((other) => other.scan_id === one.scan_id && other.lane !== null);
    if (!lanes) return { ...one, name };
    return { ...one, name: say("flows-lane", { name, lane: one.lane ?? say("scan-lane-unknown") }) };
  });
}

function OfScan({ scan, of, surveyId }: { scan: ScanTraffic; of: TrafficOfScans; surveyId: number }) {
  if (scan.reason)
    return (
      <div class="panel">
        <Empty
          title={scan.name}
          actions={<Button href={`/surveys/${surveyId}/scans`}>{say("scans-all")}</Button>}
        >
          <p>{sentenceOf(scan.reason)}</p>
        </Empty>
      </div>
    );
  const day = scan.intervals[0] ? formatPlaceDay(scan.intervals[0].begins_at) : "";
  return (
    <>
      <div class="scan-figures">
        <FlowFigure scan={scan} minutes={of.minutes} />
        <SpeedFigure scan={scan} />
        <FundamentalFigure scan={scan} against="density" />
        <FundamentalFigure scan={scan} against="flow" />
      </div>
      <section class="panel" aria-label={say("flows-table", { scan: scan.name })}>
        <header class="panel__head">
          <h3>{scan.name}</h3>
          <span class="muted small">{day}</span>
        </header>
        {scan.unplaced > 0 && (
          <Notice kind="warning">{say("flows-unplaced", { count: scan.unplaced })}</Notice>
        )}
        <Intervals scan={scan} limits_m={of.length_limits_m} />
        <p class="small muted scan-traffic__note">{say("flows-table-note")}</p>
      </section>
    </>
  );
}

function Intervals({ scan, limits_m }: { scan: ScanTraffic; limits_m: readonly number[] }) {
  const units = heads();
  const withUnit = (name: string, unit: string) => say("with-unit", { name, unit });
  const classes = [
    ...limits_m.map((limit) => `≤ ${plainLength(limit, 1)}`),
    `> ${plainLength(limits_m.at(-1) ?? 0, 1)}`,
  ];
  return (
    <Table
      label={say("flows-table", { scan: scan.name })}
      class="table--dense"
      data-testid={`traffic-${placeOf(scan)}`}
      heads={[
        say("flows-head-from"),
        num(withUnit(say("flows-head-watched"), "s")),
        num(say("flows-head-vehicles")),
        num(withUnit(say("flows-head-flow"), say("unit-per-hour"))),
        num(withUnit(say("scan-head-headway"), "s")),
        num(say("flows-head-measured")),
        num(withUnit(say("flows-head-time-mean"), units.speed)),
        num(withUnit(say("flows-head-space-mean"), units.speed)),
        num(withUnit("P85", units.speed)),
        num(withUnit(say("flows-head-occupancy"), "%")),
        num(withUnit(say("flows-head-density"), say("unit-per-km"))),
        ...classes.map((name) => ({ ...num(withUnit(name, units.length)), class: "nowrap" })),
        num(say("flows-head-unclassed")),
      ]}
    >
      {scan.intervals.map((one) => (
        <Row key={one.begins_at} one={one} />
      ))}
    </Table>
  );
}

function Row({ one }: { one: TrafficInterval }) {
  const [by] = speedScale();
  const p85 = one.percentiles.find((each) => each.percent === 85);
  return (
    <tr title={one.reasons.map(sentenceOf).join(" ") || undefined}>
      <td class="nowrap">
        {formatPlaceClock(one.begins_at)}
        {one.partial && <span class="muted"> {say("flows-partial")}</span>}
      </td>
      <td class="num">{fixed(one.watched_s, 0)}</td>
      <td class="num">
        {one.vehicles}
        {one.refused > 0 && <Small>{say("flows-refused", { count: one.refused })}</Small>}
        {one.near_edge > 0 && <Small>{say("flows-near-edge", { count: one.near_edge })}</Small>}
      </td>
      <td class="num">
        {fixed(one.flow_per_hour, 0)}
        <Small>{say("interval", { low: fixed(one.flow_low, 0), high: fixed(one.flow_high, 0) })}</Small>
      </td>
      <td class="num">{one.mean_headway_s === null ? "–" : fixed(one.mean_headway_s, 2)}</td>
      <td class="num">{one.measured}</td>
      <Measured figure={one.time_mean_speed_mps} by={by} digits={2} />
      <Measured figure={one.space_mean_speed_mps} by={by} digits={2} />
      <td class="num">
        {p85 && p85.value !== null ? (
          fixed(p85.value * by, 1)
        ) : (
          <span title={sentenceOf(p85?.reason) ?? undefined}>–</span>
        )}
        {p85 && p85.low !== null && p85.high !== null && (
          <Small>{say("interval", { low: fixed(p85.low * by, 1), high: fixed(p85.high * by, 1) })}</Small>
        )}
      </td>
      <Measured figure={one.occupancy_percent} by={1} digits={2} />
      <Measured figure={one.density_per_km} by={1} digits={2} />
      {one.classes.map((kind) => (
        <td key={kind.above_m} class="num">
          {kind.vehicles}
          {kind.near_limit > 0 && <Small>{say("flows-near-limit", { count: kind.near_limit })}</Small>}
          {axleWords(kind.by_axles).map((words) => (
            <Small key={words}>{words}</Small>
          ))}
        </td>
      ))}
      <td class="num">{one.unclassed}</td>
    </tr>
  );
}

/** Of a class, the vehicles with more than two axles. */
function axleWords(by_axles: readonly number[]): string[] {
  const [, three = 0, four = 0, many = 0] = by_axles;
  const found: [string, number][] = [
    ["3", three],
    ["4", four],
    [say("flows-axles-many"), many],
  ];
  return found.flatMap(([axles, count]) => (count ? [say("flows-axles", { axles, count })] : []));
}

/** A figure with its standard uncertainty below. */
function Measured({ figure, by, digits }: { figure: TrafficFigure; by: number; digits: number }) {
  return (
    <td class="num">
      {figure.value === null ? "–" : fixed(figure.value * by, digits)}
      {figure.u !== null && (
        <Small>{say("flows-u", { u: String(Number((figure.u * by).toPrecision(2))) })}</Small>
      )}
    </td>
  );
}

function Small({ children }: { children: string }) {
  return <p class="small muted nowrap">{children}</p>;
}
