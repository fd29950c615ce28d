import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import type { Camera } from "../../core/types";

interface AddProps {
  surveyId: number;
  count: number;
  close: () => void;
  added: (camera: Camera) => Promise<void>;
}

export function AddCamera({ surveyId, count, close, added }: AddProps) {
  const [name, setName] = useState(count === 0 ? "Camera 1" : `Camera ${count + 1}`);
  const [notes, setNotes] = useState("");
  const submit = async () => {
    await added(
      await api.write(
        "POST /surveys/{survey_id}/cameras",
        { survey_id: surveyId },
        { body: { name: name.trim(), notes } },
      ),
    );
  };
  return (
    <FormDialog title="Add a camera" action="Add" onClose={close} submit={submit} disabled={!name.trim()}>
      <TextField
        label="Name"
        value={name}
        onInput={setName}
        problem={name.trim() ? null : "A camera needs a name."}
      />
      <TextField
        label="Notes"
        value={notes}
        onInput={setNotes}
        rows={2}
        hint="Body, lens, zoom and focus setting: what must stay the same for the calibration to hold."
      />
    </FormDialog>
  );
}
