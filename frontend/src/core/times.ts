/** Times as people read them, in the browser's zone; the full moment goes into `title` and `datetime`. */

const clock = new Intl.DateTimeFormat("en-GB", { hour: "2-digit", minute: "2-digit", second: "2-digit" });
const day = new Intl.DateTimeFormat("en-GB", { day: "numeric", month: "short", year: "numeric" });
const dayTime = new Intl.DateTimeFormat("en-GB", {
  day: "numeric",
  month: "short",
  year: "numeric",
  hour: "2-digit",
  minute: "2-digit",
});

/** "14:02:11" */
export function formatClock(moment: Date): string {
  return clock.format(moment);
}

/** "21 Nov 2026" */
export function formatDay(iso: string): string {
  return day.format(new Date(iso));
}

/** "21 Nov 2026, 14:02" */
export function formatMoment(iso: string): string {
  return dayTime.format(new Date(iso));
}

/** "just now", "4 min ago", "today 14:02" or the day. */
export function formatAgo(iso: string, now = new Date()): string {
  const then = new Date(iso);
  const seconds = (now.getTime() - then.getTime()) / 1000;
  if (seconds < 60) return "just now";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  if (then.toDateString() === now.toDateString()) return `today ${clock.format(then).slice(0, 5)}`;
  return formatMoment(iso);
}

/** A position in a recording: "42.800 s", or "3:02.800" from one minute on. */
export function formatFrameTime(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(3)} s`;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - minutes * 60).toFixed(3).padStart(6, "0")}`;
}

/** A length of time: "12 s", "3 min 20 s", "1 h 04 min". */
export function formatDuration(seconds: number): string {
  const whole = Math.round(seconds);
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, "0")} s`;
  return `${Math.floor(whole / 3600)} h ${String(Math.floor((whole % 3600) / 60)).padStart(2, "0")} min`;
}
