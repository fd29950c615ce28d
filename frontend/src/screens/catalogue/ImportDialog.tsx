import { choices, DataTable, Notice, OptionalField, SelectField } from "../../components";
import { api } from "../../core/api";
import { fieldsOf } from "../../core/form";
import { allOf, say, sentenceOf, wordsOf } from "../../core/messages";
import { formatCount } from "../../core/units";
import { ImportCsv } from "../../parts/ImportCsv";
import { SampleLink } from "../../parts/samples/SampleLink";
import { CHANGE_WORDS, FIELDS, type Plan, UNIT_WORDS, type Unit } from "./model";

interface Choices {
  /** Fields by header; "" leaves a column out. */
  columns: Readonly<Record<string, string>>;
  unit: Unit | null;
  on_conflict: "keep" | "replace";
}

const NO_CHOICES: Choices = { columns: {}, unit: null, on_conflict: "keep" };

const WORDS = wordsOf("catalogue-import-", "title", "choose", "drop", "hint", "looking");

/** A CSV into the catalogue: what it is taken for and what it would change, before anything is stored. */
export function ImportDialog({ close, imported }: { close: () => void; imported: () => void }) {
  return (
    <ImportCsv
      words={WORDS}
      usual={NO_CHOICES}
      look={(body, taken) => api.ask("POST /catalogue/import/preview", asked(taken), { body })}
      store={async (body, taken) => {
        const done = await api.write("POST /catalogue/import", asked(taken), { body });
        imported();
        return done;
      }}
      usable={(plan: Plan) => (plan.problem === null ? plan.stored : 0)}
      storeWords={(count) => say("catalogue-import-store", { count })}
      doneWords={({ added, updated }) => say("catalogue-import-done", { added, updated })}
      before={<SampleLink kind="catalogue" />}
      preview={(plan, taken, change) => <Preview plan={plan} taken={taken} change={change} />}
      onClose={close}
    />
  );
}

function asked({ columns, unit, on_conflict }: Choices) {
  const column = Object.entries(columns).map(([header, field]) => `${field}=${header}`);
  return { column, unit: unit ?? undefined, on_conflict };
}

interface PreviewProps {
  plan: Plan;
  taken: Choices;
  change: (part: Partial<Choices>) => void;
}

function Preview({ plan, taken, change }: PreviewProps) {
  const field = fieldsOf(taken, change);
  return (
    <>
      {plan.problem && <Notice kind="problem">{sentenceOf(plan.problem)}</Notice>}
      <div class="grid">
        <OptionalField
          says="catalogue-import-unit"
          {...field("unit")}
          none={say("catalogue-import-unit-header")}
          options={choices(UNIT_WORDS)}
        />
        <SelectField<Choices["on_conflict"]>
          says="catalogue-import-conflicts"
          {...field("on_conflict")}
          options={choices(wordsOf("catalogue-import-", "keep", "replace"))}
        />
      </div>
      <Columns plan={plan} taken={taken} change={change} />
      <p class="row row--wrap row--far" data-testid="catalogue-counts">
        {Object.entries(CHANGE_WORDS).map(([name, word]) => (
          <span key={name}>
            <strong>{formatCount(plan.counts[name as keyof typeof CHANGE_WORDS] ?? 0)}</strong> {word}
          </span>
        ))}
      </p>
      <Lines plan={plan} />
    </>
  );
}

function Columns({ plan, taken, change }: PreviewProps) {
  const skipped = plan.columns.filter((one) => !one.field).map((one) => `“${one.header}”`);
  return (
    <>
      <fieldset class="grid grid--4 catalogue-columns">
        <legend>{say("catalogue-import-columns")}</legend>
        {plan.columns.map((one, at) => (
          <OptionalField
            key={`${at} ${one.header}`}
            label={one.header}
            value={one.field}
            problem={sentenceOf(one.problem)}
            hint={one.unit ? say("catalogue-import-in", { unit: UNIT_WORDS[one.unit] }) : undefined}
            none={say("catalogue-import-left-out")}
            options={FIELDS.map((field) => ({ value: field, label: field }))}
            onInput={(field) => change({ columns: { ...taken.columns, [one.header]: field ?? "" } })}
          />
        ))}
      </fieldset>
      {skipped.length > 0 && (
        <Notice>
          {say("catalogue-import-some-left-out", { count: skipped.length, columns: allOf(skipped) })}
        </Notice>
      )}
    </>
  );
}

function Lines({ plan }: { plan: Plan }) {
  const shown = plan.rows.filter((row) => row.change !== "new");
  if (shown.length === 0) return null;
  return (
    <DataTable
      label={say("catalogue-import-lines")}
      scroll="tall"
      class="table--dense"
      data-testid="catalogue-lines"
      rows={shown}
      keyOf={(row) => row.line}
      columns={({ col, num }) => [
        num(say("catalogue-import-line"), (row) => row.line),
        col(say("catalogue-model"), (row) => (
          <>
            {row.make} {row.model} {row.year_from ?? ""}
          </>
        )),
        col(say("catalogue-import-what"), (row) => CHANGE_WORDS[row.change], "nowrap"),
        col(say("catalogue-import-why"), (row) => sentenceOf(row.words)),
      ]}
    />
  );
}
