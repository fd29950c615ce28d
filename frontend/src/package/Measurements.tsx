import { useState } from "preact/hooks";
import type { Row } from "./csv";
import { fixed, shownHeight } from "./digits";
import { decimal, told } from "./language";
import type { Again } from "./measured";
import { again, type Opened } from "./opened";
import { Facts, Grid, Section } from "./Section";
import { say, sayCell } from "./say";

const PAGE = 50;

/** The list of measurements, and the one that is chosen with its pictures and both heights. */
export function Measurements({ found }: { found: Opened }) {
  const [filter, setFilter] = useState("");
  const [from, setFrom] = useState(0);
  const [chosen, setChosen] = useState<string | null>(null);
  const rows = found.measurements.filter((row) => matches(row, filter));
  const shown = rows.slice(from, from + PAGE);
  const one = found.measurements.find((row) => row["id"] === chosen) ?? shown[0];
  return (
    <Section id="measurements" name={say("opened-measurements")}>
      {found.measurements.length === 0 && <p class="opened__quiet">{say("opened-measurements-none")}</p>}
      <Stale count={found.measurements.filter(isStale).length} />
      {found.measurements.length > 0 && (
        <>
          <div class="opened__tools">
            <label class="opened__filter">
              {say("opened-filter")}
              <select
                value={filter}
                onChange={(event) => {
                  setFilter(event.currentTarget.value);
                  setFrom(0);
                }}
              >
                <option value="">{say("opened-filter-all")}</option>
                <option value="differs">{say("opened-filter-differs")}</option>
                <option value="stale">{say("opened-filter-stale")}</option>
                {[...new Set(found.measurements.map((row) => row["target"] ?? ""))].map((target) => (
                  <option key={target} value={target}>
                    {targetWord(target)}
                  </option>
                ))}
              </select>
            </label>
            <button type="button" disabled={from === 0} onClick={() => setFrom(from - PAGE)}>
              {say("opened-before")}
            </button>
            <span>
              {say("opened-range", {
                from: Math.min(from + 1, rows.length),
                to: Math.min(from + PAGE, rows.length),
                count: rows.length,
              })}
            </span>
            <button type="button" disabled={from + PAGE >= rows.length} onClick={() => setFrom(from + PAGE)}>
              {say("opened-after")}
            </button>
          </div>
          <div class="opened__split">
            <List rows={shown} outside={found.outside} chosen={one?.["id"] ?? null} choose={setChosen} />
            {one && <Detail row={one} found={found} />}
          </div>
        </>
      )}
    </Section>
  );
}

const CAUSES = ["pose", "inset", "side"] as const;

/** Whether a height follows from facts that no longer held when the package was made. */
function isStale(row: Row): boolean {
  return Boolean(row["out_of_date"]);
}

function Stale({ count }: { count: number }) {
  if (count === 0) return null;
  return (
    <p class="opened__wrong" data-stale={count}>
      {say("opened-stale-count", { count })}
    </p>
  );
}

function matches(row: Row, filter: string): boolean {
  if (filter === "") return true;
  if (filter === "stale") return isStale(row);
  return filter === "differs"
    ? (again.value.get(row["id"] ?? "")?.differs.length ?? 0) > 0
    : row["target"] === filter;
}

function targetWord(target: string): string {
  return sayCell(`opened-target-${target}`, target);
}

function verdictWord(row: Row): string {
  if (row["withdrawn"] === "true") return say("opened-withdrawn");
  const verdict = row["verdict"] || "unreviewed";
  return sayCell(`opened-verdict-${verdict}`, say("opened-verdict-unreviewed"));
}

interface ListProps {
  rows: readonly Row[];
  outside: ReadonlySet<string>;
  chosen: string | null;
  choose: (id: string) => void;
}

function List({ rows, outside, chosen, choose }: ListProps) {
  return (
    <Grid
      list
      heads={[
        say("opened-column-id"),
        say("opened-column-target"),
        say("opened-column-package"),
        say("opened-column-here"),
        say("opened-column-review"),
      ]}
    >
      {rows.map((row) => (
        <Line
          key={row["id"]}
          row={row}
          isOutside={outside.has(row["id"] ?? "")}
          isChosen={row["id"] === chosen}
          choose={choose}
        />
      ))}
    </Grid>
  );
}

interface LineProps {
  row: Row;
  isOutside: boolean;
  isChosen: boolean;
  choose: (id: string) => void;
}

function Line({ row, isOutside, isChosen, choose }: LineProps) {
  const id = row["id"] ?? "";
  const found = again.value.get(id);
  const height = found?.lengths.height_m;
  const print = found?.differs.length ? decimal : shownHeight; // a lie may stand in the last digit
  return (
    <tr
      class={isChosen ? "opened__line opened__line--chosen" : "opened__line"}
      data-measurement={id}
      data-height={height ?? ""}
      data-differs={found?.differs.join(" ")}
    >
      <td>
        <button type="button" class="opened__pick" aria-pressed={isChosen} onClick={() => choose(id)}>
          {id}
        </button>
      </td>
      <td>{targetWord(row["target"] ?? "")}</td>
      <td class="opened__figures-cell">
        {row["height_m"]
          ? say("opened-height", {
              height_m: print(row["height_m"]),
              U95_m: print(row["U95_height_m"] ?? ""),
            })
          : say("opened-height-none")}
        {isStale(row) && <div class="opened__wrong">{say("opened-stale-mark")}</div>}
      </td>
      <td
        class={
          found?.differs.length ? "opened__figures-cell opened__figures-cell--wrong" : "opened__figures-cell"
        }
      >
        {hereWords(found, found?.differs.length ? nanometres : shownHeight)}
      </td>
      <td>{isOutside ? say("opened-outside", { verdict: verdictWord(row) }) : verdictWord(row)}</td>
    </tr>
  );
}

function hereWords(found: Again | undefined, print = nanometres): string {
  if (found === undefined) return "…";
  if (found.refused === "pose") return say("opened-refused-pose");
  if (found.refused === "form") return say("opened-refused-form");
  const height = found.lengths.height_m;
  return height === null ? say("opened-height-none") : say("opened-height-here", { height_m: print(height) });
}

const nanometres = (metres: number) => fixed(metres, 9);

function Detail({ row, found }: { row: Row; found: Opened }) {
  const id = row["id"] ?? "";
  const crops = found.crops.get(id) ?? [];
  const parts = found.budget.get(id) ?? [];
  const mine = again.value.get(id);
  return (
    <div class="opened__detail">
      <h3 class="opened__name">{say("opened-one", { id, target: targetWord(row["target"] ?? "") })}</h3>
      {found.outside.has(id) ? (
        <p class="opened__quiet" data-outside>
          {say("opened-crops-outside", { only: found.about.only ?? "" })}
        </p>
      ) : (
        crops.length === 0 && <p class="opened__quiet">{say("opened-crops-none")}</p>
      )}
      <div class="opened__crops">
        {crops.map((crop) => (
          <Crop key={crop["k"]} crop={crop} />
        ))}
      </div>
      {row["reason"] && <p>{told(row["reason"])}</p>}
      {row["flags"] && <p class="opened__quiet">{told(row["flags"])}</p>}
      {CAUSES.filter((cause) => row["out_of_date"]?.split("; ").includes(cause)).map((cause) => (
        <p key={cause} class="opened__wrong" data-stale-cause={cause}>
          {say("opened-stale", { cause })}
        </p>
      ))}
      {mine && mine.differs.length > 0 && (
        <p class="opened__wrong">{say("opened-differs", { named: mine.differs.join(", ") })}</p>
      )}
      <Facts
        class="opened__figures-cell"
        rows={[
          [say("opened-pair-package"), decimal(row["height_m"] ?? "") || say("opened-height-none")],
          [say("opened-pair-here"), hereWords(mine)],
          ...offRow(mine),
          [say("opened-pair-contact"), point(row, "contact")],
          [say("opened-pair-target"), point(row, "target")],
          [say("opened-pair-inset"), decimal(row["solved_inset_m"] || row["inset_m"] || "")],
          [say("opened-pair-frame"), `${row["recording_id"]}: ${row["frame"]}`],
          [say("opened-pair-pose"), row["pose_id"] ?? ""],
          ...parts.map(
            (part) =>
              [
                say("opened-pair-u", { source: told(part["source"] ?? "") }),
                decimal(part["u_m"] ?? ""),
              ] as const,
          ),
        ]}
      />
    </div>
  );
}

function point(row: Row, name: "contact" | "target"): string {
  return [row[`${name}_x_px`], row[`${name}_y_px`]].map((one) => decimal(one ?? "")).join("; ");
}

/** How far the height here is from that of the package. */
function offRow(mine: Again | undefined): [string, string][] {
  if (!mine || mine.off_m === null) return [];
  const off_nm = fixed(mine.off_m * 1e9, 1);
  return [[say("opened-pair-off"), say("opened-nanometres", { off_nm })]];
}

/** The picture that was clicked on, with the two points as crops.csv has them. */
function Crop({ crop }: { crop: Row }) {
  if (!crop["file"]) return <p class="opened__quiet">{told(crop["reason"] ?? "")}</p>;
  const number = (name: string) => Number(crop[name]);
  const [width, height] = [number("width_px"), number("height_px")];
  const points = ["contact", "target"].map(
    (word) => [number(`${word}_x_px`) + 0.5, number(`${word}_y_px`) + 0.5] as const,
  );
  const [[cx, cy], [tx, ty]] = points as [readonly [number, number], readonly [number, number]];
  return (
    <svg
      class="opened__crop"
      viewBox={`0 0 ${width} ${height}`}
      role="img"
      aria-label={say("opened-crop", { frame: crop["frame"] ?? "" })}
    >
      <image href={crop["file"]} width={width} height={height} />
      {(["dark", "light"] as const).map((shade) => (
        <g key={shade} class={`opened__points opened__points--${shade}`}>
          <path d={`M${cx} ${cy}L${tx} ${ty}`} stroke-dasharray="4 3" />
          <circle cx={cx} cy={cy} r="5" />
          <path d={`M${cx - 9} ${cy}h18`} />
          <circle cx={tx} cy={ty} r="5" />
          <path d={`M${tx} ${ty - 9}v18`} />
        </g>
      ))}
    </svg>
  );
}
