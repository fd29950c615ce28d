/** Beside the frame: each proposed point under its loupe with what its height would be, and why others are missing. */
import { Button } from "../../../components";
import { hint, keyMap, showChord } from "../../../core/commands";
import { say, sayCode } from "../../../core/messages";
import type { PointProposal } from "../../../core/types";
import { fixed } from "../../../core/units";
import { TARGET_WORDS, TARGETS } from "../../../core/words";
import { targetAction } from "../../../parts/vehicles/TargetButton";
import { heightOrReason } from "../../../viewer/geometry";
import { PointLoupe } from "../../../viewer/PointLoupe";
import { samePoint } from "../../../viewer/points";
import type { MeasureModel } from "../model";
import type { InHand } from "./placed";
import "./proposals.css";

export function ProposalPanel({ model }: { model: MeasureModel }) {
  const { proposals, standing } = model;
  const missing = standing.missing();
  if (missing.length === 0) return null;
  const frame = model.vehicle.value && proposals.frameOf(model.vehicle.value.id, missing);
  const shown = proposals.shown.value;
  return (
    <section
      class="stack stack--tight proposed"
      aria-label={say("measure-proposed-title")}
      data-testid="proposed"
    >
      {shown && (
        <>
          <div class="grid grid--3 grid--close">
            {proposals.inHand().map((one) => (
              <Card key={one.role} model={model} one={one} />
            ))}
          </div>
          <Button
            small
            kind="primary"
            disabled={!proposals.ready.value}
            title={say("measure-proposed-accept-title") + hint("place")}
            onClick={() => {
              proposals.confirm();
              model.stage.focus();
            }}
          >
            {say("measure-proposed-accept", { count: shown.targets.length })}
            <kbd>{showChord(keyMap.value.place[0] ?? "")}</kbd>
          </Button>
        </>
      )}
      {!shown && frame !== null && model.seenFrame.value !== frame && (
        <Button small kind="quiet" onClick={() => model.toBestFrame()}>
          {say("measure-proposed-on-frame", { frame: String(frame) })}
        </Button>
      )}
      <Reasons all={proposals.all.value} missing={missing} />
    </section>
  );
}

function Card({ model, one }: { model: MeasureModel; one: InHand }) {
  const { proposals } = model;
  const player = model.reel.player.value;
  const height = one.role === "contact" ? null : proposals.heightOf(one.role);
  const moved = !samePoint(one.at, one.proposed);
  const id = one.role === "contact" ? "newContact" : targetAction(one.role);
  const name = one.role === "contact" ? say("measure-proposed-contact") : TARGET_WORDS[one.role];
  return (
    <button
      type="button"
      class="proposed__point"
      aria-pressed={proposals.selected.value === one.role}
      data-testid={`proposed-card-${one.role}`}
      title={say("measure-proposed-go")}
      onClick={() => {
        proposals.pick(one.role);
        model.stage.focus();
      }}
    >
      {player && <PointLoupe player={player} at={one.at} />}
      <span class="proposed__name">
        <kbd>{showChord(keyMap.value[id]?.[0] ?? "")}</kbd> {name}
      </span>
      <span class="proposed__height">
        {one.role === "contact" ? " " : height === null ? "…" : heightOrReason(height)}
      </span>
      <span class="muted small" title={moved ? undefined : say("measure-proposed-expected-title")}>
        {moved
          ? say("measure-proposed-moved")
          : say("measure-proposed-expected", { expected_px: fixed(one.expected_px, 1) })}
      </span>
    </button>
  );
}

function Reasons({ all, missing }: { all: readonly PointProposal[]; missing: readonly string[] }) {
  const refused = TARGETS.flatMap((target) => {
    const found = all.find(({ point }) => point === target);
    return missing.includes(target) && found?.reason ? [{ target, reason: found.reason }] : [];
  });
  const reasons = [...new Set(refused.map(({ reason }) => reason))];
  return (
    <>
      {reasons.map((code) => {
        const of = refused.filter(({ reason }) => reason === code).map(({ target }) => TARGET_WORDS[target]);
        return (
          <p key={code} class="muted small">
            <strong>{of.join(", ")}</strong> {sayCode({ code, values: {} })}
          </p>
        );
      })}
    </>
  );
}
