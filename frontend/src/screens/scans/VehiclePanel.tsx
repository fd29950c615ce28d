import {
  Button,
  DataTable,
  type Fact,
  Facts,
  Loading,
  Notice,
  Notices,
  OptionalField,
  Panel,
  StateMark,
} from "../../components";
import { CommitField } from "../../components/CommitField";
import { Said } from "../../components/Said";
import { hint } from "../../core/commands";
import { say, sentenceOf } from "../../core/messages";
import { canWork, may } from "../../core/session";
import { formatMoment, formatPlaceDay, formatPlaceTime, secondDigits } from "../../core/times";
import type { CatalogueRow, ScanMotion, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import {
  fixed,
  formatAcceleration,
  formatHeight,
  formatLength,
  formatSeconds,
  formatSmall,
  formatSpeed,
  lengthUnit,
  parseLength,
  plainLength,
  significant,
} from "../../core/units";
import { budgetSource, STATE_WORDS, vehicleName } from "../../core/words";
import { CatalogueField } from "../../parts/vehicles/CatalogueField";
import { JudgeButton, Reject } from "../../parts/verdicts/Reject";
import { EvidenceButton } from "./EvidenceDialog";
import { HeightList } from "./HeightList";
import { laneByPerson } from "./kinds";
import type { RigLane } from "./lanes";
import { MatchPictures } from "./MatchPictures";
import type { ScanModel } from "./model";
import { ProfileFigure } from "./ProfileFigure";
import { References } from "./References";
import { causeWords, formatMeasured, stateOf } from "./words";

export function VehiclePanel({ model }: { model: ScanModel }) {
  const vehicle = model.chosen.value;
  const detail = model.detail.value;
  if (!vehicle) {
    return (
      <aside class="desk__side scan__side pad" aria-label={say("scan-vehicle")}>
        <p class="muted">{say("scan-vehicle-none", { key: hint("passNext") })}</p>
      </aside>
    );
  }
  const m = vehicle.measurement;
  const lanes = model.scan.value?.rig.lanes ?? [];
  return (
    <aside class="desk__side scan__side" aria-label={say("scan-vehicle")} key={vehicle.id}>
      <header class="row row--far vehicle__head">
        <h2>
          {vehicleName(vehicle.number)}{" "}
          <span class="muted">{[vehicle.make, vehicle.model].filter(Boolean).join(" ")}</span>
        </h2>
        <StateMark state={stateOf(vehicle)} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="pad scan__body stack" role="group" aria-label={say("scan-vehicle-body")} tabIndex={0}>
        {m && <Numbers m={m} vehicle={vehicle} lanes={lanes} />}
        {m && <Verdict model={model} m={m} />}
        {canWork.value && <Tools model={model} m={m} />}
        {m && canWork.value && lanes.length > 0 && <ChooseLane model={model} m={m} lanes={lanes} />}
        {m && <EvidenceButton vehicle={vehicle} />}
        <HeightList model={model} />
        <Known model={model} vehicle={vehicle} />
        <References model={model} vehicle={vehicle} />
        {detail ? (
          <>
            {m?.status === "ok" && <ProfileFigure detail={detail} />}
            <MatchPictures detail={detail} />
            {m?.status === "ok" && <Budget detail={detail} />}
            <History detail={detail} />
          </>
        ) : (
          <Loading what={say("scan-fit-loading")} />
        )}
      </div>
    </aside>
  );
}

function Numbers({ m, vehicle, lanes }: { m: ScanMotion; vehicle: ScanVehicle; lanes: readonly RigLane[] }) {
  return (
    <section class="stack stack--tight" aria-label={say("scan-motion")}>
      {m.status === "ok" ? (
        <p class="vehicle__height" data-testid="scan-speed">
          {formatSpeed(m.speed_mps, m.U95_speed_mps, 2)}
        </p>
      ) : (
        <Notice kind="warning" title={say("scan-not-measurable")}>
          {sentenceOf(m.reason)}
        </Notice>
      )}
      <Notices of={m.warnings} kind="warning" />
      {m.older && <Notice>{say("scan-older")}</Notice>}
      <Facts
        small
        of={[
          m.status === "ok" && [
            say("scan-length"),
            formatMeasured(m.length_m, m.U95_length_m),
            "scan-length",
          ],
          m.status === "ok" && [
            say("scan-acceleration"),
            formatAcceleration(m.acceleration_mps2, m.U95_acceleration_mps2),
          ],
          m.status === "ok" && [
            say("scan-wheelbase"),
            m.wheelbase_m === null
              ? say("scan-wheelbase-none")
              : formatMeasured(m.wheelbase_m, m.U95_wheelbase_m),
            "scan-wheelbase",
          ],
          m.axle_lines !== null && [
            say("scan-axles"),
            say("scan-axles-of", { count: m.axle_lines.length, by: m.axles_by ?? "machine" }),
            "scan-axles",
          ],
          [say("scan-passed"), <Passed vehicle={vehicle} />, "scan-passed"],
          [say("scan-direction"), say("scan-direction-of", { direction: m.direction }), "scan-direction"],
          lanes.length > 0 && [
            say("scan-lane"),
            <>
              {m.lane === null
                ? say("scan-lane-unknown")
                : say("scan-lane-of", { lane: m.lane, by: m.lane_by ?? "machine" })}
              {m.tyres_px !== null && (
                <span class="muted"> {say("scan-lane-tyres", { row: fixed(m.tyres_px, 0) })}</span>
              )}
            </>,
            "scan-lane",
          ],
          ...gapFacts(vehicle.gap),
          [say("scan-by"), byWords(m)],
          m.misalignment_px !== null && [
            say("scan-misalignment"),
            misalignmentWords(m.misalignment_px, m.u_misalignment_px),
          ],
        ]}
      />
    </section>
  );
}

/** From front to front there may be a time where the rear of the vehicle before is not known. */
export function gapFacts(gap: ScanVehicle["gap"]): Fact[] {
  const headway: Fact = gap?.headway_s != null && [
    say("scan-headway"),
    formatSeconds(gap.headway_s, null, 3),
  ];
  if (gap?.time_gap_s == null)
    return [[say("scan-time-gap"), sentenceOf(gap?.reason) ?? say("scan-time-gap-first")], headway];
  return [
    [say("scan-time-gap"), formatSeconds(gap.time_gap_s, gap.U95_time_gap_s, 3)],
    [say("scan-distance-gap"), <DistanceGap gap={gap} />],
    headway,
  ];
}

/** The program proposes; what a person says stays. */
function ChooseLane({ model, m, lanes }: { model: ScanModel; m: ScanMotion; lanes: readonly RigLane[] }) {
  return (
    <OptionalField
      says="scan-lane-choose"
      value={laneByPerson(m)}
      none={say("scan-lane-by-program")}
      options={lanes.map(({ name }) => ({ value: name, label: name }))}
      onInput={(name) => void model.edits.store("lane", name)}
    />
  );
}

/** When its front reached camera 1, or that the recording's start is not known. */
function Passed({ vehicle }: { vehicle: ScanVehicle }) {
  const { filmed_at, U95_filmed_at_s } = vehicle;
  if (!filmed_at) return <>{say("scan-passed-unknown")}</>;
  const digits = secondDigits(U95_filmed_at_s);
  const time = say("scan-passed-at", {
    day: formatPlaceDay(filmed_at),
    time: formatPlaceTime(filmed_at, digits),
  });
  if (U95_filmed_at_s === null) return <>{time}</>;
  return (
    <>{say("scan-passed-within", { time, U95_s: fixed(Math.max(U95_filmed_at_s, 10 ** -digits), digits) })}</>
  );
}

function DistanceGap({ gap }: { gap: NonNullable<ScanVehicle["gap"]> }) {
  const words =
    gap.distance_gap_m === null
      ? sentenceOf(gap.reason)
      : formatHeight(gap.distance_gap_m, gap.U95_distance_gap_m, 2);
  if (gap.paper_distance_gap_m === null) return <>{words}</>;
  return (
    <Said
      what="scan-distance-gap-paper"
      values={{ gap: words ?? "", paper_gap: formatLength(gap.paper_distance_gap_m, 2) }}
    />
  );
}

export function byWords(m: ScanMotion): string {
  const cause = causeWords(m);
  if (m.fit_error_percent === null) return cause;
  return say("scan-cause-scatter", { cause, percent: significant(m.fit_error_percent) });
}

export function misalignmentWords(value: number, u: number | null): string {
  const value_px = fixed(value, 2);
  if (u === null) return say("value-px", { value: value_px });
  return say("scan-misalignment-u", { value_px, u_px: significant(u) });
}

function Tools({ model, m }: { model: ScanModel; m: ScanMotion | null }) {
  const wheels = model.mode.value === "wheels";
  return (
    <div class="row row--wrap">
      <Button
        says="scan-show"
        small
        title={say("scan-show-title") + hint("scanFit")}
        onClick={() => model.show("fit")}
      />
      {m?.status === "ok" && (
        <Button
          says={m.wheelbase_m === null ? "scan-wheels" : "scan-wheels-again"}
          small
          pressed={wheels}
          title={say("scan-wheels-title") + hint("scanWheels")}
          onClick={() => model.start("wheels")}
        />
      )}
      {m?.status === "ok" && (
        <Button
          says="scan-axles-correct"
          small
          pressed={model.mode.value === "axles"}
          title={say("scan-axles-title")}
          onClick={() => model.start("axles")}
        />
      )}
      {m?.axles_by === "person" && (
        <Button says="scan-axles-again" small onClick={() => void model.edits.store("axles", null)} />
      )}
      {model.heights.kept.pose.value && (
        <Button
          says="scan-heights-measure"
          small
          pressed={model.mode.value === "height"}
          title={say("scan-heights-title") + hint("scanHeight")}
          onClick={() => model.heights.begin(null)}
        />
      )}
      <Button
        says="scan-take-out"
        small
        icon="trash"
        title={say("scan-take-out-title") + hint("remove")}
        onClick={() => void model.edits.remove()}
      />
    </div>
  );
}

/** Accept or reject a motion; a second person's work, as for heights. */
function Verdict({ model, m }: { model: ScanModel; m: ScanMotion }) {
  if (m.status !== "ok" || !may("reviewer")) return null;
  if (m.mine) return <Notice>{say("scan-verdict-mine")}</Notice>;
  const { judging } = model;
  if (judging.rejection.begun.value) return <Reject rejection={judging.rejection} busy={model.busy.value} />;
  const given = givenWords(m.review);
  if (given) {
    return (
      <div class="row row--wrap">
        <span class="small grow">{given}</span>
        <Button
          says="scan-verdict-reopen"
          small
          busy={model.busy.value}
          onClick={() => void judging.review("reopened")}
        />
      </div>
    );
  }
  return (
    <div class="row row--wrap">
      <JudgeButton
        of="reviewAccept"
        testId="scan-accept"
        kind="primary"
        icon="check"
        disabled={model.busy.value}
        onClick={() => void judging.review("accepted")}
      />
      <JudgeButton of="reviewReject" testId="scan-reject" onClick={() => judging.reject()} />
    </div>
  );
}

function givenWords({ verdict, reason, reviewer }: ScanMotion["review"]): string | null {
  if (verdict !== "accepted" && verdict !== "rejected") return null;
  const person = reviewer?.name ?? say("scan-by-somebody");
  if (!reason) return say("scan-verdict-given", { verdict, person });
  return say("scan-verdict-given-why", { verdict, person, reason });
}

/** What is known of it, by hand or out of the catalogue. */
function Known({ model, vehicle }: { model: ScanModel; vehicle: ScanVehicle }) {
  const disabled = !canWork.value;
  const length = (value: number | null) => (value === null ? "" : plainLength(value, 3));
  const wrong = (text: string) =>
    text === "" || (parseLength(text) ?? 0) > 0 ? null : say("scan-known-problem");
  return (
    <section class="grid grid--tight" aria-label={say("scan-known")}>
      <CatalogueField
        label={say("scan-known-make")}
        value={vehicle.make ?? ""}
        query={(text) => text}
        disabled={disabled}
        onChoose={(row) => void model.edits.fillIn(fromCatalogue(row))}
        onCommit={(make) => void model.edits.fillIn({ make: make || null })}
      />
      <CatalogueField
        label={say("scan-known-model")}
        value={vehicle.model ?? ""}
        query={(text) => `${vehicle.make ?? ""} ${text}`}
        disabled={disabled}
        onChoose={(row) => void model.edits.fillIn(fromCatalogue(row))}
        onCommit={(name) => void model.edits.fillIn({ model: name || null })}
      />
      {(["length", "wheelbase"] as const).map((name) => (
        <CommitField
          key={name}
          says={`scan-known-${name}`}
          value={length(vehicle[`true_${name}_m`])}
          unit={lengthUnit.value}
          disabled={disabled}
          check={wrong}
          hint={off(vehicle[`${name}_error_m`])}
          onCommit={(text) =>
            // what was typed has not the catalogue's source
            void model.edits.fillIn({ [`true_${name}_m`]: parseLength(text), facts_source: null })
          }
        />
      ))}
    </section>
  );
}

function fromCatalogue({ make, model, category, length_m, wheelbase_m, source }: CatalogueRow) {
  const facts_source = source || "catalogue";
  return { make, model, category, true_length_m: length_m, true_wheelbase_m: wheelbase_m, facts_source };
}

function off(metres: number | null): string | undefined {
  if (metres === null) return undefined;
  return say("scan-known-off", { difference: `${metres < 0 ? "" : "+"}${formatSmall(metres)}` });
}

function Budget({ detail }: { detail: ScanVehicleDetail }) {
  const m = detail.vehicle.measurement;
  const parts = detail.budget.map((one) => ({ ...one, what: <>{budgetSource(one.source)}</> }));
  const together = m && { ...m, source: "", what: <strong>{say("budget-together")}</strong> };
  return (
    <Panel says="budget-title" within note={say("scan-budget-note")}>
      <DataTable
        label={say("scan-budget")}
        class="table--dense"
        rows={together ? [...parts, together] : parts}
        keyOf={(one) => one.source}
        columns={({ col, num }) => [
          col(say("scan-budget-source"), (one) => one.what),
          num(say("scan-budget-speed"), (one) => formatSpeed(one.u_speed_mps, null, 3)),
          num(say("scan-budget-acceleration"), (one) => formatAcceleration(one.u_acceleration_mps2, null, 3)),
          num(say("scan-budget-length"), (one) => formatSmall(one.u_length_m)),
        ]}
      />
    </Panel>
  );
}

function History({ detail }: { detail: ScanVehicleDetail }) {
  const reviews = new Map(detail.reviews.map((one) => [one.revision, one]));
  return (
    <details open={detail.history.length > 1}>
      <summary>{say("scan-history", { count: detail.history.length })}</summary>
      <ul class="stack stack--tight below small">
        {[...detail.history].reverse().map((one) => (
          <li key={one.id}>
            <Said
              what="scan-revision"
              values={{
                speed: one.status === "ok" ? formatSpeed(one.speed_mps, null, 2) : STATE_WORDS.not_measurable,
                length: formatLength(one.length_m),
                cause: causeWords(one),
              }}
            />
            <br />
            <span class="muted">{whoWords(one, reviews.get(one.revision))}</span>
          </li>
        ))}
      </ul>
    </details>
  );
}

function whoWords(one: ScanMotion, review?: ScanVehicleDetail["reviews"][number]): string {
  const person = one.created_by?.name ?? say("scan-by-search");
  const time = formatMoment(one.created_at);
  if (!review) return say("scan-revision-who", { person, time });
  const { verdict, reason } = review;
  const reviewer = review.reviewer?.name ?? say("scan-by-somebody");
  if (!reason) return say("scan-revision-verdict", { person, time, verdict, reviewer });
  return say("scan-revision-verdict-why", { person, time, verdict, reviewer, reason });
}
