import { Fragment } from "preact";
import { Button, DataTable, Empty, Loaded, Notice, Notices, PageHead, StateMark } from "../../components";
import { say, sentenceOf, withUnit } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useEvery } from "../../core/resource";
import { survey } from "../../core/survey";
import {
  formatAgo,
  formatClock,
  formatDuration,
  formatMoment,
  formatPlaceClock,
  formatPlaceMoment,
  placeTime,
} from "../../core/times";
import type { LiveStream } from "../../core/types";
import { fixed, formatCount, formatLength, formatSpeed } from "../../core/units";
import { LIVE_WORDS, vehicleName } from "../../core/words";
import { OtherWay } from "../../parts/OtherWay";
import "./live.css";

const EVERY_MS = 1000;

export default function LiveScreen({ surveyId }: ScreenProps) {
  const streams = useAsked("GET /surveys/{survey_id}/live", { survey_id: surveyId }, { keep: true });
  useEvery(EVERY_MS, streams.reload);
  return (
    <div class="page">
      <PageHead says="page-live" lead={say("live-lead")}>
        <Button says="scans-all" href={`/surveys/${surveyId}/scans`} />
      </PageHead>
      <Loaded of={streams} what={say("live-loading")} />
      {streams.data?.length === 0 && <HowToStart surveyId={surveyId} />}
      <div class="stack">
        {streams.data?.map((stream) => (
          <Stream key={stream.scan_id} stream={stream} surveyId={surveyId} />
        ))}
      </div>
    </div>
  );
}

/** The commands stand here as they are typed; no catalogue translates them. */
function HowToStart({ surveyId }: { surveyId: number }) {
  const rig = "--rows 1024 --baseline 0.5 --line-rate 5000";
  return (
    <Empty panel says="live-none-title">
      <p>{say("live-none-pipe")}</p>
      <Typed command={`recorder | sightline stream ${rig} --survey ${surveyId}`} />
      <p>{say("live-none-file")}</p>
      <Typed command={`sightline stream ${rig} --follow lines.raw --survey ${surveyId}`} />
      <p>{say("live-none-cameras")}</p>
      <Typed command={`sightline stream ${rig} --camera FIRST --camera SECOND --survey ${surveyId}`} />
    </Empty>
  );
}

/** Too long for a line, it goes on in the next with an option. */
function Typed({ command }: { command: string }) {
  return (
    <pre class="live-command">
      {command.split(/(?<= )(?=--)/).map((part) => (
        <Fragment key={part}>
          <span class="nowrap">{part}</span>
          <wbr />
        </Fragment>
      ))}
    </pre>
  );
}

export function Stream({ stream, surveyId }: { stream: LiveStream; surveyId: number }) {
  return (
    <section class="panel live" data-testid={`live-${stream.scan_id}`}>
      <header class="row row--apart row--wrap">
        <div>
          <h2 class="clip">{stream.source ?? say("live-source-piped")}</h2>
          <p class="small muted">{say("live-since", { time: momentThere(stream.began_at) })}</p>
        </div>
        <StateOf stream={stream} />
      </header>
      {stream.state === "silent" && (
        <Notice kind="warning">{say("live-silent", { ago: formatAgo(stream.heard_at) })}</Notice>
      )}
      {stream.state === "stopped" && (
        <Notice kind="warning">{say("live-stopped", { time: momentThere(stream.heard_at) })}</Notice>
      )}
      <Notices of={stream.health?.words} kind="warning" />
      <Health stream={stream} />
      <div class="grid grid--fit" style={{ "--least": "400px" }}>
        <Flow flow={stream.flow} />
        <Vehicles stream={stream} surveyId={surveyId} />
      </div>
      {stream.earlier.length > 0 && (
        <p class="small row row--wrap">
          <span class="muted">{say("live-earlier")}</span>
          {stream.earlier.map((one) => (
            <a key={one.scan_id} href={`/surveys/${surveyId}/scan?scan=${one.scan_id}`}>
              {momentThere(one.began_at)}
            </a>
          ))}
        </p>
      )}
    </section>
  );
}

function StateOf({ stream }: { stream: LiveStream }) {
  const word = LIVE_WORDS[stream.state];
  if (stream.state === "running") return <StateMark state="running" word={word} />;
  return <StateMark state={stream.state === "ended" ? "done" : "not_measurable"} word={word} />;
}

function Vehicles({ stream, surveyId }: { stream: LiveStream; surveyId: number }) {
  if (!stream.vehicles.length) return <p class="muted">{say("live-no-vehicles")}</p>;
  const lanes = stream.vehicles.some((one) => one.lane !== null);
  return (
    <div>
      <DataTable
        label={say("live-vehicles")}
        class="table--dense"
        rows={stream.vehicles}
        keyOf={(one) => one.id}
        rowAttributes={(one) => ({ "data-testid": `live-vehicle-${one.number}` })}
        columns={({ col, num, across }) => [
          col(say("scan-head-number"), ({ id, number }) => {
            const bench = `/surveys/${surveyId}/scan?scan=${stream.scan_id}&vehicle=${id}`;
            return stream.ready ? <a href={bench}>{vehicleName(number)}</a> : vehicleName(number);
          }),
          col(say("scan-head-clock"), (one) => clockThere(one.front_at)),
          ...across(
            ({ status, reason }) => (status === "ok" ? undefined : sentenceOf(reason)),
            "live__reason",
            num(say("scan-head-speed"), (one) => (
              <>
                {one.direction === "camera_2_first" && <OtherWay />}
                {formatSpeed(one.speed_mps, one.U95_speed_mps, 2)}
              </>
            )),
            num(say("scan-head-length"), (one) => formatLength(one.length_m, 2)),
          ),
          num(withUnit(say("scan-head-gap"), "s"), ({ time_gap_s }) =>
            time_gap_s === null ? "–" : fixed(time_gap_s, 2),
          ),
          num(say("scan-axles"), (one) => one.axles ?? "–"),
          ...(lanes ? [col(say("scan-lane"), (one) => one.lane ?? "–")] : []),
        ]}
      />
      {!stream.ready && <p class="small muted">{say("live-picture-later")}</p>}
    </div>
  );
}

const MOST_DN = 255;

/** How a stream is, in figures: what came, what was lost, the light, the clock, the memory. */
function Health({ stream }: { stream: LiveStream }) {
  const { health } = stream;
  if (!health) return null;
  return (
    <dl class="grid grid--4 live__health" data-testid="live-health">
      <Figure name={say("live-time")} value={formatDuration(health.lines / stream.line_rate_hz)} />
      <Figure name={say("live-lines")} value={formatCount(health.lines)} />
      <Figure name={say("live-lost")} value={bothOf(health.lost_lines, formatCount)} />
      <Figure name={say("live-light")} value={bothOf(health.light_dn, lightOf)} />
      <Figure name={say("live-saturated")} value={bothOf(health.saturated, percentOf)} />
      <Figure name={say("live-clock")} value={`${fixed(health.clock_offset_s, 1)} s`} />
      <Figure name={say("live-waiting")} value={`${fixed(health.waiting_mib, 0)} MiB`} />
      <Figure name={say("live-memory")} value={`${fixed(health.memory_mib, 0)} MiB`} />
    </dl>
  );
}

function Figure({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}

/** "0 / 32": camera 1, camera 2. */
function bothOf<T>(pair: readonly [T, T], word: (value: T) => string): string {
  return pair.map(word).join(" / ");
}

function lightOf(dn: number | null): string {
  return dn === null ? "–" : percentOf(dn / MOST_DN);
}

function percentOf(share: number): string {
  return `${fixed(100 * share, 0)} %`;
}

type Minutes = LiveStream["flow"];
const LEAST_TOP = 5;

/** Vehicles a minute over the last hour; minutes that were not watched whole are hatched. */
function Flow({ flow }: { flow: Minutes }) {
  const top = Math.max(LEAST_TOP, ...flow.map((one) => one.vehicles));
  const whole = flow.filter((one) => one.whole).at(-1);
  return (
    <figure class="stack stack--dense" data-testid="live-flow">
      <figcaption class="row row--apart">
        <span>{say("live-flow")}</span>
        <span class="muted">
          {whole
            ? say("live-flow-last", { time: formatTime(whole.begin), vehicles: whole.vehicles })
            : say("live-flow-none")}
        </span>
      </figcaption>
      <div class="live-flow__plot">
        <div class="live-flow__scale" aria-hidden="true">
          <span>{top}</span>
          <span>0</span>
        </div>
        <ol class="live-flow__bars">
          {flow.map((one) => (
            <li key={one.begin} title={minuteWords(one)}>
              <span
                class={one.whole ? "live-flow__bar" : "live-flow__bar live-flow__bar--part"}
                style={{ height: `${(100 * one.vehicles) / top}%` }}
              />
              <span class="visually-hidden">{minuteWords(one)}</span>
            </li>
          ))}
        </ol>
      </div>
      <div class="live-flow__times row row--apart small muted" aria-hidden="true">
        <span>{flow[0] && formatTime(flow[0].begin)}</span>
        <span>{flow.length > 1 && formatTime(flow[flow.length - 1]?.begin ?? "")}</span>
      </div>
    </figure>
  );
}

function minuteWords(one: Minutes[number]): string {
  return say(one.whole ? "live-flow-minute" : "live-flow-part", {
    time: formatTime(one.begin),
    vehicles: one.vehicles,
  });
}

function formatTime(iso: string): string {
  return clockThere(iso).replace(/:\d\d$/, "");
}

/** The time of day by the clocks of the survey's place; by the browser's where nobody said where it is. */
export function clockThere(iso: string): string {
  const there = shownThere(iso);
  return there === null ? formatClock(new Date(iso)) : formatPlaceClock(there);
}

export function momentThere(iso: string): string {
  const there = shownThere(iso);
  return there === null ? formatMoment(iso) : formatPlaceMoment(there);
}

function shownThere(iso: string): string | null {
  const zone = survey.value?.place.time_zone;
  return zone ? placeTime(iso, zone) : null;
}
