import { STATE_WORDS, type StateName } from "../core/words";

/** States are told by shape and word, never by colour: a mark looks the same in any print and to any eye. */
const DRAWN = {
  empty: () => <circle cx="7" cy="7" r="5" />,
  half: () => (
    <>
      <circle cx="7" cy="7" r="5" />
      <path d="M7 2a5 5 0 010 10z" fill="currentColor" />
    </>
  ),
  full: () => <circle cx="7" cy="7" r="5" fill="currentColor" />,
  check: () => (
    <>
      <circle cx="7" cy="7" r="6" fill="currentColor" stroke="none" />
      <path d="M4.2 7.3l2 2 3.6-4.2" stroke="var(--surface)" />
    </>
  ),
  cross: () => <path d="M3 3l8 8M11 3l-8 8" stroke-width="2" />,
  diamond: () => <path d="M7 1.5L12.5 7 7 12.5 1.5 7z" fill="currentColor" />,
  back: () => <path d="M5 2L2 5l3 3M2 5h6a3.5 3.5 0 010 7H5" />,
  warning: () => <path d="M7 1.8l5.6 10.4H1.4zM7 5.6v3M7 10.4v.1" />,
  arrow: () => <path d="M1.5 7h10M8 3.5L11.5 7 8 10.5" stroke-width="2" />,
  dash: () => <path d="M3.5 7h7" />,
  wait: () => <path d="M7 2a5 5 0 11-5 5" />,
};

export type MarkShape = keyof typeof DRAWN;

const SHAPES: Record<StateName, MarkShape> = {
  // vehicles
  to_do: "empty",
  partial: "half",
  measured: "full",
  not_visible: "dash",
  out_of_sample: "dash",
  discarded: "cross",
  // reviews
  to_review: "empty",
  accepted: "check",
  fixed: "diamond",
  rejected: "cross",
  reopened: "back",
  withdrawn: "dash",
  not_measurable: "warning",
  // steps
  done: "check",
  next: "arrow",
  begun: "half",
  waiting: "dash",
  // recordings and jobs
  ingesting: "wait",
  ready: "check",
  failed: "cross",
  queued: "dash",
  running: "wait",
  cancelled: "dash",
  // calibrations
  trusted: "check",
  not_trusted: "warning",
  used: "check",
  left_out: "cross",
  // people
  active: "full",
  inactive: "empty",
};

export function StateMark({
  state,
  word,
  hideWord,
}: {
  state: StateName;
  word?: string;
  hideWord?: boolean;
}) {
  const text = word ?? STATE_WORDS[state];
  return (
    <span class="mark" title={hideWord ? text : undefined}>
      <Shape shape={SHAPES[state]} />
      <span class={hideWord ? "visually-hidden" : undefined}>{text}</span>
    </span>
  );
}

export function Shape({ shape, size = 14 }: { shape: MarkShape; size?: number }) {
  return (
    <svg
      width={size}
      height={size}
      viewBox="0 0 14 14"
      fill="none"
      stroke="currentColor"
      stroke-width="1.5"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
    >
      {DRAWN[shape]()}
    </svg>
  );
}
