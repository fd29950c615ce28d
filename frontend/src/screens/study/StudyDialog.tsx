import { useId, useState } from "preact/hooks";
import { FormDialog, IconButton, named, OptionalField, Problem, TextField } from "../../components";
import { api } from "../../core/api";
import { fieldsOf, useForm } from "../../core/form";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { Study, StudySurveyBody } from "../../core/types";
import { parseNumber } from "../../core/units";

type Row = Omit<StudySurveyBody, "year"> & { year: string };

/** What a study joins and how it weighs: sent as a whole, refused in one sentence where it does not hold together. */
export function StudyDialog({ study, close, saved }: { study: Study; close: () => void; saved: () => void }) {
  const { values, field } = useForm(() => {
    const { name, description, fleet_csv, sites_csv } = study;
    return { name, description, fleet_csv, sites_csv, goal: String(1000 * study.goal_m) };
  });
  const [rows, setRows] = useState<readonly Row[]>(
    study.surveys.map((one) => ({ ...one, year: one.year === null ? "" : String(one.year) })),
  );
  const submit = async () => {
    const { goal, ...words } = values;
    const surveys = rows.map(({ survey_id, site, stratum, year }) => ({
      survey_id,
      site,
      stratum,
      year: year.trim() ? Math.round(parseNumber(year) ?? 0) : null,
    }));
    const body = { ...words, version: study.version, surveys, goal_m: (parseNumber(goal) ?? 0) / 1000 };
    await api.write("PUT /studies/{study_id}", { study_id: study.id }, { body });
    saved();
  };
  return (
    <FormDialog wide says="study-edit-title" action={say("action-save")} onClose={close} submit={submit}>
      <TextField says="study-name" {...field("name")} />
      <TextField says="study-description" {...field("description")} rows={2} />
      <Surveys rows={rows} change={setRows} />
      <Table
        label={say("study-fleet")}
        hint={say("study-fleet-hint")}
        {...field("fleet_csv")}
        example="category,share"
      />
      <Table
        label={say("study-sites")}
        hint={say("study-sites-hint")}
        {...field("sites_csv")}
        example="site,stratum"
      />
      <TextField
        says="study-goal"
        hint={say("study-goal-hint")}
        {...field("goal")}
        unit={say("study-goal-unit")}
      />
    </FormDialog>
  );
}

function Surveys({ rows, change }: { rows: readonly Row[]; change: (rows: readonly Row[]) => void }) {
  const surveys = useAsked("GET /surveys");
  const there = new Set(rows.map((one) => one.survey_id));
  const others = surveys.data?.filter((one) => !there.has(one.id)) ?? [];
  const field = (row: Row) =>
    fieldsOf(row, (part) => change(rows.map((one) => (one === row ? { ...one, ...part } : one))));
  const add = (id: string | null) => {
    const survey = others.find((one) => String(one.id) === id);
    if (!survey) return;
    const site = survey.site || survey.name;
    change([...rows, { survey_id: survey.id, name: survey.name, site, stratum: "", year: "" }]);
  };
  return (
    <fieldset class="stack stack--near pad study-surveys">
      <legend>{say("study-joined")}</legend>
      {rows.map((one) => (
        <div class="study-surveys__row" key={one.survey_id}>
          <span class="study-surveys__name">{one.name}</span>
          <TextField says="study-site" {...field(one)("site")} />
          <TextField says="study-stratum" {...field(one)("stratum")} />
          <TextField says="study-year" {...field(one)("year")} numeric />
          <IconButton
            icon="close"
            label={say("study-take-out", { name: one.name })}
            onClick={() => change(rows.filter((other) => other !== one))}
          />
        </div>
      ))}
      <Problem error={surveys.error} again={surveys.reload} />
      <OptionalField
        says="study-add-survey"
        value={null}
        none={say(others.length > 0 ? "study-choose-survey" : "study-no-more-surveys")}
        options={named(others)}
        onInput={add}
      />
      <p class="field__hint">{say("study-surveys-hint")}</p>
    </fieldset>
  );
}

interface TableProps {
  label: string;
  hint: string;
  value: string;
  onInput: (text: string) => void;
  example: string;
}

function Table({ example, onInput, ...field }: TableProps) {
  const id = useId();
  return (
    <div class="stack stack--tight study-table">
      <TextField {...field} onInput={onInput} rows={4} placeholder={example} />
      <label class="btn btn--small" for={id}>
        {say("study-choose-file")}
        <input
          id={id}
          class="visually-hidden"
          type="file"
          accept=".csv,text/csv"
          aria-label={say("study-choose-file-of", { table: field.label })}
          onChange={(event) => {
            const file = event.currentTarget.files?.[0];
            event.currentTarget.value = "";
            void file?.text().then(onInput);
          }}
        />
      </label>
    </div>
  );
}
