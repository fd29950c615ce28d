/** What a survey makes of the classes of its vehicles: the set that each counts in, and what the EU and FHWA call it. */
import { useState } from "preact/hooks";
import { choices, FormDialog, OptionalField, Table, TextField } from "../../components";
import { fieldsOf } from "../../core/form";
import { say } from "../../core/messages";
import { changeSurvey } from "../../core/survey";
import type { Survey, VehicleClass } from "../../core/types";
import { CATEGORY_WORDS, CLASS_SET_WORDS } from "../../core/words";

type Eu = VehicleClass["eu"][number];
const EU: readonly Eu[] = ["L", "M1", "M2", "M3", "N1", "N2", "N3", "O1", "O2", "O3", "O4", "T"];

type Typed = ReturnType<typeof typed>;

export function ClassesDialog({ survey, close }: { survey: Survey; close: () => void }) {
  const [rows, setRows] = useState<Typed[]>(() => survey.classes.map(typed));
  const change = (category: string, part: Partial<Typed>) =>
    setRows(rows.map((row) => (row.category === category ? { ...row, ...part } : row)));
  const submit = async () => {
    const read = rows.map(readClass);
    const classes = read.filter((one) => one !== null);
    if (classes.length === read.length) await changeSurvey(survey, { classes }).then(close);
  };
  return (
    <FormDialog wide says="classes-title" action={say("action-save")} onClose={close} submit={submit}>
      <p class="field__hint">{say("classes-help")}</p>
      <Table
        label={say("classes-title")}
        class="table--middle classes"
        heads={[say("classes-class"), say("classes-set"), say("classes-eu"), say("classes-fhwa")]}
      >
        {rows.map((row) => (
          <ClassRow key={row.category} row={row} change={(part) => change(row.category, part)} />
        ))}
      </Table>
    </FormDialog>
  );
}

function ClassRow({ row, change }: { row: Typed; change(part: Partial<Typed>): void }) {
  const word = CATEGORY_WORDS[row.category];
  const field = fieldsOf(row, change);
  return (
    <tr>
      <td class="nowrap">{word}</td>
      <td>
        <OptionalField
          hideLabel
          label={say("classes-set-of", { category: word })}
          {...field("class_set")}
          none={say("class-set-none")}
          options={choices(CLASS_SET_WORDS)}
        />
      </td>
      {(["eu", "fhwa"] as const).map((name) => (
        <td key={name}>
          <TextField
            hideLabel
            label={say(`classes-${name}-of`, { category: word })}
            {...field(name)}
            problem={READ[name](row[name]) ? null : say(`classes-${name}-problem`)}
          />
        </td>
      ))}
    </tr>
  );
}

function typed({ category, class_set, eu, fhwa }: VehicleClass) {
  return { category, class_set, eu: eu.join(" "), fhwa: fhwa.join(" ") };
}

function words(text: string): string[] {
  return text.split(/[\s,;]+/).filter(Boolean);
}

/** EU classes out of what was typed; null where one is not known. */
export function euOf(text: string): Eu[] | null {
  const found = words(text).map((word) => EU.find((one) => one === word.toUpperCase()));
  return found.every((one) => one !== undefined) ? (found as Eu[]) : null;
}

/** Classes of FHWA, 1 to 13, out of what was typed ("5 6 7" or "8-13"); null where one is none of them. */
export function fhwaOf(text: string): number[] | null {
  const found = words(text).flatMap((word) => {
    const [first, last = first] = word.split(/[-–]/).map(Number);
    if (first === undefined || !(first >= 1 && (last as number) <= 13 && first <= (last as number)))
      return [NaN];
    return Array.from({ length: (last as number) - first + 1 }, (_, k) => first + k);
  });
  return found.every(Number.isInteger) ? found : null;
}

const READ = { eu: euOf, fhwa: fhwaOf };

function readClass({ category, class_set, eu, fhwa }: Typed): VehicleClass | null {
  const [inEu, inFhwa] = [euOf(eu), fhwaOf(fhwa)];
  return inEu && inFhwa ? { category, class_set, eu: inEu, fhwa: inFhwa } : null;
}
