import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { refreshSurvey } from "../../core/survey";
import type { Inset, Survey, Target } from "../../core/types";
import { lengthText, lengthUnit, parseLength } from "../../core/units";

const TARGETS: { key: Target; label: string }[] = [
  { key: "roof", label: "Roof" },
  { key: "driver_eye", label: "Driver’s eye" },
  { key: "taillight", label: "Taillight" },
  { key: "headlight", label: "Headlight" },
  { key: "other", label: "Other" },
];

type Typed = Record<Target, { inset: string; u: string }>;

/** Name, site, description, and how far each target usually lies behind the side plane. */
export function EditSurvey({ survey, close }: { survey: Survey; close: () => void }) {
  const [name, setName] = useState(survey.name);
  const [site, setSite] = useState(survey.site);
  const [description, setDescription] = useState(survey.description);
  const [insets, setInsets] = useState<Typed>(() => typedInsets(survey));
  const [wrong, setWrong] = useState<string | null>(null);
  const submit = () => {
    const read = readInsets(insets, survey);
    setWrong(typeof read === "string" ? read : null);
    return typeof read === "string" ? null : save(read);
  };
  const save = async (read: Record<Target, Inset>) => {
    await api.write(
      "PUT /surveys/{survey_id}",
      { survey_id: survey.id },
      {
        body: {
          name,
          site,
          description,
          insets: read,
          version: survey.version,
        },
      },
    );
    await refreshSurvey();
    close();
  };
  const change = (key: Target, part: "inset" | "u", value: string) =>
    setInsets({ ...insets, [key]: { ...insets[key], [part]: value } });
  return (
    <FormDialog title="Edit the survey" action="Save" onClose={close} submit={submit}>
      <TextField
        label="Name"
        value={name}
        onInput={setName}
        problem={name.trim() ? null : "A survey needs a name."}
      />
      <TextField label="Site" value={site} onInput={setSite} />
      <TextField label="Description" value={description} onInput={setDescription} rows={3} />
      <fieldset class="insets">
        <legend>Insets</legend>
        <p class="field__hint">
          How far each target lies behind the plane through the tyres’ outer faces, away from the camera. Used
          for every new measurement; the second figure is its standard uncertainty.
        </p>
        <table class="table">
          <thead>
            <tr>
              <th>Target</th>
              <th class="num">inset ({lengthUnit.value})</th>
              <th class="num">± u ({lengthUnit.value})</th>
            </tr>
          </thead>
          <tbody>
            {TARGETS.map(({ key, label }) => (
              <tr key={key}>
                <td>
                  {label}
                  {survey.insets[key]?.note && <div class="field__hint">{survey.insets[key].note}</div>}
                </td>
                <td>
                  <TextField
                    hideLabel
                    numeric
                    label={`${label}: inset in ${unitWord()}`}
                    value={insets[key].inset}
                    onInput={(v) => change(key, "inset", v)}
                  />
                </td>
                <td>
                  <TextField
                    hideLabel
                    numeric
                    label={`${label}: uncertainty in ${unitWord()}`}
                    value={insets[key].u}
                    onInput={(v) => change(key, "u", v)}
                  />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
        {wrong && <p class="field__problem">{wrong}</p>}
      </fieldset>
    </FormDialog>
  );
}

function typedInsets(survey: Survey): Typed {
  const typed = {} as Typed;
  for (const { key } of TARGETS) {
    const inset = survey.insets[key];
    typed[key] = { inset: lengthText(inset?.inset_m ?? 0), u: lengthText(inset?.u_inset_m ?? 0) };
  }
  return typed;
}

function readInsets(typed: Typed, survey: Survey): Record<Target, Inset> | string {
  const read = {} as Record<Target, Inset>;
  for (const { key, label } of TARGETS) {
    const before = survey.insets[key];
    const inset_m = metresOf(typed[key].inset, before?.inset_m);
    const u_inset_m = metresOf(typed[key].u, before?.u_inset_m);
    if (inset_m === null || u_inset_m === null || u_inset_m < 0) {
      const example = `${lengthText(0.12, lengthUnit.value, 2)} and ${lengthText(0.05, lengthUnit.value, 2)}`;
      return `${label}: give the inset and its uncertainty as numbers in ${unitWord()}, for example ${example}.`;
    }
    read[key] = { inset_m, u_inset_m, note: before?.note ?? "" };
  }
  return read;
}

/** A typed length; one that was left as it stood is not rounded by having been shown. */
function metresOf(text: string, before: number | undefined): number | null {
  return before !== undefined && text === lengthText(before) ? before : parseLength(text);
}

function unitWord(): string {
  return lengthUnit.value === "ft" ? "feet" : "metres";
}
