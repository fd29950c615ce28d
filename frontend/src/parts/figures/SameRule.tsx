import { TableScroll } from "../../components";
import { say } from "../../core/messages";
import { lengthScale, plainHeight, plainSmall, smallScale } from "../../core/units";
import "./figures.css";
import { NONE, percent } from "./numbers";
import type { RuleToday } from "./types";

/** What is shown of a rule; the server says more of its standard. */
export type Rule = Omit<RuleToday, "standard" | "by_pose_m"> & {
  standard: Pick<RuleToday["standard"], "name" | "what" | "height_m" | "percent" | "vehicle_class">;
};

const SMALLEST_RISK = 0.001; // draws tell no smaller one

/** The percentile that each standard is set by, in today's heights of its class, and what may be said of it. */
export function SameRule({ rules }: { rules: readonly Rule[] }) {
  const there = rules.filter((one) => one.n > 0);
  if (there.length === 0) return null;
  const unit = lengthScale()[1];
  return (
    <section class="panel" aria-labelledby="stat-rules" data-testid="same-rule">
      <header class="panel__head">
        <h2 id="stat-rules">{say("statistics-rule-title")}</h2>
      </header>
      <TableScroll label={say("statistics-rule-title")}>
        <table class="table">
          <thead>
            <tr>
              <th>{say("statistics-rule-standard")}</th>
              <th>{say("statistics-rule-rule")}</th>
              <th class="num">{say("statistics-rule-height", { unit })}</th>
              <th class="num">{say("statistics-rule-today", { unit })}</th>
              <th class="num">
                {say("with-unit", { name: say("statistics-rule-difference"), unit: smallScale()[1] })}
              </th>
              <th>{say("statistics-rule-verdict")}</th>
            </tr>
          </thead>
          <tbody>
            {there.map((one) => (
              <tr key={`${one.standard.name}|${one.standard.what}`}>
                <th scope="row">{one.standard.name}</th>
                <td>
                  {say("statistics-rule-of", {
                    percent: String(one.standard.percent),
                    class: one.by_class ? one.standard.vehicle_class : say("statistics-rule-all"),
                  })}
                </td>
                <td class="num">{plainHeight(one.standard.height_m)}</td>
                <td class="num">
                  {one.value_m === null ? NONE : <strong>{plainHeight(one.value_m)}</strong>}
                  {one.U95_low_m !== null && one.U95_high_m !== null && (
                    <div class="stat-ci">
                      {say("statistics-rule-interval", {
                        low: plainHeight(one.U95_low_m),
                        high: plainHeight(one.U95_high_m),
                      })}
                    </div>
                  )}
                </td>
                <td class="num">{plainSmall(one.difference_m, { signed: true })}</td>
                <td>{verdict(one)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="stat-notes small">{say("statistics-rule-note")}</p>
    </section>
  );
}

function verdict({ verdict: word, lower, risk, reason }: Rule): string {
  if (word === "unknown" || lower === null) return say("statistics-rule-unknown", { reason: reason ?? "" });
  if (word === "alike") return say("statistics-rule-alike", { lower: percent(lower) });
  const small = risk === null || risk < SMALLEST_RISK;
  const said = small ? say("statistics-rule-least", { risk: percent(SMALLEST_RISK) }) : percent(risk);
  return say(word === "lower" ? "statistics-rule-lower" : "statistics-rule-higher", { risk: said });
}
