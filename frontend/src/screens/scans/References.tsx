import { useState } from "preact/hooks";
import { Button, choices, FormDialog, IconButton, SelectField, TextField } from "../../components";
import { CommitField } from "../../components/CommitField";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { toastProblem } from "../../core/toasts";
import type { ReferenceQuantity, ScanReference, ScanVehicle } from "../../core/types";
import { fixed, kept, lengthScale, parseNumber, type Scale, smallScale, speedScale } from "../../core/units";
import type { ScanModel } from "./model";
import { ReferenceImport } from "./ReferenceImport";
import { agreementWords, QUANTITY_WORDS, referenceValue, SOURCE_WORDS } from "./referenceWords";

export function References({ model, vehicle }: { model: ScanModel; vehicle: ScanVehicle }) {
  const [open, setOpen] = useState<"new" | "import" | ScanReference | null>(null);
  const close = () => setOpen(null);
  return (
    <section class="stack stack--tight" aria-labelledby="scan-references">
      <h3 id="scan-references">{say("scan-references")}</h3>
      {vehicle.references.length === 0 && <p class="small muted">{say("scan-references-none")}</p>}
      {vehicle.references.map((one) => (
        <Reference
          key={`${one.quantity} ${one.source}`}
          one={one}
          edit={() => setOpen(one)}
          remove={() => void withdraw(model, vehicle, one).catch(toastProblem)}
        />
      ))}
      {canWork.value && (
        <div class="row row--wrap">
          <Button says="scan-reference-add" small icon="add" onClick={() => setOpen("new")} />
          <Button says="scan-reference-import" small onClick={() => setOpen("import")} />
        </div>
      )}
      <CommitField
        says="scan-run-of"
        value={vehicle.run_of ?? ""}
        hint={say("scan-run-of-hint")}
        disabled={!canWork.value}
        check={(text) => (text.length > 100 ? say("scan-run-of-problem") : null)}
        onCommit={(text) => void model.edits.fillIn({ run_of: text.trim() || null })}
      />
      {open === "import" && <ReferenceImport model={model} onClose={close} />}
      {open !== null && open !== "import" && (
        <ReferenceDialog
          model={model}
          vehicle={vehicle}
          before={open === "new" ? null : open}
          onClose={close}
        />
      )}
    </section>
  );
}

function Reference({ one, edit, remove }: { one: ScanReference; edit: () => void; remove: () => void }) {
  const named = { quantity: QUANTITY_WORDS[one.quantity], source: SOURCE_WORDS[one.source] };
  const outside = one.agreement !== null && !one.agreement.within;
  return (
    <div class="row row--wrap row--apart" data-testid="scan-reference">
      <div>
        <p>
          {say("scan-reference-says", { ...named, value: referenceValue(one) })}{" "}
          {one.device && <span class="muted">{one.device}</span>}
        </p>
        <p class={outside ? "small" : "small muted"}>
          {outside ? <strong>{agreementWords(one)}</strong> : agreementWords(one)}
        </p>
      </div>
      {canWork.value && (
        <div class="row">
          <Button
            says="scan-reference-edit"
            small
            kind="quiet"
            label={say("scan-reference-edit-one", named)}
            onClick={edit}
          />
          <IconButton icon="trash" label={say("scan-reference-remove-one", named)} onClick={remove} />
        </div>
      )}
    </div>
  );
}

async function withdraw(model: ScanModel, vehicle: ScanVehicle, one: ScanReference): Promise<void> {
  const { quantity, source, revision } = one;
  const asked = { vehicle_id: vehicle.id, quantity, source, revision };
  await api.write("DELETE /scan-vehicles/{vehicle_id}/references/{quantity}/{source}", asked);
  await model.refresh();
}

interface Props {
  model: ScanModel;
  vehicle: ScanVehicle;
  /** The value that is corrected; null: one more. */
  before: ScanReference | null;
  onClose: () => void;
}

/** One reference value of a vehicle, with its uncertainty and what measured it. */
function ReferenceDialog({ model, vehicle, before, onClose }: Props) {
  const form = useForm(() => {
    const { quantity = "speed", source = "radar", device = null } = before ?? {};
    return { quantity, source, ...typedOf(quantity, before), device: device ?? "" };
  });
  const { quantity, source, value, u, device } = form.values;
  const [asked, setAsked] = useState(false);
  const units = scales(quantity);
  const read = readOf(quantity, { value, u }, before);
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
      <div class="grid grid--tight">
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

type Figures = Pick<ScanReference, "value" | "u">;

/** A reference's figures as they stand in the form; empty: one more. */
export function typedOf(quantity: ReferenceQuantity, before: Figures | null): Record<keyof Figures, string> {
  const { value, u } = scales(quantity);
  const shown = (metres: number | undefined, [factor]: Scale) =>
    metres === undefined ? "" : fixed(metres * factor, 3);
  return { value: shown(before?.value, value), u: shown(before?.u, u) };
}

/** What stands in the form, in m/s or metres. */
export function readOf(
  quantity: ReferenceQuantity,
  typed: Record<keyof Figures, string>,
  before: Figures | null,
): Record<keyof Figures, number | null> {
  const [units, shown] = [scales(quantity), typedOf(quantity, before)];
  const read = (name: keyof Figures) =>
    kept(typed[name], shown[name], before?.[name], (text) => parsed(text, units[name]));
  return { value: read("value"), u: read("u") };
}

/** What was typed, in m/s or metres; null for what is no number above 0. */
function parsed(text: string, [factor]: Scale): number | null {
  const number = parseNumber(text);
  return number !== null && number > 0 ? number / factor : null;
}
