import { FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import type { Camera, CameraDetail } from "../../core/types";

export interface AddProps {
  surveyId: number;
  count: number;
  close: () => void;
  added: (camera: Camera) => Promise<void>;
}

export function AddCamera({ surveyId, count, close, added }: AddProps) {
  const first = { name: say("camera-name", { number: String(count + 1) }), ...NOTHING };
  const send = async (body: CameraWords) =>
    added(await api.write("POST /surveys/{survey_id}/cameras", { survey_id: surveyId }, { body }));
  return <CameraDialog title={say("camera-add")} action={say("action-add")} {...{ first, send, close }} />;
}

interface EditProps {
  camera: CameraDetail;
  close: () => void;
  changed: () => Promise<void>;
}

export function EditCamera({ camera, close, changed }: EditProps) {
  const send = async (body: CameraWords) => {
    await api.write("PUT /cameras/{camera_id}", { camera_id: camera.id }, { body });
    await changed();
    close();
  };
  return (
    <CameraDialog
      title={say("camera-edit-title", { camera: camera.name })}
      action={say("action-save")}
      first={camera}
      {...{ send, close }}
    />
  );
}

const NOTHING = { notes: "", lens: "", zoom: "", focus: "" };
type CameraWords = Pick<CameraDetail, "name" | "notes" | "lens" | "zoom" | "focus">;

interface DialogProps {
  title: string;
  action: string;
  first: CameraWords;
  send: (words: CameraWords) => Promise<void>;
  close: () => void;
}

function CameraDialog({ title, action, first, send, close }: DialogProps) {
  const { values: words, field } = useForm<CameraWords>(() => {
    const { name, notes, lens, zoom, focus } = first;
    return { name, notes, lens, zoom, focus };
  });
  const name = words.name.trim();
  return (
    <FormDialog
      label={title}
      action={action}
      onClose={close}
      submit={() => send({ ...words, name })}
      disabled={!name}
    >
      <TextField says="field-name" {...field("name")} problem={name ? null : say("camera-name-problem")} />
      <TextField says="camera-lens-words" {...field("lens")} hint={say("camera-lens-words-hint")} />
      <TextField says="camera-zoom" {...field("zoom")} hint={say("camera-zoom-hint")} />
      <TextField says="camera-focus" {...field("focus")} hint={say("camera-focus-hint")} />
      <TextField says="field-notes" {...field("notes")} rows={2} hint={say("camera-notes-hint")} />
    </FormDialog>
  );
}
