import { useState } from "preact/hooks";
import { Button, Loading, Problem, SelectField, TextField } from "../../components";
import { ApiError, api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { formatLength, lengthText, lengthUnit, parseLength } from "../../core/units";
import type { Standard } from "../../parts/figures/types";
import { STANDARD_OF } from "./model";

interface Row {
  name: string;
  what: Standard["what"];
  height: string;
  source: string;
}

const EMPTY: Row = { name: "", what: "driver_eye", height: "", source: "" };

/** A survey's own table of standards: rows to change, add and remove, saved as a whole. */
export function StandardsEditor({ surveyId, done }: { surveyId: string; done: (saved: boolean) => void }) {
  const survey_id = Number(surveyId);
  const found = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/standards", { survey_id }, { signal }),
    [survey_id],
  );
  const [typed, setTyped] = useState<Row[] | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  if (!found.data)
    return found.error ? (
      <Problem error={found.error} />
    ) : (
      <Loading what={say("statistics-standards-loading")} />
    );
  const { version, standards } = found.data;
  const rows = typed ?? standards.map(rowOf);
  const change = (at: number, changes: Partial<Row>) =>
    setTyped(rows.map((row, i) => (i === at ? { ...row, ...changes } : row)));
  const save = async () => {
    const wrong = rows.find((row) => parseLength(row.height) === null);
    if (wrong) {
      setProblem(new ApiError(heightProblem(wrong), 422));
      return;
    }
    setBusy(true);
    try {
      const table = rows.map(({ height, ...row }) => ({ ...row, height_m: parseLength(height) ?? 0 }));
      const body = { version, standards: table };
      await api.write("PUT /surveys/{survey_id}/standards", { survey_id }, { body });
      done(true);
    } catch (error) {
      setProblem(error);
      setBusy(false);
    }
  };
  return (
    <form
      class="stat-editor"
      onSubmit={(event) => {
        event.preventDefault();
        void save();
      }}
    >
      {rows.map((row, at) => (
        <RowFields
          // rows have no name of their own while they are typed
          key={at}
          row={row}
          at={at}
          change={(changes) => change(at, changes)}
          remove={() => setTyped(rows.filter((_, i) => i !== at))}
        />
      ))}
      <Problem error={problem} />
      <div class="row">
        <Button icon="add" onClick={() => setTyped([...rows, EMPTY])}>
          {say("statistics-standards-add")}
        </Button>
        <span class="grow" />
        <Button onClick={() => done(false)}>{say("action-cancel")}</Button>
        <Button type="submit" kind="primary" disabled={busy}>
          {say("statistics-standards-save")}
        </Button>
      </div>
    </form>
  );
}

const shown = (metres: number) => lengthText(metres, lengthUnit.value, 3);
const EXAMPLE_M = 1.08;

function heightProblem({ name }: Row): string {
  const example = formatLength(EXAMPLE_M, 2);
  return name
    ? say("statistics-standard-problem", { standard: name, example })
    : say("statistics-standard-new-problem", { example });
}

const rowOf = ({ name, what, height_m, source }: Standard): Row => ({
  name,
  what,
  height: shown(height_m),
  source,
});

interface RowProps {
  row: Row;
  at: number;
  change: (changes: Partial<Row>) => void;
  remove: () => void;
}

function RowFields({ row, at, change, remove }: RowProps) {
  const hide = at > 0;
  return (
    <fieldset class="stat-editor__row">
      <legend class="visually-hidden">{row.name || say("statistics-standard-new")}</legend>
      <TextField
        label={say("statistics-standard-name")}
        hideLabel={hide}
        value={row.name}
        required
        onInput={(name) => change({ name })}
      />
      <SelectField
        label={say("statistics-standard-for")}
        hideLabel={hide}
        value={row.what}
        options={(["driver_eye", "object"] as const).map((value) => ({ value, label: STANDARD_OF[value] }))}
        onChange={(what) => change({ what })}
      />
      <TextField
        label={say("statistics-standard-height")}
        hideLabel={hide}
        numeric
        unit={lengthUnit.value}
        value={row.height}
        onInput={(height) => change({ height })}
      />
      <TextField
        label={say("statistics-standard-source")}
        hideLabel={hide}
        value={row.source}
        onInput={(source) => change({ source })}
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
