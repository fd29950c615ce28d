/** One reference value of a vehicle, with its uncertainty and what measured it. */
import { useState } from "preact/hooks";
import { choices, FormDialog, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import type { ReferenceQuantity, ScanReference, ScanVehicle } from "../../core/types";
import { fixed, lengthScale, parseNumber, type Scale, smallScale, speedScale } from "../../core/units";
import type { ScanModel } from "./model";
import { QUANTITY_WORDS, SOURCE_WORDS } from "./referenceWords";

interface Props {
  model: ScanModel;
  vehicle: ScanVehicle;
  /** The value that is corrected; null: one more. */
  before: ScanReference | null;
  onClose: () => void;
}

export function ReferenceDialog({ model, vehicle, before, onClose }: Props) {
  const form = useForm(() => {
    const { quantity = "speed", source = "radar", device = null } = before ?? {};
    const first = scales(quantity);
    const [value, u] = [typed(before?.value, first.value, 3), typed(before?.u, first.u, 3)];
    return { quantity, source, value, u, device: device ?? "" };
  });
  const { quantity, source, value, u, device } = form.values;
  const [asked, setAsked] = useState(false);
  const units = scales(quantity);
  const read = { value: parsed(value, units.value), u: parsed(u, units.u) };
  const submit = async () => {
    setAsked(true);
    if (read.value === null || read.u === null) return;
    const known = vehicle.references.find((one) => one.quantity === quantity && one.source === source);
    await api.write(
      "PUT /scan-vehicles/{vehicle_id}/references/{quantity}/{source}",
      { vehicle_id: vehicle.id, quantity, source },
      {
        body: { value: read.value, u: read.u, device: device.trim() || null, revision: known?.revision ?? 0 },
      },
    );
    onClose();
    await model.refresh();
  };
  return (
    <FormDialog
      label={say(before ? "scan-reference-edit-title" : "scan-reference-add-title", {
        vehicle: String(vehicle.number),
      })}
      action={say("scan-reference-store")}
      onClose={onClose}
      submit={submit}
    >
      <div class="scan__fields">
        <SelectField
          says="scan-reference-quantity"
          {...form.field("quantity")}
          options={choices(QUANTITY_WORDS)}
          disabled={before !== null}
        />
        <SelectField
          says="scan-reference-source"
          {...form.field("source")}
          options={choices(SOURCE_WORDS)}
          disabled={before !== null}
        />
        <TextField
          says="scan-reference-value"
          {...form.field("value")}
          unit={units.value[1]}
          problem={asked && read.value === null ? say("scan-reference-value-problem") : null}
        />
        <TextField
          says="scan-reference-u"
          {...form.field("u")}
          unit={units.u[1]}
          problem={asked && read.u === null ? say("scan-reference-u-problem") : null}
        />
      </div>
      <TextField says="scan-reference-device" {...form.field("device")} />
      <p class="small muted">
        {say(quantity === "speed" ? "scan-reference-note-speed" : "scan-reference-note-length")}
      </p>
    </FormDialog>
  );
}

function scales(quantity: ReferenceQuantity): { value: Scale; u: Scale } {
  return quantity === "speed"
    ? { value: speedScale(), u: speedScale() }
    : { value: lengthScale(), u: smallScale() };
}

function typed(value: number | undefined, [factor]: Scale, digits: number): string {
  return value === undefined ? "" : fixed(value * factor, digits);
}

/** What was typed, in m/s or metres; null for what is no number above 0. */
function parsed(text: string, [factor]: Scale): number | null {
  const number = parseNumber(text);
  return number !== null && number > 0 ? number / factor : null;
}
