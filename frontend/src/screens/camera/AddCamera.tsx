import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { Camera } from "../../core/types";

interface AddProps {
  surveyId: number;
  count: number;
  close: () => void;
  added: (camera: Camera) => Promise<void>;
}

export function AddCamera({ surveyId, count, close, added }: AddProps) {
  const [name, setName] = useState(() => say("camera-name", { number: String(count + 1) }));
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
    <FormDialog
      title={say("camera-add")}
      action={say("action-add")}
      onClose={close}
      submit={submit}
      disabled={!name.trim()}
    >
      <TextField
        label={say("field-name")}
        value={name}
        onInput={setName}
        problem={name.trim() ? null : say("camera-name-problem")}
      />
      <TextField
        label={say("field-notes")}
        value={notes}
        onInput={setNotes}
        rows={2}
        hint={say("camera-notes-hint")}
      />
    </FormDialog>
  );
}
