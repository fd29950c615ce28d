/** Passes of a staff or board as they are typed: one way at a time, sent as a table like any other. */
import { say, wordsOf } from "../../core/messages";
import { parseNumber } from "../../core/units";

export type Way = "board" | "positions" | "speed";
export type PassTyped = Readonly<Record<string, string>>;

const STAND = ["distance_m", "u_distance_m"] as const;
const LINES = ["front_line_1", "rear_line_1", "front_line_2", "rear_line_2"] as const;
export const COLUMNS: Readonly<Record<Way, readonly string[]>> = {
  board: [...STAND, "width_m", "u_width_m", ...LINES, "u_line"],
  positions: [...STAND, "position_1_m", "position_2_m", "u_position_m"],
  speed: [...STAND, "speed_mps", "u_speed_mps", "line_1", "line_2", "u_line"],
};
/** What is as in the row before, until somebody says otherwise. */
const CARRIED = new Set(["distance_m", "u_distance_m", "width_m", "u_width_m", "u_position_m", "u_line"]);

const HEADS: Readonly<Record<string, string>> = wordsOf("scans-passes-head-");

export const USUAL: Readonly<Record<string, string>> = { u_distance_m: "0.01", u_line: "2" };

/** Every uncertainty beside a value is called the same. */
export function headOf(column: string): string {
  return HEADS[column] ?? say("scans-passes-u");
}

/** An empty row to type in; what stays as a rule is taken from the row before. */
export function nextPass(way: Way, before?: PassTyped): PassTyped {
  return Object.fromEntries(
    COLUMNS[way].map((name) => [name, (before && CARRIED.has(name) && before[name]) || ""]),
  );
}

function isTyped(pass: PassTyped): boolean {
  return Object.entries(pass).some(([name, cell]) => !CARRIED.has(name) && cell.trim() !== "");
}

/** A cell as the table's reader takes it: a decimal point, and no sign that parts cells. */
function plain(cell: string): string {
  const value = parseNumber(cell);
  return value === null ? cell.replace(/[;\r\n"]/g, " ").trim() : String(value);
}

/** The rows in which something stands, as a CSV (semicolons: a comma may be somebody's decimal sign); null for none. */
export function tableOf(way: Way, passes: readonly PassTyped[]): File | null {
  const names = COLUMNS[way];
  const rows = passes.map((pass, at) => ({ pass, name: String(at + 1) })).filter(({ pass }) => isTyped(pass));
  if (rows.length === 0) return null;
  const lines = rows.map(({ pass, name }) =>
    [name, ...names.map((column) => plain(pass[column] ?? ""))].join(";"),
  );
  const text = [["pass", ...names].join(";"), ...lines].join("\n");
  return new File([text], say("scans-passes-typed"), { type: "text/csv" });
}
