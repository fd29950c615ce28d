import { useState } from "preact/hooks";
import { Button, Field, SelectField, TextField } from "../../components";
import { query } from "../../core/address";
import { lengthUnit, parseSmall, plural, smallScale, smallText } from "../../core/units";
import { fixedRange } from "../../parts/figures/numbers";
import { CORRECTIONS, type Correction, narrowed, type SingleName, setFilter, WIDE } from "./filters";
import { CATEGORY_WORDS, LIGHTING_WORDS, type Statistics, TARGET_TITLES } from "./model";

const CORRECTION_WORDS: Record<Correction, string> = {
  inset: "inset of each (default)",
  shift: "mean error (the paper’s)",
  none: "none (inset 0)",
  regression: "regression",
  deconvolution: "deconvolution",
};

const STATES = [
  { value: "", label: "accepted" },
  { value: "to_review", label: "to review" },
  { value: "rejected", label: "rejected" },
  { value: "all", label: "all" },
];

/** What counts, and how figures are made. Each change goes into the address, and from there to the server. */
export function FilterBar({ found }: { found: Statistics | null }) {
  const at = query.value;
  const choice = (name: SingleName, label: string, options: { value: string; label: string }[]) => (
    <SelectField
      label={label}
      value={at.get(name) ?? ""}
      options={options}
      onChange={(value) => setFilter({ [name]: value || null })}
    />
  );
  const words = (list: Record<string, string>, all: string) => [
    { value: "", label: all },
    ...Object.entries(list).map(([value, label]) => ({ value, label })),
  ];
  const operators = found?.operators.map((one) => ({ value: String(one.id), label: one.name })) ?? [];
  return (
    <form
      class="panel stat-filter stat-noprint"
      aria-label="Filter"
      onSubmit={(event) => event.preventDefault()}
    >
      <Surveys found={found} chosen={at.getAll("survey")} />
      {choice("state", "Review state", STATES)}
      {choice("target", "Target", words(TARGET_TITLES, "all"))}
      {choice("lighting", "Lighting", words(LIGHTING_WORDS, "any"))}
      {choice("category", "Category", words(CATEGORY_WORDS, "any"))}
      {choice("operator", "Operator", [{ value: "", label: "anybody" }, ...operators])}
      <Day name="first_day" label="Measured from (UTC)" value={at.get("first_day") ?? ""} />
      <Day name="last_day" label="to" value={at.get("last_day") ?? ""} />
      {choice("correction", "Correction", [
        ...CORRECTIONS.map((one) => ({ value: one === "inset" ? "" : one, label: CORRECTION_WORDS[one] })),
      ])}
      {choice("rounding", "Error table", [
        { value: "", label: "whole cm (the paper’s)" },
        { value: "none", label: "not rounded" },
      ])}
      <ReferenceU value={at.get("u_reference_m")} />
      {narrowed(at) && (
        <div class="stat-filter__clear">
          <Button small onClick={() => setFilter(WIDE)}>
            Clear the filter
          </Button>
        </div>
      )}
    </form>
  );
}

/** Which surveys: all, one, or several. */
function Surveys({ found, chosen }: { found: Statistics | null; chosen: readonly string[] }) {
  const list = found?.surveys ?? [];
  const only = chosen.length === 1 ? list.find((one) => String(one.id) === chosen[0]) : undefined;
  const word = chosen.length === 0 ? "all surveys" : (only?.name ?? plural(chosen.length, "survey"));
  const toggle = (id: string, on: boolean) =>
    setFilter({ survey: on ? [...chosen, id] : chosen.filter((one) => one !== id) });
  return (
    <div class="field">
      <span class="field__label" id="stat-surveys">
        Surveys
      </span>
      <details class="stat-surveys">
        <summary class="input clip" aria-describedby="stat-surveys">
          {word}
        </summary>
        <fieldset class="stat-surveys__list">
          <legend class="visually-hidden">Surveys that count; none chosen: all</legend>
          {list.map((one) => (
            <label key={one.id} class="row">
              <input
                type="checkbox"
                checked={chosen.includes(String(one.id))}
                onChange={(event) => toggle(String(one.id), event.currentTarget.checked)}
              />
              {one.name}
            </label>
          ))}
          {chosen.length > 0 && (
            <Button small onClick={() => setFilter({ survey: null })}>
              All surveys
            </Button>
          )}
        </fieldset>
      </details>
    </div>
  );
}

function Day({ name, label, value }: { name: "first_day" | "last_day"; label: string; value: string }) {
  return (
    <Field label={label}>
      {(wiring) => (
        <input
          {...wiring}
          class="input"
          type="date"
          value={value}
          onChange={(event) => setFilter({ [name]: event.currentTarget.value || null })}
        />
      )}
    </Field>
  );
}

const USUAL_U_M = 0.0173;

/** The standard uncertainty of reference heights that have none of their own, as a small length. */
function ReferenceU({ value }: { value: string | null }) {
  const [problem, setProblem] = useState<string | null>(null);
  const now = value === null ? USUAL_U_M : Number(value);
  const [, unit] = smallScale();
  const [text, setText] = useState<string | null>(null);
  const send = (typed: string) => {
    const read = typed.trim() ? parseSmall(typed) : USUAL_U_M;
    const wrong = read === null || read < 0;
    setProblem(wrong ? `Give a number of ${unit === "in" ? "inches" : "millimetres"}.` : null);
    if (wrong) return;
    setText(null);
    const metres = Number(read.toFixed(6));
    setFilter({ u_reference_m: metres === USUAL_U_M ? null : String(metres) });
  };
  return (
    <TextField
      label="u of a reference height"
      hint={`as if within ±${fixedRange(Math.sqrt(3) * now)}, all alike`}
      numeric
      unit={unit}
      value={text ?? smallText(now, lengthUnit.value, 2)}
      problem={problem}
      onInput={setText}
      onChange={send}
    />
  );
}
