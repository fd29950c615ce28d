/** Which passes of a survey are to be measured, and how many of each lighting and set of classes. */
import { useState } from "preact/hooks";
import { Check, choices, FormDialog, SelectField, TextField } from "../../components";
import { fieldsOf } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { changeSurvey } from "../../core/survey";
import type { ClassSet, Lighting, Quota, Sampling, Survey } from "../../core/types";
import { parseNumber } from "../../core/units";
import { CLASS_SET_WORDS, LIGHTING_WORDS } from "../../core/words";
import { quotaWords } from "../../parts/vehicles/SampleQuotas";

const METHODS = wordsOf("sample-", "every", "nth", "share");

type Typed = ReturnType<typeof typedOf>;

/** Every lighting with every set, and with vehicles of any class. */
const KINDS = (Object.keys(LIGHTING_WORDS) as Lighting[]).flatMap((lighting) =>
  [null, ...(Object.keys(CLASS_SET_WORDS) as ClassSet[])].map((class_set) => ({ lighting, class_set })),
);
const keyOf = ({ lighting, class_set }: Pick<Quota, "lighting" | "class_set">) => `${lighting}.${class_set}`;

export function SamplingDialog({ survey, close }: { survey: Survey; close: () => void }) {
  const [typed, setTyped] = useState<Typed>(() => typedOf(survey.sampling));
  const change = (part: Partial<Typed>) => setTyped({ ...typed, ...part });
  const wrong = problemsOf(typed);
  const submit = async () => {
    if (Object.values(wrong).some(Boolean)) return;
    await changeSurvey(survey, { sampling: samplingOf(typed) });
    close();
  };
  const field = fieldsOf(typed, change);
  return (
    <FormDialog says="sample-dialog" action={say("action-save")} onClose={close} submit={submit}>
      <SelectField
        says="sample-method"
        {...field("method")}
        options={choices(METHODS)}
        hint={say("sample-method-help")}
      />
      {typed.method === "nth" && (
        <div class="row row--wrap">
          <TextField numeric says="sample-step" {...field("step")} problem={wrong.step} />
          <TextField numeric says="sample-start" {...field("start")} problem={wrong.start} />
        </div>
      )}
      {typed.method === "share" && (
        <div class="row row--wrap">
          <TextField unit="%" says="sample-share-percent" {...field("share")} problem={wrong.share} />
          <TextField numeric says="sample-seed" {...field("seed")} problem={wrong.seed} />
        </div>
      )}
      <TextField
        unit="s"
        says="sample-free"
        hint={say("sample-free-help")}
        {...field("free")}
        problem={wrong.free}
      />
      <Check
        says="sample-outside-counts"
        checked={typed.outside}
        onInput={(outside) => change({ outside })}
      />
      <p class="field__hint">{say("sample-outside-counts-help")}</p>
      <fieldset class="survey-fields">
        <legend>{say("sample-quotas")}</legend>
        <p class="field__hint">{say("sample-quotas-help")}</p>
        <div class="grid grid--fit grid--low" style={{ "--least": "208px" }}>
          {KINDS.map((kind) => (
            <TextField
              key={keyOf(kind)}
              numeric
              label={quotaWords(kind)}
              value={typed.quotas[keyOf(kind)] ?? ""}
              problem={wholeOf(typed.quotas[keyOf(kind)] || "1", 1, 1e6) ? null : say("sample-quota-problem")}
              onInput={(count) => change({ quotas: { ...typed.quotas, [keyOf(kind)]: count } })}
            />
          ))}
        </div>
      </fieldset>
    </FormDialog>
  );
}

function typedOf(rule: Sampling) {
  return {
    method: rule.method,
    step: String(rule.method === "nth" ? rule.step : 2),
    start: String(rule.method === "nth" ? rule.start : 1),
    share: String(rule.method === "share" ? rule.share_percent : 50),
    seed: String(rule.seed),
    free: rule.free_flowing_s === null ? "" : String(rule.free_flowing_s),
    quotas: Object.fromEntries(rule.quotas.map((one) => [keyOf(one), String(one.wanted)])),
    outside: rule.outside_counts,
  };
}

function wholeOf(text: string, least: number, most: number): number | null {
  const value = /^\s*\d+\s*$/.test(text) ? Number(text) : Number.NaN;
  return value >= least && value <= most ? value : null;
}

function amountOf(text: string, most: number): number | null {
  const value = parseNumber(text);
  return value !== null && value > 0 && value <= most ? value : null;
}

function problemsOf(
  typed: Typed,
): Record<"step" | "start" | "share" | "seed" | "free" | "quotas", string | null> {
  const of = (wrong: boolean, problem: () => string) => (wrong ? problem() : null);
  const step = wholeOf(typed.step, 2, 1000);
  const [nth, share] = [typed.method === "nth", typed.method === "share"];
  const quotas = Object.values(typed.quotas);
  return {
    step: of(nth && step === null, () => say("sample-step-problem")),
    start: of(nth && wholeOf(typed.start, 1, step ?? 1000) === null, () => say("sample-start-problem")),
    share: of(share && amountOf(typed.share, 100) === null, () => say("sample-share-problem")),
    seed: of(share && wholeOf(typed.seed, 0, 2 ** 31 - 1) === null, () => say("sample-seed-problem")),
    free: of(typed.free.trim() !== "" && amountOf(typed.free, 60) === null, () => say("sample-free-problem")),
    quotas: of(
      quotas.some((text) => wholeOf(text || "1", 1, 1e6) === null),
      () => say("sample-quota-problem"),
    ),
  };
}

function samplingOf(typed: Typed): Sampling {
  const nth = typed.method === "nth";
  const share = typed.method === "share";
  return {
    method: typed.method,
    step: nth ? Number(typed.step) : 1,
    start: nth ? Number(typed.start) : 1,
    share_percent: share ? (amountOf(typed.share, 100) ?? 100) : 100,
    seed: share ? Number(typed.seed) : 1,
    free_flowing_s: amountOf(typed.free, 60),
    outside_counts: typed.outside,
    quotas: KINDS.flatMap((kind) => {
      const wanted = wholeOf(typed.quotas[keyOf(kind)] ?? "", 1, 1e6);
      return wanted === null ? [] : [{ ...kind, wanted }];
    }),
  };
}
