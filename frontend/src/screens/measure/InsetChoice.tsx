/** What only a look at the vehicle can tell (on which side the driver sits): asked where the target is clicked. */
import { Segments } from "../../components";
import { say, wordsOf } from "../../core/messages";
import { canWork } from "../../core/session";
import { survey } from "../../core/survey";
import type { Target } from "../../core/types";
import { formatLength } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

const ASKED: Readonly<Partial<Record<Target, string>>> = wordsOf({
  driver_eye: "measure-inset-side",
  roof: "measure-inset-roof",
});

interface Props {
  model: MeasureModel;
  target: Target;
  entry: Entry | null;
}

export function InsetChoice({ model, target, entry }: Props) {
  const choices = survey.value?.inset_choices?.[target] ?? [];
  const asked = model.flow.value.target === target;
  if (choices.length < 2 || !asked || !canWork.value) return null;
  const now = model.insetOf(target) ?? entry?.values.inset ?? model.usualInset(target);
  const value = choices.findIndex(
    (choice) => choice.inset_m === now?.inset_m && choice.u_inset_m === now?.u_inset_m,
  );
  return (
    <div class="inset-choice" data-testid={`inset-choice-${target}`}>
      <span class="small">{ASKED[target]}</span>
      <Segments
        label={ASKED[target] ?? TARGET_WORDS[target]}
        value={String(value)}
        options={choices.map((choice, i) => ({
          value: String(i),
          label: choice.words,
        }))}
        onChange={(picked) => {
          const choice = choices[Number(picked)];
          if (choice) model.chooseInset(target, { inset_m: choice.inset_m, u_inset_m: choice.u_inset_m });
        }}
      />
      <span class="small muted">
        {say("measure-inset-now", {
          inset: formatLength(now?.inset_m ?? null, 2),
          u_inset: formatLength(now?.u_inset_m ?? null, 2),
        })}
      </span>
    </div>
  );
}
