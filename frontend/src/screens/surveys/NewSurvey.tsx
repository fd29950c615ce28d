import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { Place, Traffic } from "../../core/types";
import { AskedFields, USUALLY_ASKED } from "../../parts/vehicles/AskedFields";
import { NO_PLACE, PlaceFields, readPlace } from "../../parts/vehicles/PlaceFields";
import { TrafficFields } from "../../parts/vehicles/TrafficFields";

const UNSAID: Traffic = { traffic_side: null, steering_side: null, camera_place: null };

export function NewSurvey({ close }: { close: () => void }) {
  const [name, setName] = useState("");
  const [site, setSite] = useState("");
  const [description, setDescription] = useState("");
  const [traffic, setTraffic] = useState<Traffic>(UNSAID);
  const [asked, setAsked] = useState(USUALLY_ASKED);
  const [place, setPlace] = useState(NO_PLACE);
  const [misplaced, setMisplaced] = useState<string | null>(null);
  const [missing, setMissing] = useState(false);
  const submit = () => {
    setMissing(!name.trim());
    const placed = readPlace(place, null);
    setMisplaced(typeof placed === "string" ? placed : null);
    return name.trim() && typeof placed !== "string" ? make(placed) : null;
  };
  const make = async (placed: Place) => {
    const made = await api.write(
      "POST /surveys",
      {},
      { body: { name: name.trim(), site: site.trim(), description, place: placed, traffic, asked } },
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
      <PlaceFields place={place} onChange={setPlace} />
      {misplaced && <p class="field__problem">{misplaced}</p>}
      <TrafficFields traffic={traffic} onChange={setTraffic} />
      <AskedFields asked={asked} onChange={setAsked} />
    </FormDialog>
  );
}
