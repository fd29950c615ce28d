/** What the next click on the strips is to hit. */
import type { ScanModel } from "./model";

export function Asked({ model }: { model: ScanModel }) {
  const words = model.stage.hint.value;
  if (words === null) return null;
  const mode = model.mode.value;
  const stretch = mode === "rod" || mode === "height" ? "R stretches, " : "";
  return (
    <p class={stretch ? "strips__asked strips__asked--below" : "strips__asked"} role="status">
      {words} ({stretch}Esc stops)
    </p>
  );
}
