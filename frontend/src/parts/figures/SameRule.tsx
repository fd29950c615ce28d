import { DataTable, Panel } from "../../components";
import { say, sentenceOf, withUnit, wordsOf } from "../../core/messages";
import { lengthScale, plainHeight, plainPercent, plainSmall, smallScale } from "../../core/units";
import "./figures.css";
import type { RuleToday } from "../../core/types";
import { NONE, percent } from "./numbers";
import { inWords } from "./standards";

/** What is shown of a rule; the server says more of its standard. */
type Rule = Omit<RuleToday, "standard" | "by_pose_m"> & {
  standard: Pick<RuleToday["standard"], "name" | "what" | "height_m" | "percent" | "vehicle_class" | "code">;
};

/** The height that the rule of a standard is a percentile of. */
const HEIGHT_OF: Readonly<Record<RuleToday["standard"]["what"], string>> = wordsOf({
  eye_car: "target-driver_eye",
  eye_truck: "target-driver_eye",
  object_stopping: "statistics-taillight",
  object_passing: "statistics-taillight",
  headlight: "target-headlight",
  vehicle: "target-roof",
});

const SMALLEST_RISK = 0.001; // draws tell no smaller one

interface Props {
  rules: readonly Rule[];
  /** Whether they are on vehicles of chosen classes alone. */
  ofChosen: boolean;
}

/** The percentile that each standard is set by, in today's heights of its class, and what may be said of it. */
export function SameRule({ rules, ofChosen }: Props) {
  const there = rules.filter((one) => one.n > 0);
  if (there.length === 0) return null;
  const unit = lengthScale()[1];
  return (
    <Panel says="statistics-rule-title" data-testid="same-rule">
      {there.every((one) => one.verdict === "unknown") && (
        <p class="stat-notes">{say("statistics-rule-none")}</p>
      )}
      <DataTable
        label={say("statistics-rule-title")}
        rows={there}
        keyOf={(one) => `${one.standard.name}|${one.standard.what}`}
        columns={({ col, num, rowHead }) => [
          rowHead(say("statistics-rule-standard"), (one) => inWords(one.standard).name),
          col(say("statistics-rule-rule"), (one) => (
            <>
              {say("statistics-rule-of", {
                what: HEIGHT_OF[one.standard.what],
                percent: plainPercent(one.standard.percent),
                class: inWords(one.standard).vehicle_class,
              })}
              <div class="stat-ci">
                {say("statistics-rule-read", {
                  whose: say("statistics-rule-whose", {
                    whose: one.whose,
                    chosen: ofChosen ? "yes" : "no",
                  }),
                  n: one.n,
                })}
              </div>
            </>
          )),
          num(say("statistics-rule-height", { unit }), (one) => plainHeight(one.standard.height_m)),
          num(say("statistics-rule-today", { unit }), (one) => (
            <>
              {one.value_m === null ? NONE : <strong>{plainHeight(one.value_m)}</strong>}
              {one.U95_low_m !== null && one.U95_high_m !== null && (
                <div class="stat-ci">
                  {say("statistics-rule-interval", {
                    low: plainHeight(one.U95_low_m),
                    high: plainHeight(one.U95_high_m),
                  })}
                </div>
              )}
            </>
          )),
          num(withUnit(say("statistics-rule-difference"), smallScale()[1]), (one) =>
            plainSmall(one.difference_m, { signed: true }),
          ),
          col(say("statistics-rule-verdict"), (one) => verdict(one)),
        ]}
      />
      <p class="stat-notes small">{say("statistics-rule-note")}</p>
    </Panel>
  );
}

function verdict({ verdict: word, lower, risk, reason }: Rule): string {
  if (word === "unknown" || lower === null)
    return say("statistics-rule-unknown", { reason: sentenceOf(reason) ?? "" });
  if (word === "alike") return say("statistics-rule-alike", { lower: percent(lower) });
  const small = risk === null || risk < SMALLEST_RISK;
  const said = small ? say("statistics-rule-least", { risk: percent(SMALLEST_RISK) }) : percent(risk);
  return say(word === "lower" ? "statistics-rule-lower" : "statistics-rule-higher", { risk: said });
}
