/** Rows of the tables against what the audit chain says of them. */
import { canonical, type Json } from "./canonical";
import type { Chain } from "./chain";
import type { Row } from "./csv";
import { sha256 } from "./sha256";

type Values = Readonly<Record<string, Json>>;

const LENGTH = /_m$/;
const COLUMNS = [
  "revision",
  "target",
  "frame",
  "contact_x_px",
  "contact_y_px",
  "target_x_px",
  "target_y_px",
  "sigma_px",
  "pose_id",
  "inset_m",
  "u_inset_m",
  "height_m",
  "u_height_m",
  "U95_height_m",
  "status",
  "withdrawn",
];
const HALF_A_MICROMETRE = 0.51e-6;

/** The measurements, by id, that differ from their newest audit event or have none. */
export function notVouched(measurements: readonly Row[], chain: Chain): string[] {
  return measurements
    .filter((row) => !says(row, chain.measurements.get(row["id"] ?? "")))
    .map((row) => row["id"] ?? "");
}

function says(row: Row, event: Values | undefined): boolean {
  return (
    event !== undefined &&
    COLUMNS.every((name) => isSame(name, row[name] ?? "", event[name] ?? null)) &&
    ((event["more_frames"] ?? []) as Values[]).every((frame, n) => isSameFrame(row, frame, n + 2))
  );
}

function isSameFrame(row: Row, frame: Values, k: number): boolean {
  const points: [string, Json][] = [
    [`frame${k}`, frame["frame"] ?? null],
    ...["contact", "target"].flatMap((word): [string, Json][] => {
      const [x, y] = (frame[word === "target" ? "target_point" : word] ?? []) as number[];
      return [
        [`${word}${k}_x_px`, x ?? null],
        [`${word}${k}_y_px`, y ?? null],
      ];
    }),
  ];
  return points.every(([name, value]) => isSame(name, row[name] ?? "", value));
}

function isSame(name: string, cell: string, value: Json): boolean {
  if (value === null) return cell === "";
  if (typeof value !== "number") return cell === String(value);
  const off = Math.abs(Number(cell) - value);
  return cell !== "" && (LENGTH.test(name) ? off <= HALF_A_MICROMETRE : off === 0);
}

/** The road poses, by id, whose record is not the one that its audit event names. */
export function posesNotVouched(records: ReadonlyMap<string, unknown>, chain: Chain): string[] {
  return [...records]
    .filter(([id, record]) => sha256(canonical(record as Json)) !== chain.poses.get(id))
    .map(([id]) => id);
}
