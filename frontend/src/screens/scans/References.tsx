/** What something else measured of the chosen vehicle, ours beside it, and whose run it is. */
import { useState } from "preact/hooks";
import { Button, IconButton } from "../../components";
import { CommitField } from "../../components/CommitField";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { toastProblem } from "../../core/toasts";
import type { ScanReference, ScanVehicle } from "../../core/types";
import type { ScanModel } from "./model";
import { ReferenceDialog } from "./ReferenceDialog";
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
    <div class="scan__reference" data-testid="scan-reference">
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
