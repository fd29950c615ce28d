/** Line icons, 16 px, drawn on a 16 grid with 1.5 px strokes. */
const PATHS = {
  add: "M8 3v10M3 8h10",
  close: "M4 4l8 8M12 4l-8 8",
  chevron: "M4 6l4 4 4-4",
  left: "M10 4L6 8l4 4",
  right: "M6 4l4 4-4 4",
  arrow: "M3 8h10M9 4l4 4-4 4",
  warning: "M8 2.5l6 11H2zM8 6.5v3.5M8 12v.2",
  info: "M8 2a6 6 0 100 12A6 6 0 008 2zM8 7.2V11M8 5v.2",
  stop: "M5.6 2.5h4.8l3.1 3.1v4.8l-3.1 3.1H5.6l-3.1-3.1V5.6zM8 5v4M8 11v.2",
  undo: "M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",
  redo: "M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",
  upload: "M8 11V3M4.5 6L8 2.5 11.5 6M3 13.5h10",
  download: "M8 2.5v8M4.5 7.5L8 11l3.5-3.5M3 13.5h10",
  pause: "M5.5 3.5v9M10.5 3.5v9",
  play: "M5 3l8 5-8 5z",
  trash: "M3 4.5h10M6.5 4.5v-2h3v2M4.5 4.5l.6 9h5.8l.6-9",
  copy: "M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",
  check: "M3 8.5l3.2 3.2L13 5",
  search: "M7 2.5a4.5 4.5 0 100 9 4.5 4.5 0 000-9zM10.3 10.3l3.4 3.4",
  camera: "M2 5h3l1.2-2h3.6L11 5h3v8H2zM8 6.5a2.3 2.3 0 100 4.6 2.3 2.3 0 000-4.6z",
  film: "M2.5 3h11v10h-11zM5.5 3v10M10.5 3v10M2.5 8h11",
  road: "M5.5 2.5L2.5 13.5M10.5 2.5l3 11M8 3v2M8 7.2v2M8 11.3v2",
  ruler: "M2 10.5L10.5 2 14 5.5 5.5 14zM5 7.5l1.5 1.5M7.5 5l2 2",
  scan: "M2.5 3v10M5 3v10M7.5 6v7M10 4.5V13M13 3v10",
  review: "M2 8s2.2-4 6-4 6 4 6 4-2.2 4-6 4-6-4-6-4zM8 6.3a1.7 1.7 0 100 3.4 1.7 1.7 0 000-3.4z",
  package: "M2.5 5L8 2.2 13.5 5v6L8 13.8 2.5 11zM2.5 5L8 7.8 13.5 5M8 7.8v6",
  overview: "M3 3.5h10M3 8h10M3 12.5h6",
  audit: "M4 2.5h8v11H4zM6.5 5.5h3M6.5 8h3M6.5 10.5h3",
  chart: "M2.5 2.5v11h11M4.5 11.5c4 0 3-7 8.5-7",
  people:
    "M6 3a2.3 2.3 0 100 4.6A2.3 2.3 0 006 3zM2 13c0-2.4 1.6-4 4-4s4 1.6 4 4M10.5 3.3a2.2 2.2 0 010 4.1M11.5 9.2c1.6.4 2.5 1.8 2.5 3.8",
  retry: "M13 8a5 5 0 11-1.6-3.7M13 2.5V5h-2.5",
  settings: "M2.5 4.5h6M11.5 4.5h2M2.5 11.5h2M7.5 11.5h6M10 3v3M6 10v3",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 16 }: { name: IconName; size?: number }) {
  return (
    <svg width={size} height={size} viewBox="0 0 16 16" fill="none" aria-hidden="true">
      <path
        d={PATHS[name]}
        stroke="currentColor"
        stroke-width="1.5"
        stroke-linecap="round"
        stroke-linejoin="round"
      />
    </svg>
  );
}
