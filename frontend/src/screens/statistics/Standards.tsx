import { useState } from "preact/hooks";
import { Button, choices, DataTable, Panel, SelectField, TextField } from "../../components";
import { query } from "../../core/address";
import { sent, useForm } from "../../core/form";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import type { Standard } from "../../core/types";
import { formatLength, lengthUnit, parseLength, plainPercent } from "../../core/units";
import { formatLimit, inWords, standardKey, STANDARD_OF as WHAT } from "../../parts/figures/standards";
import { setFilter } from "./filters";
import { STANDARD_FOR } from "./model";
import { StandardsEditor } from "./StandardsEditor";

export function switchedOn(standards: readonly Standard[], off: readonly string[]): Standard[] {
  return standards.filter((one) => one.drawn && !off.includes(standardKey(one)));
}

interface Props {
  standards: readonly Standard[];
  /** Whose table can be changed here: that of the only survey shown. */
  surveyId: string | null;
  reload: () => void;
}

/** Which heights are drawn in: the survey's standards with their sources, and the reader's own, which are in the
 * address only, as is what is switched off.
 */
export function Standards({ standards, surveyId, reload }: Props) {
  const [editing, setEditing] = useState(false);
  const off = query.value.getAll("off");
  const toggle = (key: string, on: boolean) =>
    setFilter({ off: on ? off.filter((one) => one !== key) : [...off, key] });
  return (
    <Panel
      says="statistics-standards-title"
      aside={
        surveyId &&
        canWork.value &&
        !editing && <Button says="statistics-standards-change" small onClick={() => setEditing(true)} />
      }
      class="stat-noprint"
    >
      {editing && surveyId ? (
        <StandardsEditor
          surveyId={surveyId}
          done={(saved) => {
            setEditing(false);
            if (saved) reload();
          }}
        />
      ) : (
        <Drawn standards={standards} off={off} toggle={toggle} />
      )}
      <p class="stat-notes small">
        {say(surveyId ? "statistics-standards-one-survey" : "statistics-standards-surveys")}{" "}
        {say("statistics-standards-address")}
      </p>
      {!editing && <AddOwn />}
    </Panel>
  );
}

interface DrawnProps {
  standards: readonly Standard[];
  off: readonly string[];
  toggle: (key: string, on: boolean) => void;
}

function Drawn({ standards, off, toggle }: DrawnProps) {
  return (
    <DataTable
      label={say("statistics-standards-title")}
      data-testid="standards"
      rows={standards}
      keyOf={standardKey}
      columns={({ col, num, actions }) => [
        col(
          say("statistics-standards-drawn"),
          (one) =>
            one.drawn &&
            COMPARED.includes(one.what) && (
              <input
                type="checkbox"
                aria-label={say("statistics-standard-draw", {
                  standard: inWords(one).name,
                  what: WHAT[one.what],
                  height: formatLimit(one.height_m),
                })}
                checked={!off.includes(standardKey(one))}
                onChange={(event) => toggle(standardKey(one), event.currentTarget.checked)}
              />
            ),
        ),
        col(say("statistics-standards-standard"), (one) => inWords(one).name),
        col(say("statistics-standards-for"), (one) => WHAT[one.what]),
        num(say("statistics-standards-height"), (one) => formatLimit(one.height_m)),
        col(say("statistics-standards-rule"), (one) => ruleOf(inWords(one))),
        col(say("statistics-standards-source"), (one) => {
          const said = inWords(one);
          return (
            <>
              {sourceOf(said)}
              {said.cited_by && (
                <div class="muted small">{say("statistics-standard-cited", { by: said.cited_by })}</div>
              )}
            </>
          );
        }),
        actions(
          say("statistics-standards-remove"),
          (one) =>
            one.code === "own" && (
              <Button
                small
                icon="close"
                label={say("statistics-standard-remove", { standard: formatLimit(one.height_m) })}
                onClick={() => remove(one)}
              />
            ),
          "num",
        ),
      ]}
    />
  );
}

/** What distributions are read against; the others are for sight distances. */
const COMPARED: readonly string[] = Object.values(STANDARD_FOR);

/** "P10 of passenger cars" */
function ruleOf(one: Standard): string {
  if (one.percent === null) return one.vehicle_class;
  const percent = plainPercent(one.percent);
  if (!one.vehicle_class) return say("statistics-standard-percentile", { percent });
  return say("statistics-standard-rule", { percent, group: one.vehicle_class });
}

function sourceOf(one: Standard): string {
  const edition = one.edition || (one.year === null ? "" : String(one.year));
  return edition && !one.source.includes(edition)
    ? say("statistics-standard-edition", { source: one.source, edition })
    : one.source;
}

const nameOf = (what: Standard["what"]) => (what === "eye_car" ? "eye_limit_m" : "object_limit_m");

function remove(one: Standard): void {
  const name = nameOf(one.what);
  setFilter({ [name]: query.value.getAll(name).filter((value) => Number(value) !== one.height_m) });
}

function AddOwn() {
  const form = useForm({ what: "eye_car" as Standard["what"], text: "" });
  const { what, text } = form.values;
  const [problem, setProblem] = useState<string | null>(null);
  const add = () => {
    const metres = parseLength(text);
    if (metres === null || metres <= 0 || metres >= 10) {
      setProblem(say("statistics-standard-own-problem", { example: formatLength(1.1, 2) }));
      return;
    }
    setProblem(null);
    form.change({ text: "" });
    const name = nameOf(what);
    const value = String(Number(metres.toFixed(4)));
    setFilter({ [name]: [...new Set([...query.value.getAll(name), value])] });
  };
  return (
    <form class="stat-own" onSubmit={sent(add)}>
      <SelectField
        says="statistics-standard-own"
        {...form.field("what")}
        options={choices(WHAT, ["eye_car", "object_stopping"])}
      />
      <TextField
        says="statistics-standard-height"
        unit={lengthUnit.value}
        {...form.field("text")}
        problem={problem}
      />
      <Button says="action-add" type="submit" icon="add" />
    </form>
  );
}
