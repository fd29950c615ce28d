/** The chosen vehicle's heights: one line per target; budget, inset and history on demand. */

import { useEffect, useRef, useState } from "preact/hooks";
import { Button, Facts, IconButton, Notice, Panel, Segments, StateMark } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { canWork, may } from "../../core/session";
import { survey } from "../../core/survey";
import type { InsetChoice, LineHeight, LineHeightAnswer, Target } from "../../core/types";
import { fixed, formatHeight, formatLength } from "../../core/units";
import { heightWords, INSET_PLACE_WORDS, TARGET_WORDS, TARGETS } from "../../core/words";
import { Budget } from "../../parts/vehicles/Budget";
import { insetChoices, usualInset } from "../../parts/vehicles/insets";
import { Revisions } from "../../parts/vehicles/Revisions";
import { TargetButton } from "../../parts/vehicles/TargetButton";
import { heightKey } from "./keptHeights";
import type { Inset } from "./kinds";
import type { ScanModel } from "./model";

export function HeightList({ model }: { model: ScanModel }) {
  const { heights } = model;
  const pose = heights.kept.pose.value;
  if (heights.kept.poses.value === null) return null;
  return (
    <Panel
      says="scan-heights"
      within
      class="line-heights"
      note={
        pose
          ? say("scan-heights-camera", {
              height: formatHeight(pose.solved.camera_height_m, pose.solved.U95_camera_height_m),
            })
          : undefined
      }
    >
      {pose && <Older model={model} />}
      {pose ? (
        <ul>
          {TARGETS.map((target) => (
            <Row key={target} model={model} target={target} />
          ))}
        </ul>
      ) : (
        <Uncalibrated model={model} />
      )}
    </Panel>
  );
}

function Older({ model }: { model: ScanModel }) {
  const count = model.heights.kept.older.value.length;
  if (count === 0) return null;
  return (
    <div class="row row--wrap row--apart line-heights__older small">
      <span>{say("scan-heights-older", { count })}</span>
      <Button says="computing-look" small href={`/surveys/${survey.value?.id}/checks?tab=again`} />
    </div>
  );
}

function Uncalibrated({ model }: { model: ScanModel }) {
  return (
    <div class="panel__body stack">
      <p class="small">{say("scan-heights-no-pose")}</p>
      {canWork.value && <Button says="scan-heights-calibrate" small onClick={() => model.start("rod")} />}
    </div>
  );
}

function Row({ model, target }: { model: ScanModel; target: Target }) {
  const [open, setOpen] = useState(false);
  const { heights } = model;
  const one = heights.of(target);
  const active = heights.target.value === target;
  const place = useRef<HTMLLIElement>(null);
  useEffect(() => {
    if (active) place.current?.scrollIntoView({ block: "nearest" });
  }, [active]);
  const live = heights.live.value?.target === target ? heights.live.value : null;
  return (
    <li ref={place} class={active ? "line-heights__row current" : "line-heights__row"}>
      <div class="height-row line-heights__line">
        <TargetButton
          target={target}
          pressed={active}
          title={say(one ? "scan-height-measure-again" : "scan-height-measure", { target })}
          testId={`line-target-${target}`}
          onClick={() => heights.begin(target)}
        />
        <span class="line-heights__value" data-testid={`line-height-${target}`}>
          {valueWords(one, live?.answer ?? null)}
        </span>
        {one && (
          <IconButton
            icon={open ? "chevron" : "right"}
            label={say(open ? "scan-height-hide" : "scan-height-show", { target })}
            onClick={() => setOpen(!open)}
          />
        )}
      </div>
      {one && outbox.get(heightKey(one.vehicle_id, target)) && (
        <p class="small muted">{say("scan-height-unsaved")}</p>
      )}
      {live?.problem && <Notice kind="warning">{live.problem}</Notice>}
      <Why one={one} live={live?.answer ?? null} />
      {one && !active && <Standing one={one} />}
      {(active || open) && <InsetOf model={model} target={target} />}
      {one && open && <Detail model={model} one={one} />}
    </li>
  );
}

/** The verdict on it, and the way to the review, where a second person gives it. */
function Standing({ one: { id, review, mine } }: { one: LineHeight }) {
  return (
    <div class="row row--wrap line-heights__verdict small">
      <StateMark state={review.verdict} />
      {id > 0 && !mine && may("reviewer") && (
        <a href={`/surveys/${survey.value?.id}/review?measurement=${id}`}>{say("page-review")}</a>
      )}
    </div>
  );
}

/** Why there is no height, or what to bear in mind with it. */
function Why({ one, live }: { one: LineHeight | null; live: LineHeightAnswer | null }) {
  const words = reasonOf(one, live);
  return words && <p class="small line-heights__reason">{words}</p>;
}

function valueWords(one: LineHeight | null, live: LineHeightAnswer | null): string {
  const shown = live?.status === "contact" ? one : (live ?? one);
  return shown ? heightWords(shown) : "–";
}

function reasonOf(one: LineHeight | null, live: LineHeightAnswer | null): string | null {
  const shown = live ?? one;
  if (!shown) return null;
  if (shown.reason) return sentenceOf(shown.reason);
  const older = live === null && one?.older ? [say("scan-height-older")] : [];
  return [...shown.flags.map(sentenceOf), ...older].join(" ") || null;
}

const ASKED: Readonly<Partial<Record<Target, string>>> = wordsOf("scan-height-inset-", "driver_eye", "roof");

function InsetOf({ model, target }: { model: ScanModel; target: Target }) {
  const category = model.chosen.value?.category ?? null;
  const choices = insetChoices(survey.value, target, category);
  if (choices.length < 2 || !canWork.value) return null;
  const usual = usualInset(survey.value, target, null, category);
  const now = model.heights.insetOf(target) ?? usual;
  const chosen = choices.findIndex((one) => isChosen(one, now ?? null));
  return (
    <div class="row row--wrap line-heights__inset small">
      <span>{ASKED[target]}</span>
      <Segments
        label={ASKED[target] ?? TARGET_WORDS[target]}
        value={String(chosen)}
        options={choices.map((choice, at) => ({ value: String(at), label: INSET_PLACE_WORDS[choice.place] }))}
        onInput={(picked) => {
          const choice = choices[Number(picked)];
          if (choice) void model.heights.setInset(target, insetOfChoice(choice));
        }}
      />
    </div>
  );
}

function isChosen({ place, inset_m, u_inset_m }: InsetChoice, now: Inset | null): boolean {
  if (now && "side" in now) return place === now.side;
  return inset_m === now?.inset_m && u_inset_m === now.u_inset_m;
}

/** Of an eye the side, so that its inset stays the survey's. */
function insetOfChoice({ place, inset_m, u_inset_m }: InsetChoice): Inset {
  return place === "near" || place === "far" ? { side: place } : { inset_m, u_inset_m };
}

function Detail({ model, one }: { model: ScanModel; one: LineHeight }) {
  return (
    <div class="stack line-heights__detail">
      {one.budget.length > 0 && <Budget entries={one.budget} total_m={one.u_height_m} />}
      <Facts
        small
        of={[
          [say("scan-height-distance"), formatHeight(one.distance_m, one.U95_distance_m)],
          [
            say("scan-height-inset"),
            say("scan-height-inset-value", {
              inset: formatLength(one.inset_m, 2),
              u_inset: formatLength(one.u_inset_m, 2),
            }),
          ],
          [
            say("scan-height-rows"),
            say("scan-height-rows-value", {
              contact_px: fixed(one.contact[1], 1),
              target_px: fixed(one.target_point[1], 1),
            }),
          ],
        ]}
      />
      {one.id > 0 && <Revisions id={one.id} revision={one.revision} />}
      {canWork.value && (
        <div class="row row--wrap">
          {one.older && (
            <Button says="scan-height-again" small onClick={() => void model.heights.again(one.target)} />
          )}
          <Button
            says="scan-height-withdraw"
            small
            icon="trash"
            onClick={() => void model.heights.withdraw(one.target)}
          />
        </div>
      )}
    </div>
  );
}
