/** A target that cannot be measured: asked why by one key and one digit, said in its row, taken back by a button. */
import { useEffect, useRef } from "preact/hooks";
import { Button, Icon } from "../../components";
import { hint } from "../../core/commands";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { stored } from "../../core/stored";
import type { AskedTarget, NotVisible, Target } from "../../core/types";
import { ASKABLE, NOT_VISIBLE_WORDS } from "../../core/words";
import type { MeasureModel } from "./model";

const REASONS = Object.keys(NOT_VISIBLE_WORDS) as NotVisible[];
/** The reason given last is the first to take again. */
const last = stored<NotVisible>("unseen.reason", "hidden", (value) => REASONS.includes(value as NotVisible));

export function Unseen({ model, target }: { model: MeasureModel; target: Target }) {
  const vehicle = model.vehicle.value;
  const asked = ASKABLE.find((one) => one === target);
  if (!vehicle || !asked) return null;
  const why = vehicle[`${asked}_not_visible`];
  if (why)
    return (
      <p class="height-row__said" data-testid={`unseen-${asked}`}>
        <Icon name="info" size={14} />
        <span class="grow">{say("measure-unseen", { why: NOT_VISIBLE_WORDS[why] })}</span>
        {canWork.value && (
          <Button
            says="measure-unseen-back"
            small
            kind="quiet"
            onClick={() => model.setUnseen(asked, null)}
          />
        )}
      </p>
    );
  if (!canWork.value || model.flow.value.target !== target) return null;
  if (model.whyUnseen.value === asked) return <Reasons model={model} target={asked} />;
  return (
    <p class="height-row__said">
      <span class="grow" />
      <Button
        says="measure-unseen-ask"
        small
        kind="quiet"
        title={say("measure-unseen-ask") + hint("notVisible")}
        onClick={() => model.askWhyUnseen()}
      />
    </p>
  );
}

/** The reasons with their digits; the one given last has the focus, so that Enter takes it. */
function Reasons({ model, target }: { model: MeasureModel; target: AskedTarget }) {
  const box = useRef<HTMLFieldSetElement>(null);
  const reasons = REASONS.filter((one) => one !== "no_driver" || target === "driver_eye");
  useEffect(() => {
    const at = Math.max(reasons.indexOf(last.value), 0);
    box.current?.querySelectorAll("button")[at]?.focus();
  }, [reasons.length]);
  const take = (why: NotVisible): void => {
    last.value = why;
    model.setUnseen(target, why);
    model.stage.focus();
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const why = reasons[Number(event.key) - 1];
    if (event.key === "Escape") {
      model.whyUnseen.value = null;
      model.stage.focus();
    } else if (why) take(why);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <fieldset class="unseen" ref={box} onKeyDown={onKeyDown} data-testid="unseen-reasons">
      <legend class="small">{say("measure-unseen-why", { target })}</legend>
      {reasons.map((why, i) => (
        <button type="button" class="btn btn--small" key={why} onClick={() => take(why)}>
          <kbd>{i + 1}</kbd> {NOT_VISIBLE_WORDS[why]}
        </button>
      ))}
    </fieldset>
  );
}
