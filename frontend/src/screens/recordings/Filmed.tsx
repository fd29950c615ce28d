/** When and in what weather a recording was filmed: proposed from its file, confirmed by a person. */
import { useState } from "preact/hooks";
import { Button, Field, FormDialog, Segments, SelectField, TextField } from "../../components";
import { ApiError } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { formatPlaceMoment, ownZone, placeTime, TIME_ZONES } from "../../core/times";
import type { Recording, RecordingChange, StreetLighting } from "../../core/types";

const LAMPS = wordsOf({ on: "filmed-lamps-on", off: "filmed-lamps-off" });

interface Props {
  recording: Recording;
  change: (part: RecordingChange) => Promise<void>;
}

export function Filmed({ recording, change }: Props) {
  const [editing, setEditing] = useState(false);
  const { started_local, time_zone, weather, street_lighting } = recording;
  const words = [
    started_local && time_zone
      ? say("filmed-start", { time: formatPlaceMoment(started_local), zone: time_zone })
      : proposedWords(recording),
    weather,
    street_lighting && say("filmed-lamps-are", { state: street_lighting }),
  ].filter(Boolean);
  return (
    <div class="row row--wrap small" data-testid="filmed">
      <span>{words.join("  ·  ")}</span>
      {may("operator") && (
        <Button
          small
          kind={started_local ? "quiet" : "plain"}
          label={say(started_local ? "filmed-edit-of" : "filmed-confirm-of", { recording: recording.name })}
          onClick={() => setEditing(true)}
        >
          {say(started_local ? "filmed-edit" : "filmed-confirm")}
        </Button>
      )}
      {editing && <FilmedDialog recording={recording} change={change} close={() => setEditing(false)} />}
    </div>
  );
}

/** That of the survey's place, else the browser's. */
function usualZone(): string {
  return survey.value?.place.time_zone ?? ownZone();
}

function proposedWords(recording: Recording): string {
  const zone = usualZone();
  const local = recording.start_proposed && placeTime(recording.start_proposed, zone);
  return local ? say("filmed-proposed", { time: formatPlaceMoment(local), zone }) : say("filmed-unknown");
}

function FilmedDialog({ recording, change, close }: Props & { close: () => void }) {
  const [zone, setZone] = useState(recording.time_zone ?? usualZone());
  const [typed, setTyped] = useState<string | null>(recording.started_local?.slice(0, 19) ?? null);
  const [offset, setOffset] = useState<string>(recording.started_local?.slice(-6) ?? "");
  // the two offsets of an hour that the clocks showed twice, once the server has said so
  const [twice, setTwice] = useState<readonly string[]>([]);
  const [weather, setWeather] = useState(recording.weather ?? "");
  const [lamps, setLamps] = useState<StreetLighting | "">(recording.street_lighting ?? "");
  const proposed = recording.start_proposed && placeTime(recording.start_proposed, zone);
  const local = typed ?? proposed ?? "";
  const setStart = (time: string) => {
    setTyped(time);
    setTwice([]);
    setOffset("");
  };
  const submit = async () => {
    const said = local + (twice.length > 0 || unchanged(recording, local, zone) ? offset : "");
    const start = local ? { local: said, time_zone: zone.trim() } : null;
    try {
      await change({ start, weather, street_lighting: lamps || null });
    } catch (error) {
      const of =
        error instanceof ApiError && error.said?.code === "local-time-twice" ? error.said.values : null;
      if (of) setTwice([String(of["first"]), String(of["second"])]);
      throw error;
    }
    close();
  };
  return (
    <FormDialog
      title={say("filmed-title", { recording: recording.name })}
      action={say(local && !recording.started_at ? "filmed-confirm-action" : "action-save")}
      onClose={close}
      submit={submit}
    >
      <Field
        label={say("filmed-started")}
        hint={
          proposed
            ? say("filmed-from-file", { time: formatPlaceMoment(proposed) })
            : say("filmed-from-file-none")
        }
      >
        {(wiring) => (
          <span class="row">
            <input
              {...wiring}
              class="input"
              type="datetime-local"
              step="1"
              value={local}
              onInput={(event) => setStart(event.currentTarget.value)}
            />
            {local && (
              <Button small kind="quiet" onClick={() => setStart("")}>
                {say("filmed-unsay")}
              </Button>
            )}
          </span>
        )}
      </Field>
      {twice.length > 0 && (
        <Segments
          label={say("filmed-which")}
          value={offset}
          onChange={setOffset}
          options={twice.map((one, n) => ({
            value: one,
            label: say(n === 0 ? "filmed-first" : "filmed-second", { offset: one }),
          }))}
        />
      )}
      <TextField
        label={say("filmed-zone")}
        value={zone}
        suggestions={TIME_ZONES}
        onInput={(name) => {
          setZone(name);
          setTwice([]);
        }}
      />
      <TextField
        label={say("filmed-weather")}
        value={weather}
        suggestions={say("filmed-weathers").split(", ")}
        onInput={setWeather}
      />
      <SelectField<StreetLighting | "">
        label={say("filmed-lamps")}
        value={lamps}
        options={[
          { value: "", label: say("filmed-not-said") },
          { value: "on", label: LAMPS.on },
          { value: "off", label: LAMPS.off },
        ]}
        onChange={setLamps}
      />
    </FormDialog>
  );
}

/** The start was opened and left as it was: of an hour that came twice it is still the same one. */
function unchanged(recording: Recording, local: string, zone: string): boolean {
  return recording.started_local?.slice(0, 19) === local && recording.time_zone === zone;
}
