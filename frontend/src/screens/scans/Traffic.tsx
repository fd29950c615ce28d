/** Traffic past the line cameras by the clock: flow, speeds, occupancy and length classes per interval. */
import { useState } from "preact/hooks";
import {
  Button,
  type Column,
  choices,
  DataTable,
  Empty,
  Loaded,
  type Columns as Made,
  Notice,
  Notices,
  Panel,
  Segments,
} from "../../components";
import { say, sentenceOf, withUnit, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatPlaceClock, formatPlaceDay, formatPlaceMoment } from "../../core/times";
import type { ScanTraffic, TrafficFigure, TrafficInterval, TrafficOfScans } from "../../core/types";
import { fixed, heads, plainLength, speedScale } from "../../core/units";
import type { Filmed } from "../../parts/filming/FilmedFields";
import { FlowFigure, FundamentalFigure, percentileOf, placeOf, SpeedFigure } from "./TrafficFigures";

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
      <Notices of={found.data?.notes} kind="warning" />
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

/** Fewer are one dot or two of a plot, which say less than their line of the table. */
const LEAST_PLOTTED = 3;

export function OfScan({ scan, of, surveyId }: { scan: ScanTraffic; of: TrafficOfScans; surveyId: number }) {
  const [view, setView] = useState<View>("flow");
  if (scan.reason)
    return (
      <Empty
        panel
        label={scan.name}
        actions={<Button says="scans-all" href={`/surveys/${surveyId}/scans`} />}
      >
        <p>{sentenceOf(scan.reason)}</p>
      </Empty>
    );
  const plotted = scan.intervals.length >= LEAST_PLOTTED;
  const day = scan.intervals[0] ? formatPlaceDay(scan.intervals[0].begins_at) : "";
  return (
    <>
      {plotted && (
        <div class="grid grid--fit scan-figures" style={{ "--least": "420px" }}>
          <FlowFigure scan={scan} minutes={of.minutes} />
          <SpeedFigure scan={scan} />
          <FundamentalFigure scan={scan} against="density" />
          <FundamentalFigure scan={scan} against="flow" />
        </div>
      )}
      <Panel
        label={scan.name}
        within
        aria-label={say("flows-table", { scan: scan.name })}
        note={day}
        aside={
          <Segments
            label={say("flows-columns", { scan: scan.name })}
            value={view}
            options={choices(VIEWS)}
            onInput={setView}
          />
        }
      >
        {scan.unplaced > 0 && (
          <Notice kind="warning">{say("flows-unplaced", { count: scan.unplaced })}</Notice>
        )}
        {!plotted && (
          <p class="panel__note small muted">{say("flows-few", { enough: LEAST_PLOTTED * of.minutes })}</p>
        )}
        <IntervalTable scan={scan} view={view} limits_m={of.length_limits_m} />
        <p class="panel__note small muted">{say("flows-table-note")}</p>
      </Panel>
    </>
  );
}

const VIEWS = wordsOf("flows-columns-", "flow", "speeds", "lengths");
type View = keyof typeof VIEWS;
type Intervals = Made<TrafficInterval>;

/** The columns of a view, after the one that says which interval it is: as many as stand beside each other at 1024 px. */
const COLUMNS: Readonly<
  Record<View, (made: Intervals, limits_m: readonly number[]) => Column<TrafficInterval>[]>
> = { flow: ofFlow, speeds: ofSpeeds, lengths: ofLengths };

function IntervalTable({
  scan,
  view,
  limits_m,
}: {
  scan: ScanTraffic;
  view: View;
  limits_m: readonly number[];
}) {
  return (
    <DataTable
      label={say("flows-table", { scan: scan.name })}
      class="table--dense"
      data-testid={`traffic-${placeOf(scan)}`}
      rows={scan.intervals}
      keyOf={(one) => one.begins_at}
      rowAttributes={(one) => ({ title: one.reasons.map(sentenceOf).join(" ") || undefined })}
      columns={(made) => [
        made.col(say("flows-head-from"), (one) => <From one={one} first={scan.intervals[0]} />, "nowrap"),
        ...COLUMNS[view](made, limits_m),
      ]}
    />
  );
}

/** When an interval began: its clock, with the day where that is another one than the heading's. */
export function beganWords(begins_at: string, first_at = begins_at): string {
  const sameDay = begins_at.slice(0, 10) === first_at.slice(0, 10);
  return sameDay ? formatPlaceClock(begins_at) : formatPlaceMoment(begins_at);
}

function From({ one, first }: { one: TrafficInterval; first?: TrafficInterval }) {
  return (
    <>
      {beganWords(one.begins_at, first?.begins_at)}
      {one.partial && <span class="muted"> {say("flows-partial")}</span>}
    </>
  );
}

function ofFlow({ num }: Intervals) {
  const speed = speedScale()[1];
  return [
    num(say("flows-head-vehicles"), (one) => (
      <>
        {one.vehicles}
        {one.refused > 0 && <Small>{say("flows-refused", { count: one.refused })}</Small>}
        {!!one.near_edge && <Small>{say("flows-near-edge", { count: one.near_edge })}</Small>}
      </>
    )),
    num(withUnit(say("flows-head-flow"), say("unit-per-hour")), (one) => (
      <>
        {fixed(one.flow_per_hour, 0)}
        <Small>{say("interval", { low: fixed(one.flow_low, 0), high: fixed(one.flow_high, 0) })}</Small>
      </>
    )),
    num(withUnit(say("flows-head-space-mean"), speed), spaceMean),
    num(withUnit(say("flows-head-occupancy"), "%"), (one) => (
      <Measured figure={one.occupancy_percent} by={1} />
    )),
    num(withUnit(say("flows-head-density"), say("unit-per-km")), (one) => (
      <Measured figure={one.density_per_km} by={1} />
    )),
  ];
}

function ofSpeeds({ num }: Intervals) {
  const [by, speed] = speedScale();
  return [
    num(withUnit(say("flows-head-watched"), "s"), (one) => fixed(one.watched_s, 0)),
    num(withUnit(say("scan-head-headway"), "s"), (one) =>
      one.mean_headway_s === null ? "–" : fixed(one.mean_headway_s, 2),
    ),
    num(say("flows-head-measured"), (one) => one.measured),
    num(withUnit(say("flows-head-time-mean"), speed), (one) => (
      <Measured figure={one.time_mean_speed_mps} by={by} />
    )),
    num(withUnit(say("flows-head-space-mean"), speed), spaceMean),
    num(withUnit("P85", speed), (one) => <Percentile one={one} percent={85} />),
  ];
}

function ofLengths({ num }: Intervals, limits_m: readonly number[]) {
  const classes = [
    ...limits_m.map((limit) => `≤ ${plainLength(limit, 1)}`),
    `> ${plainLength(limits_m.at(-1) ?? 0, 1)}`,
  ];
  return [
    num(say("flows-head-vehicles"), (one) => one.vehicles),
    ...classes.map((name, at) => ({
      ...num(withUnit(name, heads().length), (one) => <LengthClass kind={one.classes[at]} />),
      class: "nowrap",
    })),
    num(say("flows-head-unclassed"), (one) => one.unclassed),
  ];
}

function spaceMean(one: TrafficInterval) {
  return <Measured figure={one.space_mean_speed_mps} by={speedScale()[0]} />;
}

function Percentile({ one, percent }: { one: TrafficInterval; percent: number }) {
  const [by] = speedScale();
  const found = percentileOf(one, percent);
  if (found?.value == null) return <span title={sentenceOf(found?.reason) ?? undefined}>–</span>;
  const { value, low, high } = found;
  return (
    <>
      {fixed(value * by, 1)}
      {low !== null && high !== null && (
        <Small>{say("interval", { low: fixed(low * by, 1), high: fixed(high * by, 1) })}</Small>
      )}
    </>
  );
}

function LengthClass({ kind }: { kind?: TrafficInterval["classes"][number] }) {
  if (!kind) return null;
  return (
    <>
      {kind.vehicles}
      {kind.near_limit > 0 && <Small>{say("flows-near-limit", { count: kind.near_limit })}</Small>}
      {axleWords(kind.by_axles).map((words) => (
        <Small key={words}>{words}</Small>
      ))}
    </>
  );
}

/** Of a class, the vehicles with more than two axles. */
function axleWords(by_axles: readonly number[]): string[] {
  const axles = ["3", "4", say("flows-axles-many")];
  return axles.flatMap((one, at) => {
    const count = by_axles[at + 1];
    return count ? [say("flows-axles", { axles: one, count })] : [];
  });
}

/** A figure with its standard uncertainty below. */
function Measured({ figure, by }: { figure: TrafficFigure; by: number }) {
  return (
    <>
      {figure.value === null ? "–" : fixed(figure.value * by, 2)}
      {figure.value !== null && (
        <Small>{say("flows-u", { u: figure.u === null ? "–" : twoDigits(figure.u * by) })}</Small>
      )}
    </>
  );
}

function twoDigits(value: number): string {
  return fixed(value, value > 0 ? Math.max(0, 1 - Math.floor(Math.log10(value))) : 0);
}

function Small({ children }: { children: string }) {
  return <p class="small muted nowrap">{children}</p>;
}
