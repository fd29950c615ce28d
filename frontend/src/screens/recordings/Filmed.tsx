/** When and in what weather a recording was filmed: proposed from its file, confirmed by a person. */
import { choices, FormDialog, OptionalField, TextField } from "../../components";
import { useForm } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import { formatPlaceMoment } from "../../core/times";
import type { Recording, RecordingChange } from "../../core/types";
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
  const { values, field } = useForm({
    weather: recording.weather ?? "",
    street_lighting: recording.street_lighting,
  });
  const { local, proposed } = start;
  const submit = async () => {
    await start.learning(() => change({ start: start.said(), ...values }));
    close();
  };
  return (
    <FormDialog
      label={say("filmed-title", { recording: recording.name })}
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
        says="filmed-weather"
        {...field("weather")}
        suggestions={say("filmed-weathers").split(", ")}
      />
      <OptionalField
        says="filmed-lamps"
        {...field("street_lighting")}
        none={say("filmed-not-said")}
        options={choices(LAMPS)}
      />
    </FormDialog>
  );
}
