/** The sample of a survey: its rule in words, quotas, and what became of the passes. */
import { Button, DataTable, Notice, Panel, Problem } from "../../components";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import type { Response, Sampling, Survey } from "../../core/types";
import { fixed, formatCount, plainPercent } from "../../core/units";
import { CLASS_SET_WORDS, LIGHTING_WORDS, TARGET_WORDS } from "../../core/words";
import { Bounded } from "../../parts/figures/FigureCell";
import { percent } from "../../parts/figures/numbers";
import { SampleQuotas, useSample } from "../../parts/vehicles/SampleQuotas";

export function SampleSection({ survey, edit }: { survey: Survey; edit(): void }) {
  const found = useSample(survey.id);
  const rows = (found.data?.response ?? []).filter(isShown);
  return (
    <Panel
      says="sample-title"
      aside={may("operator") && <Button says="sample-edit" small onClick={edit} />}
      data-testid="sample"
    >
      <div class="panel__body stack">
        <p>{ruleWords(survey.sampling)}</p>
        <Problem error={found.error} again={found.reload} />
        {found.data && <SampleQuotas quotas={found.data.quotas} />}
        {rows.length > 0 && <ResponseTable rows={rows} counts={survey.sampling.outside_counts} />}
      </div>
    </Panel>
  );
}

function ResponseTable({ rows, counts }: { rows: readonly Response[]; counts: boolean }) {
  const outside = rows[0]?.outside ?? 0;
  return (
    <>
      <DataTable
        label={say("sample-response")}
        class="table--dense"
        rows={rows}
        keyOf={(one) => `${one.lighting}.${one.class_set}.${one.target}`}
        columns={({ col, num }) => [
          col(say("sample-lighting"), (one) => lightingWord(one.lighting)),
          col(say("sample-of"), (one) => (one.target ? TARGET_WORDS[one.target] : setWord(one.class_set))),
          num(say("sample-passes"), (one) => formatCount(one.passes)),
          num(say("sample-discarded"), (one) => formatCount(one.discarded)),
          num(say("sample-out"), (one) => formatCount(one.out_of_sample)),
          num(say("sample-measured"), (one) => formatCount(one.measured)),
          num(say("sample-unseen"), (one) => formatCount(one.not_visible)),
          num(say("sample-open"), (one) => formatCount(one.open)),
          num(say("sample-rate"), (one) => <Rate {...one} />),
        ]}
      />
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
  if (set === "all") return say("sample-vehicles");
  return set === "none" ? say("class-set-none") : CLASS_SET_WORDS[set];
}

/** To a tenth, as in the report: 199 of 200 are not 100 %. */
export function Rate({ rate, low, high }: Pick<Response, "rate" | "low" | "high">) {
  const tenths = (share: number) => fixed(100 * share, 1);
  return <Bounded value={rate} low={low} high={high} print={percent} within={tenths} />;
}

function ruleWords(rule: Sampling): string {
  const what = say("sample-rule", {
    method: rule.method,
    step: rule.step,
    start: rule.start,
    share: plainPercent(rule.share_percent),
    seed: String(rule.seed),
  });
  return rule.free_flowing_s === null
    ? what
    : `${what} ${say("sample-rule-free", { seconds: String(rule.free_flowing_s) })}`;
}
