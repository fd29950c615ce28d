import { useEffect, useRef, useState } from "preact/hooks";
import { SelectField, TextField } from "../../components";
import { setQuery } from "../../core/address";
import { say, sentenceOf } from "../../core/messages";
import { formatDay } from "../../core/times";
import type { Camera } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { type Name, shown, typed, type Values, withCamera } from "./values";

interface Props {
  cameras: readonly Camera[];
  values: Values;
}

/** What is planned with. Each change goes into the address, and from there to the server. */
export function PlanForm({ cameras, values }: Props) {
  const length = lengthUnit.value;
  const px = say("unit-px");
  return (
    <form class="panel panel__body stack plan-form" onSubmit={(event) => event.preventDefault()}>
      <div class="plan-form__camera">
        <CameraChoice cameras={cameras} values={values} />
        {!values.calibration_id && (
          <>
            <Value name="width_px" label={say("planning-width")} unit={px} values={values} />
            <Value name="height_px" label={say("planning-height")} unit={px} values={values} />
            <Value name="field_of_view_deg" label={say("planning-field-of-view")} unit="°" values={values} />
          </>
        )}
      </div>
      <div class="plan-form__place">
        <Value name="camera_height_m" label={say("planning-camera-height")} unit={length} values={values} />
        <Value name="distance_m" label={say("planning-distance")} unit={length} values={values} />
        <Value
          name="board_distance_m"
          label={say("planning-board-distance")}
          unit={length}
          values={values}
          placeholder={say("planning-board-distance-usual")}
        />
        <Value name="direction_deg" label={say("planning-direction")} unit="°" values={values} />
        <Value name="sigma_px" label={say("planning-sigma")} unit={px} values={values} />
        <Value name="travel_m" label={say("planning-travel")} unit={length} values={values} />
      </div>
    </form>
  );
}

function CameraChoice({ cameras, values }: Props) {
  const options = cameras.flatMap((camera) =>
    camera.calibrations.map((one) => ({
      value: String(one.id),
      label: say(
        one.id === camera.current_calibration_id ? "planning-calibration-in-use" : "planning-calibration",
        { camera: camera.name, id: String(one.id), day: formatDay(one.created_at) },
      ),
      summary: one.summary,
    })),
  );
  const chosen = values.calibration_id ?? "plain";
  const found = options.find((option) => option.value === chosen);
  const known = chosen === "plain" || found !== undefined;
  return (
    <SelectField
      says="planning-camera"
      hint={sentenceOf(found?.summary) ?? undefined}
      value={chosen}
      options={[
        ...options.reverse(),
        ...(known ? [] : [{ value: chosen, label: say("planning-calibration-unknown", { id: chosen }) }]),
        { value: "plain", label: say("planning-camera-plain") },
      ]}
      onInput={(choice) => setQuery(withCamera(choice))}
    />
  );
}

interface ValueProps {
  name: Name;
  label: string;
  unit: string;
  values: Values;
  placeholder?: string;
}

const PAUSE_MS = 350;

/** One number. It goes into the address when typing pauses, or at once on Enter and when the field is left. */
export function Value({ name, label, unit, values, placeholder }: ValueProps) {
  const stands = shown(name, values[name]);
  const [text, setText] = useState(stands);
  const [wrong, setWrong] = useState(false);
  const timer = useRef<ReturnType<typeof setTimeout>>(undefined);
  const sent = useRef(values[name] ?? "");
  useEffect(() => {
    // changed from outside: another unit, another camera
    if (sent.current !== (values[name] ?? "") || !name.endsWith("_px"))
      setText((old) => same(name, old, values) ?? stands);
    sent.current = values[name] ?? "";
  }, [values[name], stands]);
  useEffect(() => () => clearTimeout(timer.current), []);
  const send = (value: string) => {
    clearTimeout(timer.current);
    const read = typed(name, value);
    setWrong(read === null);
    if (read === null || read === sent.current) return;
    sent.current = read;
    setQuery({ [name]: read || null });
  };
  return (
    <TextField
      label={label}
      unit={unit}
      value={text}
      placeholder={placeholder}
      problem={wrong ? say("planning-number-problem") : null}
      onInput={(value) => {
        setText(value);
        clearTimeout(timer.current);
        timer.current = setTimeout(() => send(value), PAUSE_MS);
      }}
      onChange={send}
    />
  );
}

/** What is typed, if it stands for the value already ("3.0" for 3). */
function same(name: Name, text: string, values: Values): string | null {
  return typed(name, text) === (values[name] ?? "") ? text : null;
}
