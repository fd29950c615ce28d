import { useState } from "preact/hooks";
import { FormDialog, num, Table, TextField } from "../../components";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import { changeSurvey } from "../../core/survey";
import type { Inset, InsetName, Survey } from "../../core/types";
import { keptLength, lengthText, lengthUnit } from "../../core/units";
import { INSET_NAMES, INSET_WORDS, insetNote } from "../../core/words";
import { AskedFields } from "../../parts/vehicles/AskedFields";
import { PlaceFields, readPlace, typedPlace } from "../../parts/vehicles/PlaceFields";
import { TrafficFields } from "../../parts/vehicles/TrafficFields";

const PART_WORDS = { inset: "survey-inset-label", u: "survey-inset-u-label" } as const;

type Typed = Record<InsetName, { inset: string; u: string }>;

export function EditSurvey({ survey, close }: { survey: Survey; close: () => void }) {
  const { values, field } = useForm(() => {
    const { name, site, description, traffic, asked } = survey;
    return { name, site, description, traffic, asked, place: typedPlace(survey.place) };
  });
  const [insets, setInsets] = useState<Typed>(() => typedInsets(survey));
  const [wrong, setWrong] = useState<string | null>(null);
  const [misplaced, setMisplaced] = useState<string | null>(null);
  const submit = async () => {
    const read = readInsets(insets, survey);
    const placed = readPlace(values.place, survey.place);
    setWrong(typeof read === "string" ? read : null);
    setMisplaced(typeof placed === "string" ? placed : null);
    if (typeof read === "string" || typeof placed === "string" || !values.name.trim()) return;
    await changeSurvey(survey, { ...values, place: placed, insets: read });
    close();
  };
  const unit = lengthUnit.value;
  const change = (key: InsetName, part: "inset" | "u", value: string) =>
    setInsets({ ...insets, [key]: { ...insets[key], [part]: value } });
  return (
    <FormDialog says="survey-edit-title" action={say("action-save")} onClose={close} submit={submit}>
      <TextField
        says="survey-name"
        {...field("name")}
        problem={values.name.trim() ? null : say("survey-name-problem")}
      />
      <TextField says="survey-site" {...field("site")} />
      <TextField says="survey-description" {...field("description")} rows={3} />
      <PlaceFields {...field("place")} />
      {misplaced && <p class="field__problem">{misplaced}</p>}
      <TrafficFields {...field("traffic")} />
      <AskedFields {...field("asked")} />
      <fieldset class="insets">
        <legend>{say("survey-insets")}</legend>
        <p class="field__hint">{say("survey-insets-help")}</p>
        <Table
          class="below"
          heads={[
            say("survey-insets-target"),
            num(say("survey-insets-inset", { unit })),
            num(say("survey-insets-u", { unit })),
          ]}
        >
          {INSET_NAMES.map((key) => (
            <tr key={key}>
              <td>
                {INSET_WORDS[key]}
                {survey.insets[key]?.note && <div class="field__hint">{insetNote(survey.insets[key])}</div>}
              </td>
              {(["inset", "u"] as const).map((part) => (
                <td key={part}>
                  <TextField
                    hideLabel
                    numeric
                    label={say(PART_WORDS[part], { target: INSET_WORDS[key], unit })}
                    value={insets[key][part]}
                    onInput={(text) => change(key, part, text)}
                  />
                </td>
              ))}
            </tr>
          ))}
        </Table>
        {wrong && <p class="field__problem">{wrong}</p>}
      </fieldset>
    </FormDialog>
  );
}

function typedInsets(survey: Survey): Typed {
  const typed = {} as Typed;
  for (const key of INSET_NAMES) {
    const inset = survey.insets[key];
    typed[key] = { inset: lengthText(inset?.inset_m ?? 0), u: lengthText(inset?.u_inset_m ?? 0) };
  }
  return typed;
}

function readInsets(typed: Typed, survey: Survey): Record<InsetName, Inset> | string {
  const read = {} as Record<InsetName, Inset>;
  for (const key of INSET_NAMES) {
    const before = survey.insets[key];
    const inset_m = keptLength(typed[key].inset, before?.inset_m);
    const u_inset_m = keptLength(typed[key].u, before?.u_inset_m);
    if (inset_m === null || u_inset_m === null || u_inset_m < 0) {
      const unit = lengthUnit.value;
      const inset = lengthText(0.12, unit, 2);
      const u_inset = lengthText(0.05, unit, 2);
      return say("survey-inset-problem", { target: INSET_WORDS[key], unit, inset, u_inset });
    }
    read[key] = { inset_m, u_inset_m, note: before?.note ?? "", code: before?.code ?? null };
  }
  return read;
}
