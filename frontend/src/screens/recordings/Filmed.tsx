/** When and in what weather a recording was filmed: proposed from its file, confirmed by a person. */
import { useState } from "preact/hooks";
import { FormDialog, SelectField, TextField } from "../../components";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import { formatPlaceMoment } from "../../core/times";
import type { Recording, RecordingChange, StreetLighting } from "../../core/types";
import { StartFields, StartLine, startWords, useStart } from "../../parts/filming/start";

const LAMPS = wordsOf({ on: "filmed-lamps-on", off: "filmed-lamps-off" });

interface Props {
  recording: Recording;
  change: (part: RecordingChange) => Promise<void>;
}

export function Filmed({ recording, change }: Props) {
  const { weather, street_lighting } = recording;
  const words = [
    startWords(recording, say("filmed-unknown")),
    weather,
    street_lighting && say("filmed-lamps-are", { state: street_lighting }),
  ].filter(Boolean);
  return (
    <StartLine
      testId="filmed"
      words={words.join("  ·  ")}
      of={recording}
      edit={say("filmed-edit-of", { recording: recording.name })}
      mayChange={may("operator")}
      dialog={(close) => <FilmedDialog recording={recording} change={change} close={close} />}
    />
  );
}

function FilmedDialog({ recording, change, close }: Props & { close: () => void }) {
  const start = useStart(recording);
  const [weather, setWeather] = useState(recording.weather ?? "");
  const [lamps, setLamps] = useState<StreetLighting | "">(recording.street_lighting ?? "");
  const { local, proposed } = start;
  const submit = async () => {
    try {
      await change({ start: start.said(), weather, street_lighting: lamps || null });
    } catch (error) {
      start.learn(error);
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
      <StartFields
        start={start}
        label={say("filmed-started")}
        hint={
          proposed
            ? say("filmed-from-file", { time: formatPlaceMoment(proposed) })
            : say("filmed-from-file-none")
        }
        step="1"
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
