/** Times as people read them, in the browser's zone; the full moment goes into `title` and `datetime`. */
import { computed } from "@preact/signals";
import { region, say } from "./messages";
import { fixed } from "./units";

const DAY = { day: "numeric", month: "short", year: "numeric" } as const;
const HOUR = { hour: "2-digit", minute: "2-digit" } as const;

const clock = format({ ...HOUR, second: "2-digit" });
const hour = format(HOUR);
const day = format(DAY);
const dayTime = format({ ...DAY, ...HOUR });
const placeDayTime = format({ ...DAY, ...HOUR, second: "2-digit", timeZone: "UTC" });
const placeDay = format({ ...DAY, timeZone: "UTC" });

function format(options: Intl.DateTimeFormatOptions) {
  return computed(() => new Intl.DateTimeFormat(region.value, options));
}

/** "14:02:11" */
export function formatClock(moment: Date): string {
  return clock.value.format(moment);
}

/** "21 Nov 2026" */
export function formatDay(iso: string): string {
  return day.value.format(new Date(iso));
}

/** "21 Nov 2026, 14:02" */
export function formatMoment(iso: string): string {
  return dayTime.value.format(new Date(iso));
}

/** "just now", "4 min ago", "today 14:02" or the day. */
export function formatAgo(iso: string, now = new Date()): string {
  const then = new Date(iso);
  const seconds = (now.getTime() - then.getTime()) / 1000;
  if (seconds < 60) return say("time-just-now");
  if (seconds < 3600) return say("time-minutes-ago", { minutes: Math.floor(seconds / 60) });
  if (then.toDateString() === now.toDateString()) return say("time-today", { time: hour.value.format(then) });
  return formatMoment(iso);
}

/* -- times by the clocks of a place, as "2026-05-03T08:10:00.000+02:00": shown as they stand there -- */

/** "3 May 2026, 08:10:00" */
export function formatPlaceMoment(local: string): string {
  return placeDayTime.value.format(new Date(`${local.slice(0, 19)}Z`));
}

/** "08:10:00" */
export function formatPlaceClock(local: string): string {
  return local.slice(11, 19);
}

/** "3 May 2026" */
export function formatPlaceDay(local: string): string {
  return placeDay.value.format(new Date(`${local.slice(0, 10)}T00:00:00Z`));
}

/** Decimals of a second for a time known to ± U95: down to its second digit, at most the milliseconds that are stored. */
export function secondDigits(U95_s: number | null): number {
  return U95_s === null || U95_s <= 0 ? 0 : Math.min(3, Math.max(0, 1 - Math.floor(Math.log10(U95_s))));
}

/** "08:10:00.251" with three decimals of a second, "08:10:00" with none. */
export function formatPlaceTime(local: string, digits: number): string {
  const whole = local.slice(11, 19);
  if (digits === 0) return whole;
  const steps = 10 ** digits;
  const part = Number(/^\.\d+/.exec(local.slice(19))?.[0] ?? 0);
  return whole + fixed(Math.min(Math.round(part * steps), steps - 1) / steps, digits).slice(1);
}

/** What clocks of a zone show at an instant, "2026-05-03T08:10:00"; null for a zone that the browser does not know. */
export function placeTime(iso: string, zone: string): string | null {
  try {
    const parts = { dateStyle: "short", timeStyle: "medium", timeZone: zone } as const;
    return new Intl.DateTimeFormat("sv-SE", parts).format(new Date(iso)).replace(" ", "T");
  } catch {
    return null;
  }
}

export const TIME_ZONES: readonly string[] = Intl.supportedValuesOf("timeZone");

export function ownZone(): string {
  return Intl.DateTimeFormat().resolvedOptions().timeZone;
}

/** A position in a recording: "42.800 s", or "3:02.800" from one minute on. */
export function formatFrameTime(seconds: number): string {
  const ms = Math.round(seconds * 1000);
  if (ms < 60_000) return `${fixed(seconds, 3)} s`;
  return `${Math.floor(ms / 60_000)}:${fixed((ms % 60_000) / 1000, 3).padStart(6, "0")}`;
}

/** A length of time: "12 s", "3 min 20 s", "1 h 04 min". */
export function formatDuration(seconds: number): string {
  const whole = Math.round(seconds);
  if (seconds < 10) return `${fixed(seconds, 1)} s`;
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, "0")} s`;
  return `${Math.floor(whole / 3600)} h ${String(Math.floor((whole % 3600) / 60)).padStart(2, "0")} min`;
}
