/** How a recording's file was read, where a person may have to say: which of its pictures, filmed at what rate. */
import { useState } from "preact/hooks";
import { Button, FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { Recording } from "../../core/types";
import { fixed, parseNumber } from "../../core/units";

interface Props {
  recording: Recording;
  /** Run a request; its refusal is shown on the card. */
  run: (work: () => Promise<unknown>) => Promise<unknown>;
  reload: () => Promise<void>;
}

export function ReadAs({ recording, run, reload }: Props) {
  const { stream_number, clock_doubt, filmed_hz, state } = recording;
  if (state !== "ready") return null;
  return (
    <>
      {stream_number !== null && <Pictures recording={recording} run={run} reload={reload} />}
      {(clock_doubt !== null || filmed_hz !== null) && <Rate recording={recording} reload={reload} />}
    </>
  );
}

function Pictures({ recording, run, reload }: Props) {
  const { pictures, stream_number } = recording;
  const add = (number: number) =>
    run(async () => {
      const values = { recording_id: recording.id, number };
      const made = await api.write("POST /recordings/{recording_id}/pictures/{number}", values);
      toast(say("recordings-picture-added", { name: made.name }));
      await reload();
    });
  return (
    <div class="row row--wrap small" data-testid="pictures">
      <span>{say("recordings-picture-read", { number: stream_number ?? 1, count: pictures.length })}</span>
      {may("operator") &&
        pictures.map(({ codec, width_px, height_px, still, off }, index) => {
          const number = index + 1;
          if (still || off || number === stream_number) return null;
          const what = { number, codec: codec ?? "", size: `${width_px} × ${height_px}` };
          return (
            <Button
              small
              key={number}
              label={say("recordings-picture-read-of", { number, recording: recording.name })}
              onClick={() => void add(number)}
            >
              {say("recordings-picture-read-too", what)}
            </Button>
          );
        })}
    </div>
  );
}

function Rate({ recording, reload }: Pick<Props, "recording" | "reload">) {
  const [asking, setAsking] = useState(false);
  const { filmed_hz } = recording;
  return (
    <div class="row row--wrap small" data-testid="filming-rate">
      <span>
        {filmed_hz === null
          ? say("recordings-filming-rate-unknown")
          : say("recordings-filming-rate-is", { rate: fixed(filmed_hz, filmed_hz % 1 ? 2 : 0) })}
      </span>
      {may("operator") && (
        <Button
          says={filmed_hz === null ? "recordings-filming-rate-state" : "filmed-edit"}
          small
          kind={filmed_hz === null ? "plain" : "quiet"}
          label={say("recordings-filming-rate-of", { recording: recording.name })}
          onClick={() => setAsking(true)}
        />
      )}
      {asking && <RateDialog recording={recording} reload={reload} close={() => setAsking(false)} />}
    </div>
  );
}

function RateDialog({
  recording,
  reload,
  close,
}: Pick<Props, "recording" | "reload"> & { close: () => void }) {
  const [typed, setTyped] = useState(recording.filmed_hz?.toString() ?? "");
  const rate = parseNumber(typed) ?? 0;
  const fits = rate >= 1 && rate <= 2000;
  const submit = async () => {
    const body = { filmed_hz: rate };
    const values = { recording_id: recording.id };
    await api.write("PUT /recordings/{recording_id}/filming-rate", values, { body });
    close();
    await reload();
  };
  return (
    <FormDialog
      label={say("recordings-filming-rate-title", { recording: recording.name })}
      action={say("recordings-filming-rate-action")}
      onClose={close}
      submit={submit}
      disabled={!fits}
    >
      <TextField
        says="recordings-filming-rate"
        hint={say("recordings-filming-rate-hint")}
        problem={typed && !fits ? say("recordings-filming-rate-bounds") : undefined}
        value={typed}
        unit={say("recordings-filming-rate-unit")}
        onInput={setTyped}
      />
    </FormDialog>
  );
}
