import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import type { Traffic } from "../../core/types";
import { AskedFields, USUALLY_ASKED } from "../../parts/vehicles/AskedFields";
import { NO_PLACE, PlaceFields, readPlace } from "../../parts/vehicles/PlaceFields";
import { TrafficFields } from "../../parts/vehicles/TrafficFields";

const UNSAID: Traffic = { traffic_side: null, steering_side: null, camera_place: null };
const EMPTY = { name: "", site: "", description: "", place: NO_PLACE, traffic: UNSAID, asked: USUALLY_ASKED };

export function NewSurvey({ close }: { close: () => void }) {
  const { values, field } = useForm(EMPTY);
  const name = values.name.trim();
  const [misplaced, setMisplaced] = useState<string | null>(null);
  const [missing, setMissing] = useState(false);
  const submit = async () => {
    setMissing(!name);
    const placed = readPlace(values.place, null);
    setMisplaced(typeof placed === "string" ? placed : null);
    if (!name || typeof placed === "string") return;
    const body = { ...values, name, site: values.site.trim(), place: placed };
    const made = await api.write("POST /surveys", {}, { body });
    navigate(`/surveys/${made.id}`);
  };
  return (
    <FormDialog says="surveys-new" action={say("surveys-new-make")} onClose={close} submit={submit}>
      <TextField
        says="surveys-new-name"
        {...field("name")}
        placeholder={say("surveys-new-name-example")}
        problem={missing && !name ? say("surveys-new-name-problem") : null}
      />
      <TextField says="surveys-new-site" {...field("site")} placeholder={say("surveys-new-site-example")} />
      <TextField
        says="surveys-new-description"
        {...field("description")}
        rows={3}
        hint={say("surveys-new-description-hint")}
      />
      <PlaceFields {...field("place")} />
      {misplaced && <p class="field__problem">{misplaced}</p>}
      <TrafficFields {...field("traffic")} />
      <AskedFields {...field("asked")} />
    </FormDialog>
  );
}
