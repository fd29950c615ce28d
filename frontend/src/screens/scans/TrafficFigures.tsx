/** Flow and speed over the day and against each other, by interval; every number is the server's. */
import { say, withUnit } from "../../core/messages";
import { formatPlaceClock } from "../../core/times";
import type { ScanTraffic, TrafficInterval } from "../../core/types";
import { fixed, speedScale } from "../../core/units";
import { aroundOne } from "../../parts/figures/curves";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { type Channels, type Readable, readable, readRows } from "../../parts/figures/reading";

/** A time of the place as the axis shows it: its clocks read as if they were UTC's. */
function from(one: TrafficInterval): Date {
  return new Date(`${one.begins_at.slice(0, 23)}Z`);
}

function until(one: TrafficInterval): Date {
  return new Date(from(one).getTime() + 1000 * one.watched_s);
}

function middle(one: TrafficInterval): Date {
  return new Date(from(one).getTime() + 500 * one.watched_s);
}

/** Of a recording, a direction and a lane, as an element is called. */
export function placeOf({ scan_id, direction, lane }: ScanTraffic): string {
  const way = direction === "camera_1_first" ? `${scan_id}` : `${scan_id}-2`;
  return lane === null ? way : `${way}-${lane}`;
}

/** A clock of the place for a time of the axis. */
const clock = (x: number) => formatPlaceClock(new Date(x).toISOString().replace("Z", ""));

/** Read over the whole of each interval, and not beside it; numbers that are none (NaN) are not read. */
export function overIntervals(
  intervals: readonly TrafficInterval[],
  { y, low, high }: Omit<Channels<TrafficInterval>, "x">,
): Readable {
  const rows = intervals.flatMap((one) => [
    { x: from(one).getTime(), one },
    { x: until(one).getTime(), one: null },
  ]);
  const over =
    (of: (one: TrafficInterval) => number | null) =>
    ({ one }: (typeof rows)[number]) => {
      const value = one && of(one);
      return Number.isFinite(value) ? value : null;
    };
  const channels = { x: (row: (typeof rows)[number]) => row.x, y: over(y) };
  return readRows(rows, { ...channels, low: low && over(low), high: high && over(high) }, "steps");
}

export function percentileOf({ percentiles }: TrafficInterval, percent: number) {
  return percentiles.find((one) => one.percent === percent);
}

function dayAxis({ intervals }: ScanTraffic) {
  const [first, last] = [intervals[0], intervals.at(-1)];
  const domain = first && last ? { domain: [from(first), until(last)] } : {};
  return { type: "utc", label: say("flows-axis-time"), ...domain } as const;
}

/** The interval with the largest flow; one vehicle in a second that was observed is no flow of an hour. */
export function busiest(intervals: readonly TrafficInterval[]): TrafficInterval {
  const whole = intervals.filter((one) => !one.partial);
  const among = whole.length > 0 ? whole : intervals;
  return among.reduce((found, one) => (one.flow_per_hour > found.flow_per_hour ? one : found));
}

/** An interval's figure over the whole of it, and how far it may be off in its middle. */
const OVER = { x1: from, x2: until, stroke: "var(--ink)", strokeWidth: 2.5 };
const SPREAD = { x: middle, stroke: "var(--ink-2)", strokeWidth: 1 };

const FLOW = ["begins_at", "watched_s", "vehicles", "flow_per_hour", "flow_low", "flow_high"] as const;

export function FlowFigure({ scan, minutes }: { scan: ScanTraffic; minutes: number }) {
  const most = busiest(scan.intervals);
  return (
    <PlotFigure
      name={`traffic-flow-${placeOf(scan)}`}
      title={say("flows-flow-of", { scan: scan.name })}
      says={say("flows-flow-says", {
        count: scan.intervals.length,
        flow: fixed(most.flow_per_hour, 0),
        time: formatPlaceClock(most.begins_at),
      })}
      note={say("flows-flow-note", { minutes: String(minutes) })}
      data={scan}
      options={(plot) => ({
        height: 240,
        x: dayAxis(scan),
        y: { label: withUnit(say("flows-flow"), say("unit-per-hour")), zero: true },
        marks: [
          plot.ruleY([0], { stroke: "var(--line-strong)" }),
          plot.ruleX(scan.intervals, { ...SPREAD, y1: "flow_low", y2: "flow_high" }),
          readable(
            plot.ruleY(scan.intervals, { ...OVER, y: "flow_per_hour" }),
            overIntervals(scan.intervals, {
              y: (one) => one.flow_per_hour,
              low: (one) => one.flow_low,
              high: (one) => one.flow_high,
            }),
          ),
        ],
      })}
      place={clock}
      table={() => ({
        columns: FLOW,
        rows: scan.intervals.map((one) => FLOW.map((name) => one[name])),
      })}
    />
  );
}

export function SpeedFigure({ scan }: { scan: ScanTraffic }) {
  const [by, unit] = speedScale();
  const seen = scan.intervals.filter((one) => one.space_mean_speed_mps.value !== null);
  const percentile = (percent: number) => (one: TrafficInterval) =>
    (percentileOf(one, percent)?.value ?? Number.NaN) * by;
  const mean = (one: TrafficInterval) => (one.space_mean_speed_mps.value ?? Number.NaN) * by;
  return (
    <PlotFigure
      name={`traffic-speed-${placeOf(scan)}`}
      title={say("flows-speed-of", { scan: scan.name })}
      says={say("flows-speed-says", { count: seen.length })}
      note={say("flows-speed-note")}
      reason={seen.length === 0 ? say("flows-speed-none") : null}
      data={scan}
      options={(plot) => ({
        height: 240,
        x: dayAxis(scan),
        y: {
          label: withUnit(say("flows-speed"), unit),
          ...aroundOne([mean, percentile(15), percentile(85)].flatMap((each) => seen.map(each))),
        },
        marks: [
          plot.ruleX(seen, { ...SPREAD, y1: percentile(15), y2: percentile(85) }),
          readable(
            plot.ruleY(seen, { ...OVER, y: mean }),
            overIntervals(seen, { y: mean, low: percentile(15), high: percentile(85) }),
          ),
        ],
      })}
      place={clock}
      table={() => ({
        columns: [
          "begins_at",
          "measured",
          "time_mean_mps",
          "space_mean_mps",
          "p15_mps",
          "p50_mps",
          "p85_mps",
        ],
        rows: scan.intervals.map((one) => [
          one.begins_at,
          one.measured,
          one.time_mean_speed_mps.value,
          one.space_mean_speed_mps.value,
          ...[15, 50, 85].map((percent) => percentileOf(one, percent)?.value ?? null),
        ]),
      })}
    />
  );
}

/** An interval as a point of the fundamental diagram. */
export type TrafficState = ReturnType<typeof statesOf>[number];

/** Of the intervals in which a speed counts: without one there is no density. */
export function statesOf(intervals: readonly TrafficInterval[]) {
  return intervals.flatMap((one) => {
    const [density, speed] = [one.density_per_km.value, one.space_mean_speed_mps.value];
    if (density === null || speed === null) return [];
    const { begins_at, partial, flow_per_hour } = one;
    return [{ begins_at, partial, flow_per_hour, density_per_km: density, speed_mps: speed }];
  });
}

/** The fundamental diagram: flow against density, or speed against flow. */
export function FundamentalFigure({ scan, against }: { scan: ScanTraffic; against: "density" | "flow" }) {
  const [by, unit] = speedScale();
  const states = statesOf(scan.intervals);
  const flowLabel = withUnit(say("flows-flow"), say("unit-per-hour"));
  const axes =
    against === "density"
      ? {
          x: (one: TrafficState) => one.density_per_km,
          y: (one: TrafficState) => one.flow_per_hour,
          xLabel: withUnit(say("flows-head-density"), say("unit-per-km")),
          yLabel: flowLabel,
        }
      : {
          x: (one: TrafficState) => one.flow_per_hour,
          y: (one: TrafficState) => one.speed_mps * by,
          xLabel: flowLabel,
          yLabel: withUnit(say("flows-speed"), unit),
        };
  const title = against === "density" ? "flows-flow-by-density-of" : "flows-speed-by-flow-of";
  const dots = { x: axes.x, y: axes.y, r: 3, stroke: "var(--ink)", strokeWidth: 1.5 };
  return (
    <PlotFigure
      name={`traffic-${against === "density" ? "flow-by-density" : "speed-by-flow"}-${placeOf(scan)}`}
      title={say(title, { scan: scan.name })}
      says={say("flows-fundamental-says", { count: states.length })}
      note={say("flows-fundamental-note")}
      reason={states.length === 0 ? say("flows-speed-none") : null}
      data={scan}
      options={(plot) => ({
        height: 240,
        x: { label: axes.xLabel, zero: true, nice: true, ...aroundOne([0, ...states.map(axes.x)]) },
        y:
          against === "density"
            ? { label: axes.yLabel, zero: true, nice: true }
            : { label: axes.yLabel, nice: true, ...aroundOne(states.map(axes.y)) },
        marks: [
          plot.dot(
            states.filter((one) => one.partial),
            dots,
          ),
          readable(
            plot.dot(
              states.filter((one) => !one.partial),
              { ...dots, fill: "var(--ink)" },
            ),
            readRows(states, axes, "points"),
          ),
        ],
      })}
      table={() => ({
        columns: ["begins_at", "partial", "density_per_km", "flow_per_hour", "space_mean_mps"],
        rows: states.map((one) => [
          one.begins_at,
          String(one.partial),
          one.density_per_km,
          one.flow_per_hour,
          one.speed_mps,
        ]),
      })}
    />
  );
}
