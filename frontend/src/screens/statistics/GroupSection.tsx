import { useState } from "preact/hooks";
import { Panel, Segments } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { Ecdf, TargetBody } from "../../core/types";
import { lengthScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { type Curve, ECDF_COLUMNS, ecdfMarks, ecdfRows } from "../../parts/figures/curves";
import type { Hue } from "../../parts/figures/hues";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { type Group, groupWord, isThere } from "./model";
import { SpreadTable } from "./spread";

/** Neighbours differ in hue, the fourth and on in their dashes too. */
const HUES = 3;
const MOST_DRAWN = 6;
const MOST_BANDS = 3;
const GROUPINGS = ["category", "class_set", "lighting", "site", "operator"] as const;
type GroupingName = (typeof GROUPINGS)[number];
const GROUPING_WORDS = wordsOf("statistics-grouping-");
const PERCENTS = [10, 50, 90];

/** Corrected heights of one target, by category, set of classes, lighting, site or operator. */
export function GroupSection({ targets }: { targets: readonly TargetBody[] }) {
  const [grouping, setGrouping] = useState<GroupingName>("category");
  const there = targets.filter((one) => one.corrected.n > 0);
  const [chosen, setChosen] = useState("driver_eye");
  const target = there.find((one) => one.target === chosen) ?? there[0];
  if (!target) return null;
  const found = target.groups[grouping];
  const groups = found?.groups ?? [];
  const curves = drawn(groups, grouping);
  const title = HEIGHT_WORDS[target.target];
  return (
    <Panel
      says="statistics-groups-title"
      aside={
        <div class="row row--wrap stat-noprint">
          <Segments
            says="statistics-groups-target"
            value={target.target}
            options={there.map((one) => ({ value: one.target, label: HEIGHT_WORDS[one.target] }))}
            onInput={setChosen}
          />
          <Segments
            says="statistics-groups-by"
            value={grouping}
            options={GROUPINGS.map((value) => ({ value, label: GROUPING_WORDS[value] }))}
            onInput={setGrouping}
          />
        </div>
      }
      wrap
      data-testid="groups"
    >
      <div class="grid pad stat-groups">
        <GroupsFigure
          name={`${target.target}-by-${grouping}`}
          title={say("statistics-groups-figure", { target: title, grouping })}
          says={say("statistics-groups-says", { target: title, grouping, count: curves.length })}
          note={
            groups.length > curves.length
              ? say("statistics-groups-note", {
                  count: curves.length,
                  all: groups.length + (found?.left_out ?? 0),
                  listed: groups.length,
                })
              : undefined
          }
          groups={groups}
          curves={curves}
          none={say("statistics-groups-nothing", { grouping })}
          across={["statistics-height-x", "height_m"]}
          by={grouping}
        />
        <SpreadTable
          label={say("statistics-groups-head", { grouping })}
          rows={groups.map((one) => ({ ...one, key: one.word, word: groupWord(grouping, one.word) }))}
          percents={PERCENTS}
          decimals={3}
        />
      </div>
    </Panel>
  );
}

interface GroupsFigureProps {
  name: string;
  title: string;
  says: string;
  note?: string;
  groups: readonly Group[];
  curves: ReturnType<typeof drawn>;
  /** Said where nothing can be drawn. */
  none: string;
  /** The axis, and what it is called in the CSV, beside what the groups are `by`. */
  across: readonly ["statistics-height-x" | "statistics-lateral-x", string];
  by: string;
}

/** Which share of each group is no higher, or no further across the road. */
export function GroupsFigure({
  groups,
  curves,
  none,
  across: [axis, name],
  by,
  ...words
}: GroupsFigureProps) {
  return (
    <PlotFigure
      {...words}
      legend={curves.map(({ curve }) => curve)}
      reason={curves.length === 0 ? none : null}
      data={groups}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        return {
          x: { label: say(axis, { unit: long }), nice: true, inset: 6 },
          y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
          marks: curves.flatMap(({ ecdf, curve }) => ecdfMarks(plot, ecdf, curve, perX)),
        };
      }}
      table={() => ({
        columns: [by, name, ...ECDF_COLUMNS],
        rows: groups.flatMap((one) => (isThere<Ecdf>(one.ecdf) ? ecdfRows(one.word, one.ecdf) : [])),
      })}
    />
  );
}

export function drawn(groups: readonly Group[], grouping: string) {
  const largest = [...groups].sort((a, b) => b.n - a.n).slice(0, MOST_DRAWN);
  return groups
    .filter((one) => largest.includes(one))
    .flatMap((one, i) => {
      if (!isThere<Ecdf>(one.ecdf)) return [];
      const band = groups.length <= MOST_BANDS; // more of them hide each other; the CSV has them all
      const word = groupWord(grouping, one.word);
      const curve: Curve = { word, hue: (i % HUES) as Hue, dash: i < HUES ? undefined : "6 4", band };
      return [{ ecdf: one.ecdf, curve }];
    });
}
