import { useState } from "preact/hooks";
import { Panel, Segments, Table } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { Ecdf } from "../../core/types";
import { lengthScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { type Curve, ECDF_COLUMNS, ecdfMarks, ecdfRows } from "../../parts/figures/curves";
import type { Hue } from "../../parts/figures/hues";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { type Group, groupWord, isThere, type OfTarget } from "./model";
import { SpreadCells, spreadHeads } from "./spread";

/** Neighbours differ in hue, the fourth and on in their dashes too. */
const HUES = 3;
const MOST_DRAWN = 6;
const MOST_BANDS = 3;
const GROUPINGS = ["category", "class_set", "lighting", "site", "operator"] as const;
type GroupingName = (typeof GROUPINGS)[number];
const GROUPING_WORDS = wordsOf("statistics-grouping-");
const PERCENTS = [10, 50, 90];

/** Corrected heights of one target, by category, set of classes, lighting, site or operator. */
export function GroupSection({ targets }: { targets: readonly OfTarget[] }) {
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
        <PlotFigure
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
          legend={curves.map(({ curve }) => curve)}
          reason={curves.length === 0 ? say("statistics-groups-nothing", { grouping }) : null}
          data={[target, grouping]}
          options={(plot, unit) => {
            const [perX, long] = lengthScale(unit);
            return {
              x: { label: say("statistics-height-x", { unit: long }), nice: true, inset: 6 },
              y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
              marks: [...curves.flatMap(({ ecdf, curve }) => ecdfMarks(plot, ecdf, curve, perX))],
            };
          }}
          table={() => ({
            columns: [grouping, "height_m", ...ECDF_COLUMNS],
            rows: groups.flatMap((one) => (isThere<Ecdf>(one.ecdf) ? ecdfRows(one.word, one.ecdf) : [])),
          })}
        />
        <GroupTable groups={groups} grouping={grouping} />
      </div>
    </Panel>
  );
}

export function drawn(groups: readonly Group[], grouping: string): { ecdf: Ecdf; curve: Curve }[] {
  const largest = [...groups].sort((a, b) => b.n - a.n).slice(0, MOST_DRAWN);
  return groups
    .filter((one) => largest.includes(one))
    .flatMap((one, i) => {
      if (!isThere<Ecdf>(one.ecdf)) return [];
      const band = groups.length <= MOST_BANDS; // more of them hide each other; the CSV has them all
      const word = groupWord(grouping, one.word);
      return [
        { ecdf: one.ecdf, curve: { word, hue: (i % HUES) as Hue, dash: i < HUES ? undefined : "6 4", band } },
      ];
    });
}

function GroupTable({ groups, grouping }: { groups: readonly Group[]; grouping: GroupingName }) {
  return (
    <Table
      label={say("statistics-groups-head", { grouping })}
      heads={[say("statistics-groups-head", { grouping }), ...spreadHeads(PERCENTS)]}
    >
      {groups.map((one) => (
        <tr key={one.word}>
          <th scope="row">{groupWord(grouping, one.word)}</th>
          <SpreadCells of={one} percents={PERCENTS} decimals={3} />
        </tr>
      ))}
    </Table>
  );
}
