import { say } from "../../core/messages";
import type { ScanModel } from "./model";

export function Asked({ model }: { model: ScanModel }) {
  const words = model.stage.hint.value;
  if (words === null) return null;
  const mode = model.mode.value;
  const stretches = mode === "rod" || mode === "height";
  return (
    <p class={stretches ? "strips__asked strips__asked--below" : "strips__asked"} role="status">
      {say(stretches ? "scan-asked-stretch" : "scan-asked", { what: words })}
    </p>
  );
}
