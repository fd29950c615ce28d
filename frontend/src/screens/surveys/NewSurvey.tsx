import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { Traffic } from "../../core/types";
import { AskedFields, USUALLY_ASKED } from "../../parts/vehicles/AskedFields";
import { TrafficFields } from "../../parts/vehicles/TrafficFields";

const UNSAID: Traffic = { traffic_side: null, steering_side: null, camera_place: null };

export function NewSurvey({ close }: { close: () => void }) {
  const [name, setName] = useState("");
  const [site, setSite] = useState("");
  const [description, setDescription] = useState("");
  const [traffic, setTraffic] = useState<Traffic>(UNSAID);
  const [asked, setAsked] = useState(USUALLY_ASKED);
  const [missing, setMissing] = useState(false);
  const submit = () => {
    setMissing(!name.trim());
    return name.trim() ? make() : null;
  };
  const make = async () => {
    const made = await api.write(
      "POST /surveys",
      {},
      { body: { name: name.trim(), site: site.trim(), description, traffic, asked } },
    );
    navigate(`/surveys/${made.id}`);
  };
  return (
    <FormDialog title={say("surveys-new")} action={say("surveys-new-make")} onClose={close} submit={submit}>
      <TextField
        label={say("surveys-new-name")}
        value={name}
        onInput={setName}
        placeholder={say("surveys-new-name-example")}
        problem={missing && !name.trim() ? say("surveys-new-name-problem") : null}
      />
      <TextField
        label={say("surveys-new-site")}
        value={site}
        onInput={setSite}
        placeholder={say("surveys-new-site-example")}
      />
      <TextField
        label={say("surveys-new-description")}
        value={description}
        onInput={setDescription}
        rows={3}
        hint={say("surveys-new-description-hint")}
      />
      <TrafficFields traffic={traffic} onChange={setTraffic} />
      <AskedFields asked={asked} onChange={setAsked} />
    </FormDialog>
  );
}
