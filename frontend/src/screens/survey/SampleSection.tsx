/** The sample of a survey: its rule in words, quotas, and what became of the passes. */
import { Button, Notice, Problem, TableScroll } from "../../components";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import type { Response, Sampling, Survey } from "../../core/types";
import { fixed, formatCount } from "../../core/units";
import { CLASS_SET_WORDS, LIGHTING_WORDS, TARGET_WORDS } from "../../core/words";
import { SampleQuotas, useSample } from "../../parts/vehicles/SampleQuotas";

export function SampleSection({ survey, edit }: { survey: Survey; edit(): void }) {
  const found = useSample(survey.id, () => null);
  const rows = (found.data?.response ?? []).filter(isShown);
  return (
    <section class="panel" aria-labelledby="sample-title" data-testid="sample">
      <header class="panel__head">
        <h2 id="sample-title">{say("sample-title")}</h2>
        {may("operator") && (
          <Button small onClick={edit}>
            {say("sample-edit")}
          </Button>
        )}
      </header>
      <div class="panel__body stack">
        <p>{ruleWords(survey.sampling)}</p>
        <Problem error={found.error} again={found.reload} />
        {found.data && <SampleQuotas quotas={found.data.quotas} />}
        {rows.length > 0 && <ResponseTable rows={rows} counts={survey.sampling.outside_counts} />}
      </div>
    </section>
  );
}

function ResponseTable({ rows, counts }: { rows: readonly Response[]; counts: boolean }) {
  const outside = rows[0]?.outside ?? 0;
  return (
    <>
      <TableScroll label={say("sample-response")}>
        <table class="table">
          <thead>
            <tr>
              <th>{say("sample-lighting")}</th>
              <th>{say("sample-classes")}</th>
              <th>{say("sample-of")}</th>
              <th class="num">{say("sample-passes")}</th>
              <th class="num">{say("sample-discarded")}</th>
              <th class="num">{say("sample-out")}</th>
              <th class="num">{say("sample-measured")}</th>
              <th class="num">{say("sample-unseen")}</th>
              <th class="num">{say("sample-open")}</th>
              <th class="num">{say("sample-rate")}</th>
            </tr>
          </thead>
          <tbody>
            {rows.map((one) => (
              <tr key={`${one.lighting}.${one.class_set}.${one.target}`}>
                <td class="nowrap">{lightingWord(one.lighting)}</td>
                <td>{setWord(one.class_set)}</td>
                <td class="nowrap">{one.target ? TARGET_WORDS[one.target] : say("sample-vehicle")}</td>
                <td class="num">{formatCount(one.passes)}</td>
                <td class="num">{formatCount(one.discarded)}</td>
                <td class="num">{formatCount(one.out_of_sample)}</td>
                <td class="num">{formatCount(one.measured)}</td>
                <td class="num">{formatCount(one.not_visible)}</td>
                <td class="num">{formatCount(one.open)}</td>
                <td class="num nowrap">{rate(one)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      {outside > 0 && (
        <Notice kind="warning">
          {say("sample-outside", { count: outside, counts: counts ? "yes" : "no" })}
        </Notice>
      )}
      <p class="field__hint">{say("sample-help")}</p>
    </>
  );
}

/** All, each lighting and set, and by target each lighting. */
function isShown(one: Response): boolean {
  if (one.lighting === "all") return one.class_set === "all" && !one.target;
  return one.class_set === "all" || !one.target;
}

function lightingWord(lighting: Response["lighting"]): string {
  if (lighting === "all") return say("sample-all");
  return lighting === "unknown" ? say("sample-unknown") : LIGHTING_WORDS[lighting];
}

function setWord(set: Response["class_set"]): string {
  if (set === "all") return say("sample-all");
  return set === "none" ? say("class-set-none") : CLASS_SET_WORDS[set];
}

function rate({ rate: value, low, high }: Response): string {
  if (value === null || low === null || high === null) return "–";
  const percent = (share: number) => fixed(100 * share, 0);
  return say("sample-rate-of", { rate: percent(value), low: percent(low), high: percent(high) });
}

function ruleWords(rule: Sampling): string {
  const what = say("sample-rule", {
    method: rule.method,
    step: rule.step,
    start: rule.start,
    share: String(rule.share_percent),
    seed: String(rule.seed),
  });
  return rule.free_flowing_s === null
    ? what
    : `${what} ${say("sample-rule-free", { seconds: String(rule.free_flowing_s) })}`;
}
