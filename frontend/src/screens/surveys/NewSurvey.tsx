import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";

export function NewSurvey({ close }: { close: () => void }) {
  const [name, setName] = useState("");
  const [site, setSite] = useState("");
  const [description, setDescription] = useState("");
  const [missing, setMissing] = useState(false);
  const submit = () => {
    setMissing(!name.trim());
    return name.trim() ? make() : null;
  };
  const make = async () => {
    const made = await api.write(
      "POST /surveys",
      {},
      { body: { name: name.trim(), site: site.trim(), description } },
    );
    navigate(`/surveys/${made.id}`);
  };
  return (
    <FormDialog title="New survey" action="Make the survey" onClose={close} submit={submit}>
      <TextField
        label="Name"
        value={name}
        onInput={setName}
        placeholder="Rouen south, lane 1"
        problem={
          missing && !name.trim() ? "Give the survey a name, for example the road and the lane." : null
        }
      />
      <TextField label="Site" value={site} onInput={setSite} placeholder="D938, km 12.4, towards the south" />
      <TextField
        label="Description"
        value={description}
        onInput={setDescription}
        rows={3}
        hint="What whoever opens it in five years should know."
      />
    </FormDialog>
  );
}
