import { Button, Facts } from "../../components";
import { LengthField } from "../../components/CommitField";
import { hint } from "../../core/commands";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { fixed, formatLength, lengthProblem } from "../../core/units";
import { Budget } from "../../parts/vehicles/Budget";
import { Revisions } from "../../parts/vehicles/Revisions";
import type { Inset } from "../../viewer/values";
import { Frames } from "./FramesOf";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

export function MeasurementDetail({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const source = entry.preview ?? entry.saved;
  return (
    <div class="height-detail">
      <Frames model={model} entry={entry} />
      {canWork.value && entry.state === "saved" && (
        <Button
          says="measure-whole-follow"
          small
          title={say("measure-whole-go") + hint("followPass")}
          onClick={() => void model.whole.start(entry.key)}
        />
      )}
      <InsetEditor model={model} entry={entry} />
      {source && source.budget.length > 0 && <Budget entries={source.budget} total_m={source.u_height_m} />}
      <Facts
        small
        of={[
          [say("stage-frame"), entry.values.frame],
          [say("measure-contact"), pixels(entry.values.contact)],
          [say("measure-point"), pixels(entry.values.point)],
          entry.saved && [say("measure-points-set"), say("measure-made", { made: entry.saved.made })],
          entry.saved && [say("measure-distance"), formatLength(entry.saved.distance_m, 2)],
          entry.saved && [say("measure-lateral"), formatLength(entry.saved.y_m, 2)],
          entry.saved && [say("measure-along"), formatLength(entry.saved.x_m, 2)],
          entry.saved && [say("measure-without-inset"), formatLength(entry.saved.uncorrected_height_m)],
        ]}
      />
      {entry.saved && <Revisions id={entry.saved.id} revision={entry.saved.revision} />}
      {canWork.value && (
        <Button says="measure-withdraw" small icon="trash" onClick={() => model.points.withdraw(entry.key)} />
      )}
    </div>
  );
}

function pixels(point: readonly number[]): string {
  return say("measure-px", { across_px: fixed(point[0] ?? 0, 1), down_px: fixed(point[1] ?? 0, 1) });
}

/** How far the target lies behind the side plane: an estimate, with its own uncertainty. */
function InsetEditor({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const usual = model.insets.usual(entry.values.target);
  const now: Inset | null = entry.values.inset ?? usual;
  if (!now) return null;
  const set = (change: Partial<Inset>): void => model.points.setInset(entry.key, { ...now, ...change });
  const check = (text: string) => lengthProblem(text, { empty: false });
  const own = usual && (usual.inset_m !== now.inset_m || usual.u_inset_m !== now.u_inset_m);
  return (
    <div>
      <p class="small">
        <strong>{say("measure-inset")}</strong> <span class="badge">{say("measure-estimate")}</span>{" "}
        <span class="muted">
          {say(
            entry.values.more.length > 0 || entry.values.follow
              ? "measure-inset-solved"
              : "measure-inset-what",
          )}
        </span>
      </p>
      <div class="height-detail__inset">
        <LengthField
          says="measure-inset"
          disabled={!canWork.value}
          metres={now.inset_m}
          check={check}
          onCommit={(metres) => set({ inset_m: metres ?? now.inset_m })}
        />
        <LengthField
          says="measure-inset-u"
          disabled={!canWork.value}
          metres={now.u_inset_m}
          check={check}
          onCommit={(metres) => set({ u_inset_m: metres ?? now.u_inset_m })}
        />
      </div>
      {own && usual && canWork.value && (
        <Button
          small
          kind="quiet"
          onClick={() => set({ inset_m: usual.inset_m, u_inset_m: usual.u_inset_m })}
        >
          {say("measure-inset-as-survey", {
            inset: formatLength(usual.inset_m, 2),
            u_inset: formatLength(usual.u_inset_m, 2),
          })}
        </Button>
      )}
    </div>
  );
}
