import { useId, useState } from "preact/hooks";
import { Button, FormDialog, Problem, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import type { Study } from "../../core/types";

interface Props {
  study: Study;
  close: () => void;
  saved: () => void;
}

interface Row {
  survey_id: number;
  name: string;
  site: string;
  stratum: string;
  year: string;
}

/** What a study joins and how it weighs: sent as a whole, refused in one sentence where it does not hold together. */
export function StudyDialog({ study, close, saved }: Props) {
  const [name, setName] = useState(study.name);
  const [description, setDescription] = useState(study.description);
  const [rows, setRows] = useState<readonly Row[]>(
    study.surveys.map((one) => ({ ...one, year: one.year === null ? "" : String(one.year) })),
  );
  const [fleet, setFleet] = useState(study.fleet_csv);
  const [sites, setSites] = useState(study.sites_csv);
  const [goal, setGoal] = useState(String(1000 * study.goal_m));
  const submit = async () => {
    await api.write(
      "PUT /studies/{study_id}",
      { study_id: study.id },
      {
        body: {
          name,
          description,
          version: study.version,
          surveys: rows.map(({ survey_id, site, stratum, year }) => ({
            survey_id,
            site,
            stratum,
            year: year.trim() ? Math.round(Number(year)) || 0 : null,
          })),
          fleet_csv: fleet,
          sites_csv: sites,
          goal_m: Number(goal) / 1000 || 0,
        },
      },
    );
    saved();
  };
  return (
    <FormDialog
      wide
      title={say("study-edit-title")}
      action={say("action-save")}
      onClose={close}
      submit={submit}
    >
      <TextField label={say("study-name")} value={name} onInput={setName} />
      <TextField label={say("study-description")} value={description} onInput={setDescription} rows={2} />
      <Surveys rows={rows} change={setRows} />
      <Table
        label={say("study-fleet")}
        hint={say("study-fleet-hint")}
        value={fleet}
        change={setFleet}
        example="category,share"
      />
      <Table
        label={say("study-sites")}
        hint={say("study-sites-hint")}
        value={sites}
        change={setSites}
        example="site,stratum"
      />
      <TextField
        label={say("study-goal")}
        hint={say("study-goal-hint")}
        value={goal}
        onInput={setGoal}
        numeric
        unit={say("study-goal-unit")}
      />
    </FormDialog>
  );
}

function Surveys({ rows, change }: { rows: readonly Row[]; change: (rows: readonly Row[]) => void }) {
  const surveys = useResource((signal) => api.ask("GET /surveys", {}, { signal }), []);
  const there = new Set(rows.map((one) => one.survey_id));
  const others = surveys.data?.filter((one) => !there.has(one.id)) ?? [];
  const set = (id: number, changed: Partial<Row>) =>
    change(rows.map((one) => (one.survey_id === id ? { ...one, ...changed } : one)));
  const add = (id: string) => {
    const survey = others.find((one) => String(one.id) === id);
    if (!survey) return;
    const site = survey.site || survey.name;
    change([...rows, { survey_id: survey.id, name: survey.name, site, stratum: "", year: "" }]);
  };
  return (
    <fieldset class="study-surveys">
      <legend>{say("study-joined")}</legend>
      {rows.map((one) => (
        <div class="study-surveys__row" key={one.survey_id}>
          <span class="study-surveys__name">{one.name}</span>
          <TextField
            label={say("study-site")}
            value={one.site}
            onInput={(site) => set(one.survey_id, { site })}
          />
          <TextField
            label={say("study-stratum")}
            value={one.stratum}
            onInput={(stratum) => set(one.survey_id, { stratum })}
          />
          <TextField
            label={say("study-year")}
            value={one.year}
            onInput={(year) => set(one.survey_id, { year })}
            numeric
          />
          <Button
            small
            kind="quiet"
            icon="close"
            label={say("study-take-out", { name: one.name })}
            onClick={() => change(rows.filter((other) => other !== one))}
          />
        </div>
      ))}
      <Problem error={surveys.error} again={surveys.reload} />
      <SelectField
        label={say("study-add-survey")}
        value=""
        options={[
          { value: "", label: say(others.length > 0 ? "study-choose-survey" : "study-no-more-surveys") },
          ...others.map((one) => ({ value: String(one.id), label: one.name })),
        ]}
        onChange={add}
      />
      <p class="field__hint">{say("study-surveys-hint")}</p>
    </fieldset>
  );
}

interface TableProps {
  label: string;
  hint: string;
  value: string;
  change: (text: string) => void;
  example: string;
}

/** A table as CSV: from a file, or typed. */
function Table({ label, hint, value, change, example }: TableProps) {
  const id = useId();
  return (
    <div class="study-table">
      <TextField label={label} hint={hint} value={value} onInput={change} rows={4} placeholder={example} />
      <label class="btn btn--small" for={id}>
        {say("study-choose-file")}
        <input
          id={id}
          class="visually-hidden"
          type="file"
          accept=".csv,text/csv"
          aria-label={say("study-choose-file-of", { table: label })}
          onChange={(event) => {
            const file = event.currentTarget.files?.[0];
            event.currentTarget.value = "";
            void file?.text().then(change);
          }}
        />
      </label>
    </div>
  );
}
