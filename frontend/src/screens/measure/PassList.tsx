/** The passes of the survey with their state; filter, order, a new pass. */
import { useComputed } from "@preact/signals";
import { Button, choices, Icon, IconButton, LongList, Select, StateMark } from "../../components";
import { late, soon } from "../../components/late";
import { useRowsIn } from "../../components/oneTabStop";
import { Said } from "../../components/Said";
import { hint } from "../../core/commands";
import { held } from "../../core/form";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { formatPlaceClock, formatPlaceMoment } from "../../core/times";
import type { Vehicle } from "../../core/types";
import { LIGHTING_NOUNS, LIGHTING_WORDS, STATE_WORDS, vehicleName } from "../../core/words";
import { FILTER_WORDS, isOpen, lacksClass, ORDER_WORDS } from "../../parts/vehicles/passes";
import { SampleQuotas, useSample } from "../../parts/vehicles/SampleQuotas";
import { filter, type MeasureModel, order } from "./model";
import { readAgain } from "./passes/actions";
import { PassMark } from "./passes/marks";
import { PassMenu } from "./passes/PassMenu";
import { isStored } from "./records";
import "../../parts/vehicles/passes.css";

const FindPasses = late(async () => (await import("../../parts/vehicles/FindPasses")).FindPasses);
const ProposeButton = soon(async () => (await import("./proposals/ProposeButton")).ProposeButton);

const ROW_PX = 43;

export function PassList({ model }: { model: MeasureModel }) {
  const all = model.vehicles.list.value;
  const list = model.list.value;
  const open = all.filter(isOpen).length;
  const rejected = all.filter((vehicle) => vehicle.state === "rejected").length;
  const recording = model.reel.recording.value;
  const box = useRowsIn<HTMLDivElement>(".pass", "data-vehicle", model.vehicleId);
  return (
    <nav class="passes" aria-label={say("measure-passes")}>
      <header class="passes__head">
        <h2>
          <Said
            what="measure-passes-open"
            values={{ count: open - rejected, rejected }}
            parts={{ muted: (text) => <span class="muted small">{text}</span> }}
          />
        </h2>
        <div class="passes__choose">
          <Select aria-label={say("measure-passes-show")} options={choices(FILTER_WORDS)} {...held(filter)} />
          <Select aria-label={say("measure-passes-order")} options={choices(ORDER_WORDS)} {...held(order)} />
        </div>
      </header>
      <Quotas model={model} />
      <LongList
        class="passes__list"
        box={box}
        rows={list}
        row_px={ROW_PX}
        row={(vehicle) => <Row key={vehicle.id} model={model} vehicle={vehicle} />}
      >
        {list.length === 0 && model.loaded.value && (
          <div role="listitem" class="pad small muted">
            {say(all.length === 0 ? "measure-passes-none" : "measure-passes-none-in-state")}
            {all.length === 0 && recording && (
              <FindPasses recording={recording} found={() => readAgain(model)} />
            )}
          </div>
        )}
      </LongList>
      {canWork.value && <ProposeButton model={model} />}
      {canWork.value && <NewPass model={model} />}
    </nav>
  );
}

/** How far the quotas are; read again when a pass changes its state. */
function Quotas({ model }: { model: MeasureModel }) {
  const passes = useComputed(() =>
    model.loaded.value
      ? model.vehicles.list.value.map((one) => `${one.id}${one.state}${one.category}${one.lighting}`).join()
      : null,
  );
  const found = useSample(model.surveyId, passes.value);
  const quotas = found.data?.quotas ?? [];
  return quotas.length > 0 ? (
    <div class="passes__quotas">
      <SampleQuotas quotas={quotas} />
    </div>
  ) : null;
}

function Row({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  // computed, so that a moving point or another row's change draws this row only if it reads differently
  const current = useComputed(() => model.vehicleId.value === vehicle.id).value;
  const word = useComputed(() => progress(model, vehicle)).value;
  const name = useComputed(() => {
    const shown = model.vehicles.shown(vehicle.id) ?? vehicle;
    const car = [shown.make, shown.model].filter(Boolean).join(" ");
    return shown.check_target ? [say("measure-check-target-mark"), car].join(" ").trim() : car;
  }).value;
  return (
    <div role="listitem">
      <button
        type="button"
        class="pass"
        data-testid={`pass-${vehicle.number}`}
        data-vehicle={vehicle.id}
        data-state={vehicle.state}
        aria-current={current ? "true" : undefined}
        onClick={() => {
          model.open(vehicle);
          model.stage.focus();
        }}
      >
        <strong class="pass__number">{vehicleName(vehicle.number)}</strong>
        <span class="pass__state">
          <StateMark state={vehicle.state} word={word} />
        </span>
        <ToLookAt vehicle={vehicle} />
        <PassMark vehicle={vehicle} />
        {vehicle.lighting === "low_light" && (
          <span class="muted" title={LIGHTING_WORDS.low_light}>
            <Moon />
            <span class="visually-hidden">, {LIGHTING_NOUNS.low_light}</span>
          </span>
        )}
        {(name || vehicle.filmed_at) && (
          <span class="pass__line">
            {vehicle.filmed_at && (
              <time
                class="pass__time"
                dateTime={vehicle.filmed_at}
                title={say("filmed-at", { time: formatPlaceMoment(vehicle.filmed_at) })}
              >
                {formatPlaceClock(vehicle.filmed_at)}
              </time>
            )}
            {name && (
              <span class="pass__name clip" title={name}>
                {name}
              </span>
            )}
          </span>
        )}
      </button>
    </div>
  );
}

/** What is to be looked at again, so that it is seen from the list: a height that does not fit, a missing class. */
function ToLookAt({ vehicle }: { vehicle: Vehicle }) {
  const doubts = vehicle.doubts.length;
  const told = [
    ...(doubts > 0 ? [say("passes-doubts", { count: doubts })] : []),
    ...(lacksClass(vehicle) ? [say("passes-class-missing")] : []),
  ].join(" ");
  if (told === "") return null;
  return (
    <span class="pass__doubt" title={told} data-testid={`look-${vehicle.number}`}>
      <Icon name={doubts > 0 ? "warning" : "info"} size={14} />
      <span class="visually-hidden">, {told}</span>
    </span>
  );
}

/** "2 of 3" while it is being measured, else the state's own word. */
export function progress({ records }: Pick<MeasureModel, "records">, vehicle: Vehicle): string | undefined {
  if (vehicle.state === "rejected") return STATE_WORDS.rejected;
  if (vehicle.state === "accepted") return undefined;
  const have = new Set(
    records
      .of(vehicle.id)
      .filter((entry) => !entry.values.withdrawn && isStored(entry))
      .map((entry) => entry.values.target),
  );
  const { asked } = vehicle;
  const count = asked.filter((target) => have.has(target) || vehicle[`${target}_not_visible`]).length;
  return count > 0 && count < asked.length
    ? say("measure-progress", { count, all: asked.length })
    : undefined;
}

function NewPass({ model }: { model: MeasureModel }) {
  const from = model.passes.from.value;
  return (
    <footer class="row row--wrap row--near passes__foot">
      {from === null ? (
        <Button
          says="measure-pass-begin"
          small
          icon="add"
          title={say("measure-pass-begins") + hint("passBegin")}
          onClick={() => model.passes.mark("first")}
        />
      ) : (
        <>
          <Button
            says="measure-pass-end"
            small
            kind="primary"
            title={say("measure-pass-ends") + hint("passEnd")}
            onClick={() => model.passes.mark("last")}
          />
          <IconButton
            icon="close"
            label={say("measure-pass-drop")}
            onClick={() => {
              model.passes.from.value = null;
            }}
          />
          <span class="small muted">
            {say("measure-pass-frames", { count: Math.abs(model.seenFrame.value - from) + 1 })}
          </span>
        </>
      )}
      {from === null && <PassMenu model={model} />}
    </footer>
  );
}

function Moon() {
  return (
    <svg width="12" height="12" viewBox="0 0 12 12" aria-hidden="true">
      <path d="M10.5 7.6A4.8 4.8 0 014.4 1.5a4.8 4.8 0 106.1 6.1z" fill="currentColor" />
    </svg>
  );
}
