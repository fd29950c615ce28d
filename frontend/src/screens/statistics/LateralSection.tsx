/** Where vehicles drive across the road: by lane as a figure, by lane and class as a table. */
import { Panel, Table } from "../../components";
import { say } from "../../core/messages";
import { lengthScale } from "../../core/units";
import { ECDF_COLUMNS, ecdfMarks, ecdfRows } from "../../parts/figures/curves";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import type { Ecdf } from "../../parts/figures/types";
import { drawn } from "./GroupSection";
import { groupWord, isThere, type Lateral } from "./model";
import { SpreadCells, spreadHeads } from "./spread";

const PERCENTS = [5, 50, 95];
const laneWord = (word: string) => groupWord("lane", word);
const classWord = (word: string) => groupWord("category", word);

export function LateralSection({ lateral }: { lateral: Lateral }) {
  const lanes = lateral.lanes.groups;
  const curves = drawn(lanes, "lane");
  return (
    <Panel says="statistics-lateral-title" data-testid="lateral">
      <div class="stat-groups">
        <PlotFigure
          name="lateral-position"
          title={say("statistics-lateral-figure")}
          says={say("statistics-lateral-says", { count: curves.length })}
          note={say("statistics-lateral-note")}
          legend={curves.map(({ curve: { word, dash, faint, hue } }) => ({ word, dash, faint, hue }))}
          reason={curves.length === 0 ? say("statistics-lateral-none") : null}
          data={lateral}
          options={(plot, unit) => {
            const [perX, long] = lengthScale(unit);
            return {
              x: { label: say("statistics-lateral-x", { unit: long }), nice: true, inset: 6 },
              y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
              marks: curves.flatMap(({ ecdf, curve }) => ecdfMarks(plot, ecdf, curve, perX)),
            };
          }}
          table={() => ({
            columns: ["lane", "across_m", ...ECDF_COLUMNS],
            rows: lanes.flatMap((one) => (isThere<Ecdf>(one.ecdf) ? ecdfRows(one.word, one.ecdf) : [])),
          })}
        />
        <LanesTable lateral={lateral} />
      </div>
    </Panel>
  );
}

function LanesTable({ lateral }: { lateral: Lateral }) {
  return (
    <Table
      label={say("statistics-lateral-title")}
      heads={[say("statistics-lateral-vehicles"), ...spreadHeads(PERCENTS)]}
    >
      <Row word={say("statistics-lateral-all")} one={lateral.all} />
      {lateral.lanes.groups.map((lane) => (
        <>
          <Row key={lane.word} word={laneWord(lane.word)} one={lane} />
          {lateral.classes[lane.word]?.groups.map((of) => (
            <Row key={`${lane.word} ${of.word}`} word={classWord(of.word)} one={of} within />
          ))}
        </>
      ))}
    </Table>
  );
}

function Row({ word, one, within }: { word: string; one: Lateral["all"]; within?: boolean }) {
  return (
    <tr>
      {within ? <td class="muted stat-within">{word}</td> : <th scope="row">{word}</th>}
      <SpreadCells of={one} percents={PERCENTS} decimals={2} />
    </tr>
  );
}
