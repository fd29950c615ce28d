import { useEffect, useRef, useState } from "preact/hooks";
import { SelectField, TextField } from "../../components";
import { setQuery } from "../../core/address";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { formatDay } from "../../core/times";
import type { Camera } from "../../core/types";
import { type Name, shown, typed, unitOf, type Values, withCamera } from "./values";

interface Props {
  cameras: readonly Camera[];
  values: Values;
}

const PICTURE = wordsOf("planning-picture-", "width_px", "height_px", "field_of_view_deg");
const PLACE = wordsOf({
  camera_height_m: "planning-camera-height",
  distance_m: "planning-distance",
  board_distance_m: "planning-board-distance",
  direction_deg: "planning-direction",
  sigma_px: "planning-sigma",
  travel_m: "planning-travel",
});

/** What is planned with. Each change goes into the address, and from there to the server. */
export function PlanForm({ cameras, values }: Props) {
  return (
    <form class="panel panel__body stack plan-form" onSubmit={(event) => event.preventDefault()}>
      <div class="plan-form__camera">
        <CameraChoice cameras={cameras} values={values} />
        {!values.calibration_id && <ValueFields words={PICTURE} values={values} />}
      </div>
      <div class="plan-form__place">
        <ValueFields words={PLACE} values={values} />
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

const PAUSE_MS = 350;
const LEFT_EMPTY: Partial<Record<Name, string>> = wordsOf("planning-usual-");

/** A field for each value that `words` names. */
export function ValueFields({ words, values }: { words: Partial<Record<Name, string>>; values: Values }) {
  const fields = Object.entries(words) as [Name, string][];
  return (
    <>
      {fields.map(([name, label]) => (
        <Value key={name} name={name} label={label} values={values} />
      ))}
    </>
  );
}

/** One number. It goes into the address when typing pauses, or at once on Enter and when the field is left. */
function Value({ name, label, values }: { name: Name; label: string; values: Values }) {
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
      unit={unitOf(name)}
      value={text}
      placeholder={LEFT_EMPTY[name]}
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
