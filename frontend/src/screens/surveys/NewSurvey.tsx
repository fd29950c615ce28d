import { useState } from "preact/hooks";
import { api } from "../../api";
import { Button, Dialog, Problem, TextField } from "../../components";
import { navigate } from "../../router";
import type { Survey } from "../../types";

export function NewSurvey({ close }: { close: () => void }) {
  const [name, setName] = useState("");
  const [site, setSite] = useState("");
  const [description, setDescription] = useState("");
  const [problem, setProblem] = useState<unknown>(null);
  const [missing, setMissing] = useState(false);
  const [busy, setBusy] = useState(false);
  const submit = async (event: Event) => {
    event.preventDefault();
    setMissing(!name.trim());
    if (!name.trim()) return;
    setBusy(true);
    setProblem(null);
    try {
      const made = await api.post<Survey>("/surveys", { name: name.trim(), site: site.trim(), description });
      navigate(`/surveys/${made.id}`);
    } catch (error) {
      setProblem(error);
      setBusy(false);
    }
  };
  return (
    <Dialog
      title="New survey"
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          <Button
            kind="primary"
            busy={busy}
            onClick={() => document.querySelector<HTMLFormElement>("#new-survey")?.requestSubmit()}
          >
            Make the survey
          </Button>
        </>
      }
    >
      <form id="new-survey" class="stack" onSubmit={submit} noValidate>
        <TextField
          label="Name"
          value={name}
          onInput={setName}
          placeholder="Rouen south, lane 1"
          problem={
            missing && !name.trim() ? "Give the survey a name, for example the road and the lane." : null
          }
        />
        <TextField
          label="Site"
          value={site}
          onInput={setSite}
          placeholder="D938, km 12.4, towards the south"
        />
        <TextField
          label="Description"
          value={description}
          onInput={setDescription}
          rows={3}
          hint="What whoever opens it in five years should know."
        />
        <Problem error={problem} />
        <button type="submit" hidden />
      </form>
    </Dialog>
  );
}
