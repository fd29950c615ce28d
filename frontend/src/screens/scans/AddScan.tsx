/** A new line scan: two uploaded strips, or two pixel columns or rows of a recording; and the rig's values. */
import { useRef, useState } from "preact/hooks";
import {
  Button,
  choices,
  DropFiles,
  named,
  OptionalField,
  Problem,
  Segments,
  SelectField,
  TextField,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { fieldsOf, sent } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { BodyOf } from "../../core/routes";
import { formatBytes, parseNumber } from "../../core/units";
import { UploadRow } from "../../parts/uploads/UploadRow";
import { startUpload, uploads } from "../../parts/uploads/uploads";
import { RigFields } from "./RigFields";
import { isValues, NEW_RIG, type RigProblems, type RigTyped, valuesOf } from "./rig";

interface Props {
  surveyId: number;
  onClose?: () => void;
  added: () => Promise<void>;
}

type Source = "strips" | "video";

export function AddScan({ surveyId, onClose, added }: Props) {
  const [source, setSource] = useState<Source>("strips");
  const [name, setName] = useState("");
  const [typed, setTyped] = useState<RigTyped>(NEW_RIG);
  const [problems, setProblems] = useState<RigProblems>({});
  const { busy, problem, run } = useAction();
  const [chosen, setChosen] = useState<ChosenStrips | ChosenCuts | null>(null);
  const send = async (): Promise<void> => {
    const { baseline, uBaseline } = typed;
    const values = valuesOf(source === "video" ? { ...NEW_RIG, baseline, uBaseline, rate: "1" } : typed);
    if (!isValues(values)) return setProblems(values);
    if (!chosen) return;
    const named = name.trim() ? { name: name.trim() } : {};
    await run(async () => {
      const at = { survey_id: surveyId };
      if ("recording_id" in chosen) {
        const { baseline_m, u_baseline_m } = values;
        const body = { baseline_m, u_baseline_m, ...chosen, ...named };
        await api.write("POST /surveys/{survey_id}/scans/from-video", at, { body });
      } else {
        await api.write("POST /surveys/{survey_id}/scans", at, { body: { ...values, ...chosen, ...named } });
      }
      await added();
    });
  };
  return (
    <form class="panel scan-add stack" onSubmit={sent(send)} noValidate aria-label={say("scans-new")}>
      <header class="row row--apart row--far panel__head">
        <h2>{say("scans-new")}</h2>
        <Segments
          says="scans-new-from"
          value={source}
          options={choices(wordsOf("scans-new-", "strips", "video"))}
          onInput={(value) => {
            setSource(value);
            setChosen(null);
          }}
        />
      </header>
      {source === "strips" ? (
        <Strips surveyId={surveyId} choose={setChosen} />
      ) : (
        <Cuts surveyId={surveyId} choose={setChosen} />
      )}
      <RigFields
        typed={typed}
        problems={problems}
        noRate={source === "video"}
        plain={source === "video"}
        change={(part) => {
          setTyped({ ...typed, ...part });
          setProblems({});
        }}
      />
      <TextField says="field-name" value={name} onInput={setName} hint={say("scans-new-name-hint")} />
      <Problem error={problem} />
      <div class="row">
        <Button says="scans-new-read" type="submit" kind="primary" busy={busy} disabled={chosen === null} />
        {onClose && <Button says="action-cancel" onClick={onClose} />}
      </div>
    </form>
  );
}

function Strips({ surveyId, choose }: { surveyId: number; choose: (chosen: ChosenStrips | null) => void }) {
  const waiting = useAsked("GET /surveys/{survey_id}/strip-uploads", { survey_id: surveyId });
  const [picked, setPicked] = useState<PickedStrips>({ first: null, second: null, axis: "width" });
  // an upload that ends asks what is chosen then, not what was chosen when it began
  const latest = useRef(picked);
  const here = waiting.data ?? [];
  const pick = (part: Partial<PickedStrips>): void => {
    const next = { ...latest.current, ...part };
    latest.current = next;
    setPicked(next);
    choose(requestOf(next));
  };
  const arrived = async (): Promise<void> => {
    await waiting.reload();
    const uploaded = await api.ask("GET /surveys/{survey_id}/strip-uploads", { survey_id: surveyId });
    const [first, second] = [...uploaded].sort((a, b) => a.filename.localeCompare(b.filename));
    const untouched = latest.current.first === null && latest.current.second === null;
    if (first && second && untouched) pick({ first: String(first.id), second: String(second.id) });
  };
  const add = (files: File[]): void => {
    for (const file of files) void startUpload(surveyId, file, () => void arrived(), "strip");
  };
  const offered = {
    none: say(here.length === 0 ? "scans-new-no-strip" : "scans-new-choose-strip"),
    options: here.map((one) => ({
      value: String(one.id),
      label: say("scans-new-strip", { file: one.filename, size: formatBytes(one.size_bytes) }),
    })),
  };
  const mine = uploads.value.filter((item) => item.surveyId === surveyId && item.purpose === "strip");
  const field = fieldsOf(picked, pick);
  return (
    <>
      <DropFiles
        label={say("scans-new-choose-both")}
        title={say("scans-new-drop")}
        hint={say("scans-new-drop-hint")}
        accept="image/png,image/tiff,.png,.tif,.tiff,.btf"
        add={add}
      />
      {mine.map((item) => (
        <UploadRow key={item.key} item={item} />
      ))}
      <Problem error={waiting.error} again={waiting.reload} />
      <div class="grid grid--tight">
        <OptionalField says="scans-new-camera-1" {...field("first")} {...offered} />
        <OptionalField
          says="scans-new-camera-2"
          {...field("second")}
          {...offered}
          problem={sameStrip(picked) ? say("scans-new-same-strip") : null}
        />
        <SelectField
          says="scans-new-time-axis"
          {...field("axis")}
          options={choices(wordsOf("scans-new-time-", "width", "height"))}
        />
      </div>
    </>
  );
}

type ChosenStrips = Pick<
  BodyOf<"POST /surveys/{survey_id}/scans">,
  "first_upload" | "second_upload" | "time_axis"
>;
type ChosenCuts = Pick<
  BodyOf<"POST /surveys/{survey_id}/scans/from-video">,
  "recording_id" | "cut_along" | "cut_1_px" | "cut_2_px"
>;

interface PickedStrips {
  readonly first: string | null;
  readonly second: string | null;
  readonly axis: "width" | "height";
}

type CutAlong = NonNullable<ChosenCuts["cut_along"]>;

interface TypedCuts {
  readonly recording: string | null;
  readonly along: CutAlong;
  readonly one: string;
  readonly two: string;
}

const ALONG: Readonly<Record<CutAlong, string>> = wordsOf(
  "scans-new-cut-along-",
  "columns",
  "rows_left_up",
  "rows_right_up",
);

function sameStrip({ first, second }: PickedStrips): boolean {
  return first !== null && first === second;
}

function requestOf(picked: PickedStrips): ChosenStrips | null {
  const { first, second, axis } = picked;
  if (first === null || second === null || sameStrip(picked)) return null;
  return { first_upload: Number(first), second_upload: Number(second), time_axis: axis };
}

function Cuts({ surveyId, choose }: { surveyId: number; choose: (chosen: ChosenCuts | null) => void }) {
  const recordings = useAsked("GET /surveys/{survey_id}/recordings", { survey_id: surveyId });
  const [values, setValues] = useState<TypedCuts>({ recording: null, along: "columns", one: "", two: "" });
  const change = (part: Partial<TypedCuts>): void => {
    const next = { ...values, ...part };
    setValues(next);
    const [one, two] = [parseNumber(next.one), parseNumber(next.two)];
    const whole =
      one !== null && two !== null && Number.isInteger(one) && Number.isInteger(two) && one !== two;
    choose(
      whole && next.recording !== null
        ? { recording_id: Number(next.recording), cut_along: next.along, cut_1_px: one, cut_2_px: two }
        : null,
    );
  };
  const ready = (recordings.data ?? []).filter((one) => one.state === "ready");
  const recording = ready.find((one) => String(one.id) === values.recording);
  const along = values.along === "columns" ? "columns" : "rows";
  const size_px = along === "columns" ? recording?.width_px : recording?.height_px;
  const field = fieldsOf(values, change);
  return (
    <>
      <Problem error={recordings.error} again={recordings.reload} />
      <div class="grid grid--tight">
        <OptionalField
          says="field-recording"
          {...field("recording")}
          none={say(ready.length === 0 ? "scans-new-no-recording" : "scans-new-choose-recording")}
          options={named(ready)}
          hint={say("scans-new-recording-hint")}
        />
        <SelectField says="scans-new-cut-along" {...field("along")} options={choices(ALONG)} />
        <TextField
          label={say("scans-new-cut-1", { along })}
          {...field("one")}
          unit={say("unit-px")}
          hint={
            size_px
              ? say("scans-new-cut-1-hint-to", { last_px: String(size_px - 1) })
              : say("scans-new-cut-1-hint")
          }
        />
        <TextField label={say("scans-new-cut-2", { along })} {...field("two")} unit={say("unit-px")} />
      </div>
    </>
  );
}
