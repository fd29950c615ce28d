import { useState } from "preact/hooks";
import { Button, choices, Loaded, Problem, SelectField, TextField } from "../../components";
import { useAction } from "../../core/action";
import { ApiError, api } from "../../core/api";
import { fieldsOf, sent } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { Standard } from "../../core/types";
import { formatLength, lengthText, lengthUnit, parseLength, parseNumber } from "../../core/units";
import { inWords, STANDARD_OF } from "../../parts/figures/standards";

/** A standard with its numbers as they are typed; `height` null: as it is stored. */
type Row = Omit<Standard, "year" | "percent"> & {
  height: string | null;
  year: string;
  percent: string;
};

const EMPTY: Row = {
  name: "",
  what: "eye_car",
  height_m: 0,
  height: "",
  source: "",
  edition: "",
  year: "",
  percent: "",
  vehicle_class: "",
  cited_by: "",
  drawn: true,
  code: null,
};

const WORDS = ["name", "source", "vehicle_class", "cited_by"] as const;

/** A row with what was typed: the words become a person's, all as they were shown, with the first that changes. */
function changed(row: Row, changes: Partial<Row>): Row {
  const written = row.code !== null && WORDS.some((word) => word in changes);
  return written ? { ...inWords(row), ...changes, code: null } : { ...row, ...changes };
}

export function StandardsEditor({ surveyId, done }: { surveyId: string; done: (saved: boolean) => void }) {
  const survey_id = Number(surveyId);
  const found = useAsked("GET /surveys/{survey_id}/standards", { survey_id });
  const [typed, setTyped] = useState<Row[] | null>(null);
  const { busy, problem, setProblem, run } = useAction();
  if (!found.data) return <Loaded of={found} what={say("statistics-standards-loading")} />;
  const { version, standards } = found.data;
  const rows = typed ?? standards.map(rowOf);
  const change = (at: number, changes: Partial<Row>) =>
    setTyped(rows.map((row, i) => (i === at ? changed(row, changes) : row)));
  const save = async () => {
    const wrong = rows.map(problemOfRow).find((one) => one !== null);
    if (wrong) {
      setProblem(new ApiError(wrong, 422));
      return;
    }
    await run(async () => {
      const body = { version, standards: rows.map(standardOf) };
      await api.write("PUT /surveys/{survey_id}/standards", { survey_id }, { body });
      done(true);
    });
  };
  return (
    <form class="stack stack--tight pad" onSubmit={sent(save)}>
      {rows.map((row, at) => (
        <RowFields
          // rows have no name of their own while they are typed
          key={at}
          row={row}
          change={(changes) => change(at, changes)}
          remove={() => setTyped(rows.filter((_, i) => i !== at))}
        />
      ))}
      <Problem error={problem} />
      <div class="row">
        <Button says="statistics-standards-add" icon="add" onClick={() => setTyped([...rows, EMPTY])} />
        <span class="grow" />
        <Button says="action-cancel" onClick={() => done(false)} />
        <Button says="statistics-standards-save" type="submit" kind="primary" disabled={busy} />
      </div>
    </form>
  );
}

const shown = (metres: number) => lengthText(metres, lengthUnit.value, 3);
const EXAMPLE_M = 1.08;

function yearProblem({ year }: Row): string | null {
  return /^(\d{4})?$/.test(year.trim()) ? null : say("catalogue-year-problem");
}

function percentProblem({ percent }: Row): string | null {
  return percent.trim() && parseNumber(percent) === null ? say("catalogue-number-problem") : null;
}

/** Why a row cannot be saved, or null: nothing that is no number is left out in silence. */
export function problemOfRow(row: Row): string | null {
  if (row.height !== null && parseLength(row.height) === null) return heightProblem(row);
  return yearProblem(row) ?? percentProblem(row);
}

function heightProblem(row: Row): string {
  const { name } = inWords(row);
  const example = formatLength(EXAMPLE_M, 2);
  return name
    ? say("statistics-standard-problem", { standard: name, example })
    : say("statistics-standard-new-problem", { example });
}

export const rowOf = ({ year, percent, ...one }: Standard): Row => ({
  ...one,
  height: null,
  year: year === null ? "" : String(year),
  percent: percent === null ? "" : String(percent),
});

/** What is saved of a row: a height that nobody typed is not read back from the digits that are shown of it. */
export const standardOf = ({ height, ...row }: Row): Standard => ({
  ...row,
  height_m: height === null ? row.height_m : (parseLength(height) ?? 0),
  year: row.year.trim() ? Number(row.year) : null,
  percent: row.percent.trim() ? parseNumber(row.percent) : null,
});

interface RowProps {
  row: Row;
  change: (changes: Partial<Row>) => void;
  remove: () => void;
}

function RowFields({ row: stored, change, remove }: RowProps) {
  const row = { ...inWords(stored), height: stored.height ?? shown(stored.height_m) };
  const field = fieldsOf(row, change);
  return (
    <fieldset class="grid grid--6 grid--tight grid--low stat-editor__row">
      <legend class="visually-hidden">{row.name || say("statistics-standard-new")}</legend>
      <TextField says="statistics-standard-name" {...field("name")} required />
      <SelectField says="statistics-standard-for" {...field("what")} options={choices(STANDARD_OF)} />
      <TextField says="statistics-standard-height" unit={lengthUnit.value} {...field("height")} />
      <TextField says="statistics-standard-source" {...field("source")} />
      <TextField says="statistics-standard-edition-field" {...field("edition")} />
      <TextField says="statistics-standard-year" {...field("year")} problem={yearProblem(row)} />
      <TextField says="statistics-percentile" numeric {...field("percent")} problem={percentProblem(row)} />
      <TextField says="statistics-standard-class" {...field("vehicle_class")} />
      <TextField says="statistics-standard-cited-by" {...field("cited_by")} />
      <SelectField
        says="statistics-standards-drawn"
        value={row.drawn ? "yes" : "no"}
        options={choices(wordsOf("statistics-standard-drawn-", "yes", "no"))}
        onInput={(drawn) => change({ drawn: drawn === "yes" })}
      />
      <Button
        icon="close"
        label={
          row.name
            ? say("statistics-standard-remove", { standard: row.name })
            : say("statistics-standard-new-remove")
        }
        onClick={remove}
      />
    </fieldset>
  );
}
