/** What has been measured of a vehicle: one line per target, its value, its state; more on demand. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Button, choices, Icon, IconButton, Remark, Segments, StateMark } from "../../components";
import { late } from "../../components/late";
import { linkTo, Said } from "../../components/Said";
import { hint } from "../../core/commands";
import { say, sentenceOf } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { canWork } from "../../core/session";
import { stored } from "../../core/stored";
import { survey } from "../../core/survey";
import type { AskedTarget, DriverSide, NotVisible, Target, Vehicle } from "../../core/types";
import { formatLength } from "../../core/units";
import {
  ASKABLE,
  heightWords,
  INSET_PLACE_WORDS,
  NOT_VISIBLE_WORDS,
  SIDE_WORDS,
  TARGET_NOUNS,
  TARGETS,
} from "../../core/words";
import { StaleMarks } from "../../parts/again/StaleMarks";
import { classIsMissing, insetChoices } from "../../parts/vehicles/insets";
import { TargetButton, targetKey } from "../../parts/vehicles/TargetButton";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";
import { FramesSaid } from "./SecondFrameParts";
import { PassSaid } from "./WholePassParts";

const MeasurementDetail = late(async () => (await import("./MeasurementDetail")).MeasurementDetail);
const MeasurementConflict = late(async () => (await import("./Conflicts")).MeasurementConflict);

export function MeasurementList({ model }: { model: MeasureModel }) {
  const entries = model.entries.value.filter((entry) => !entry.values.withdrawn);
  const open = useSignal<string | null>(null);
  const detail = (entry: Entry) =>
    open.value === entry.key && <MeasurementDetail model={model} entry={entry} />;
  const ownOf = (target: Target) => entries.filter((entry) => entry.values.target === target);
  const idle = TARGETS.filter(
    (target) => !isAsked(model, target) && model.flow.value.target !== target && ownOf(target).length === 0,
  );
  return (
    <section class="heights" aria-label={say("measure-measurements")}>
      <ul>
        {TARGETS.map((target) => {
          if (idle.includes(target)) return null;
          const own = ownOf(target);
          return (
            <li key={target} class={isAsked(model, target) ? "" : "heights__optional"}>
              {own.length === 0 ? (
                <Row model={model} target={target} entry={null} open={false} />
              ) : (
                own.map((entry) => (
                  <div key={entry.key}>
                    <Row
                      model={model}
                      target={target}
                      entry={entry}
                      open={open.value === entry.key}
                      onOpen={() => {
                        open.value = open.value === entry.key ? null : entry.key;
                      }}
                    />
                    <SaidOf model={model} entry={entry} />
                    <Doubts model={model} entry={entry} />
                    {detail(entry)}
                  </div>
                ))
              )}
              {own.length === 0 && <Unseen model={model} target={target} />}
              <InsetChoice model={model} target={target} entry={own.at(-1) ?? null} />
            </li>
          );
        })}
        {idle.length > 0 && (
          <li class="heights__idle muted small" title={say("measure-targets-idle")}>
            {idle.map((target) => (
              <Choose key={target} model={model} target={target} again={false} />
            ))}
          </li>
        )}
      </ul>
    </section>
  );
}

function isAsked(model: MeasureModel, target: Target): boolean {
  return (model.vehicle.value?.asked as readonly Target[] | undefined)?.includes(target) ?? false;
}

interface TargetProps {
  model: MeasureModel;
  target: Target;
  entry: Entry | null;
}

interface RowProps extends TargetProps {
  open: boolean;
  onOpen?(): void;
}

function Choose({ model, target, again }: { model: MeasureModel; target: Target; again: boolean }) {
  return (
    <TargetButton
      target={target}
      pressed={model.flow.value.target === target}
      title={say(again ? "measure-target-afresh" : "measure-target", { target: TARGET_NOUNS[target] })}
      testId={`target-${target}`}
      onClick={() => {
        model.dispatch({ type: "choose", target });
        model.stage.focus();
      }}
    />
  );
}

function Row({ model, target, entry, open, onOpen }: RowProps) {
  const active = model.flow.value.target === target;
  const selected = entry !== null && model.flow.value.selection?.key === entry.key;
  return (
    <div
      class={`height-row${active ? " current" : ""}${selected ? " height-row--selected" : ""}`}
      data-testid={`measurement-row-${target}`}
      data-state={entry?.state ?? "missing"}
    >
      <Choose model={model} target={target} again={entry !== null} />
      {entry ? (
        <button
          type="button"
          class="height-row__value"
          title={say("measure-show-point")}
          onClick={() => {
            model.reel.player.value?.go(entry.values.frame);
            model.second.last = entry.key;
            model.points.select({ key: entry.key, role: "point" });
            model.stage.focus();
          }}
        >
          {entryWords(entry)}
        </button>
      ) : (
        <span class="height-row__value muted">
          {active && model.hasPose.value ? say("measure-click") : "–"}
        </span>
      )}
      {entry && (
        <IconButton
          icon={open ? "chevron" : "right"}
          label={say(open ? "measure-details-hide" : "measure-details-show", { target })}
          onClick={() => onOpen?.()}
        />
      )}
    </div>
  );
}

function clickAgain(target: Target): string {
  const key = targetKey(target);
  return key ? say("measure-click-again-key", { key }) : say("measure-click-again");
}

/** Asked at once, and nothing is refused: the operator looks, clicks again or goes on. */
function Doubts({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const found = (model.vehicle.value?.doubts ?? []).filter((one) => one.target === entry.values.target);
  if (entry.state !== "saved") return null;
  return (
    <>
      {found.map(({ kind, low_m, high_m }) => (
        <Remark
          key={kind}
          icon="warning"
          class="height-row__said height-row__doubt"
          role="alert"
          data-testid={`doubt-${kind}`}
        >
          {say("measure-doubt", { kind, low: formatLength(low_m, 2), high: formatLength(high_m, 2) })}{" "}
          {canWork.value && clickAgain(entry.values.target)}
        </Remark>
      ))}
    </>
  );
}

function SaidOf({ model, entry }: { model: MeasureModel; entry: Entry }) {
  if (entry.state === "conflict") return <MeasurementConflict model={model} entry={entry} />;
  if (entry.state === "failed") {
    return (
      <div class="height-row__said" role="alert">
        <Icon name="warning" size={14} />
        <span class="grow">{entry.problem}</span>
        <Button says="action-try-again" small onClick={() => outbox.send(entry.key)} />
        <Button says="measure-discard" small kind="quiet" onClick={() => outbox.discard(entry.key)} />
      </div>
    );
  }
  if (entry.state === "saving") return <p class="height-row__said muted">{say("measure-not-yet-saved")}</p>;
  const m = entry.saved;
  if (!m) return null;
  const verdict = m.review.verdict;
  return (
    <>
      <StaleMarks measurementId={m.id} />
      <FramesSaid m={m} />
      <PassSaid m={m} />
      {m.status !== "ok" && (
        <Remark icon="warning" class="height-row__said">
          {m.reason && sentenceOf(m.reason)}
        </Remark>
      )}
      {m.flags.map((flag) => (
        <Remark key={flag.code} icon="info" class="height-row__said">
          {sentenceOf(flag)}
        </Remark>
      ))}
      {verdict !== "to_review" && (
        <p class="height-row__said">
          <StateMark state={verdict} />
          {m.review.reason && <span>{m.review.reason}</span>}
          {verdict === "rejected" && canWork.value && <span class="muted">{clickAgain(m.target)}</span>}
        </p>
      )}
    </>
  );
}

const REASONS = Object.keys(NOT_VISIBLE_WORDS) as NotVisible[];
/** The reason given last is the first to take again. */
const last = stored<NotVisible>("unseen.reason", "hidden", (value) => REASONS.includes(value as NotVisible));

/** A target that cannot be measured: asked why by one key and one digit, said in its row, taken back by a button. */
function Unseen({ model, target }: { model: MeasureModel; target: Target }) {
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
    <fieldset
      class="row row--wrap row--near unseen"
      ref={box}
      onKeyDown={onKeyDown}
      data-testid="unseen-reasons"
    >
      <legend class="small">{say("measure-unseen-why", { target })}</legend>
      {reasons.map((why, i) => (
        <button type="button" class="btn btn--small" key={why} onClick={() => take(why)}>
          <kbd>{i + 1}</kbd> {NOT_VISIBLE_WORDS[why]}
        </button>
      ))}
    </fieldset>
  );
}

/** The stored height, or the one just answered while it is being stored. */
function entryWords(entry: Entry): string {
  const source =
    entry.state === "saved"
      ? entry.saved
      : (entry.preview ?? (entry.state === "saving" ? entry.saved : null));
  if (!source) return entry.state === "failed" ? say("measure-not-stored") : "…";
  return heightWords({ ...source, withdrawn: false });
}

/** What only a look at the vehicle can tell: where the driver sits, which spot of the roof was clicked. */
function InsetChoice({ model, target, entry }: TargetProps) {
  const vehicle = model.vehicle.value;
  if (target === "driver_eye" && vehicle) return <DriverSideChoice model={model} vehicle={vehicle} />;
  return target === "roof" ? <RoofChoice model={model} target={target} entry={entry} /> : null;
}

/** Beside the eye, always: near or far, and what it follows from. One click says it of this vehicle. */
function DriverSideChoice({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  const side = vehicle.driver_side ?? vehicle.side;
  const silent = survey.value?.traffic.steering_side ? "undirected" : "unknown";
  const from = vehicle.driver_side ? "said" : (vehicle.side_from ?? silent);
  const values = {
    direction: vehicle.direction ?? "right",
    steering: survey.value?.traffic.steering_side ?? "left",
  };
  return (
    <div
      class="stack stack--dense inset-choice"
      data-testid="inset-choice-driver_eye"
      data-side={side ?? "unknown"}
    >
      <span class="small">{say("measure-inset-side")}</span>
      {canWork.value ? (
        <Segments
          says="measure-inset-side"
          value={side ?? ""}
          options={choices<string>(SIDE_WORDS)}
          onInput={(picked) => model.insets.chooseSide(picked as DriverSide)}
        />
      ) : (
        <span class="small">{side ? SIDE_WORDS[side] : say("measure-side-unknown")}</span>
      )}
      <span class="small muted">
        <Said
          what="measure-side-from"
          values={{ from, ...values }}
          parts={linkTo(`/surveys/${model.surveyId}/settings`)}
        />
      </span>
      {from === "said" && canWork.value && (
        <Button
          says="measure-side-as-survey"
          small
          kind="quiet"
          onClick={() => model.insets.chooseSide(null)}
        />
      )}
    </div>
  );
}

function RoofChoice({ model, target, entry }: TargetProps) {
  const category = model.vehicle.value?.category ?? null;
  const offered = insetChoices(survey.value, target, category);
  const asked = model.flow.value.target === target;
  if (offered.length < 2 || !asked || !canWork.value) return null;
  const now = model.insetOf(target) ?? entry?.values.inset ?? model.insets.usual(target);
  const value = offered.findIndex(
    (choice) => choice.inset_m === now?.inset_m && choice.u_inset_m === now?.u_inset_m,
  );
  return (
    <div class="stack stack--dense inset-choice" data-testid={`inset-choice-${target}`}>
      <span class="small">{say("measure-inset-roof")}</span>
      <Segments
        says="measure-inset-roof"
        value={String(value)}
        options={offered.map((choice, i) => ({ value: String(i), label: INSET_PLACE_WORDS[choice.place] }))}
        onInput={(picked) => {
          const choice = offered[Number(picked)];
          if (choice) model.insets.choose(target, { inset_m: choice.inset_m, u_inset_m: choice.u_inset_m });
        }}
      />
      <span class="small muted">
        {say("measure-inset-now", {
          inset: formatLength(now?.inset_m ?? null, 2),
          u_inset: formatLength(now?.u_inset_m ?? null, 2),
        })}{" "}
        {classIsMissing(target, category) && say("measure-inset-needs-class")}
      </span>
    </div>
  );
}
