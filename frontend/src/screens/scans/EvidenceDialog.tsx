import { useState } from "preact/hooks";
import { Button, choices, FormDialog, Segments, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say, wordsOf } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { ScanVehicle } from "../../core/types";
import { parseNumber, speedScale } from "../../core/units";
import { vehicleName } from "../../core/words";
import { download } from "../../parts/figures/csv";

type Quantity = "none" | "speed" | "time_gap" | "distance_gap";

const USUAL_RISK_PERCENT = "5";

export function EvidenceButton({ vehicle }: { vehicle: ScanVehicle }) {
  const [asking, setAsking] = useState(false);
  return (
    <div class="row">
      <Button
        says="scan-evidence"
        small
        icon="download"
        title={say("scan-evidence-what")}
        onClick={() => setAsking(true)}
      />
      {asking && <EvidenceDialog vehicle={vehicle} close={() => setAsking(false)} />}
    </div>
  );
}

function EvidenceDialog({ vehicle, close }: { vehicle: ScanVehicle; close: () => void }) {
  const { values, change, field } = useForm({
    quantity: "none" as Quantity,
    limit: "",
    risk: USUAL_RISK_PERCENT,
    source: "",
  });
  const { quantity, limit, risk, source } = values;
  const [problem, setProblem] = useState<string | null>(null);
  const [perMps, speedUnit] = speedScale();
  const unit = { none: "", speed: speedUnit, time_gap: "s", distance_gap: "m" }[quantity];
  /** What it is held against: null where nothing is asked, undefined where what was typed cannot be. */
  const ruleOf = () => {
    if (quantity === "none") return null;
    const [value, share] = [parseNumber(limit) ?? 0, parseNumber(risk) ?? 0];
    if (!(value > 0 && share > 0)) return undefined;
    return { quantity, limit: quantity === "speed" ? value / perMps : value, risk: share / 100, source };
  };
  const submit = async () => {
    const rule = ruleOf();
    if (rule === undefined) return setProblem(say("scan-evidence-problem"));
    const made = await api.write(
      "POST /scan-vehicles/{vehicle_id}/evidence",
      { vehicle_id: vehicle.id },
      { body: { rule } },
    );
    download(made.filename, "text/html", made.html);
    toast(made.decision);
    close();
  };
  return (
    <FormDialog
      label={say("scan-evidence-title", { vehicle: vehicleName(vehicle.number) })}
      action={say("scan-evidence-make")}
      onClose={close}
      submit={submit}
    >
      <p class="small muted">{say("scan-evidence-what")}</p>
      <Segments
        says="scan-evidence-limit-of"
        value={quantity}
        options={choices(wordsOf("scan-evidence-", "none", "speed", "time_gap", "distance_gap"))}
        onInput={(quantity) => {
          change({ quantity });
          setProblem(null);
        }}
      />
      {quantity !== "none" && (
        <>
          <TextField
            says={quantity === "speed" ? "scan-evidence-most" : "scan-evidence-least"}
            unit={unit}
            value={limit}
            problem={problem}
            onInput={(limit) => {
              change({ limit });
              setProblem(null);
            }}
          />
          <TextField
            says="scan-evidence-risk"
            unit="%"
            {...field("risk")}
            hint={say("scan-evidence-risk-hint")}
          />
          <TextField
            says="scan-evidence-source"
            {...field("source")}
            hint={say("scan-evidence-source-hint")}
          />
        </>
      )}
    </FormDialog>
  );
}
