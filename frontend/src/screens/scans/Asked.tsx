/** What the next click on the strips is to hit. */

import { formatLength } from "../../core/units";
import { TARGET_HINTS } from "../../core/words";
import type { ScanModel } from "./model";

export function Asked({ model }: { model: ScanModel }) {
  const mode = model.mode.value;
  if (mode === "look") return null;
  const stretch = mode === "rod" || mode === "height" ? "R stretches, " : "";
  return (
    <p class={stretch ? "strips__asked strips__asked--below" : "strips__asked"} role="status">
      {wordsOf(model)} ({stretch}Esc stops)
    </p>
  );
}

function wordsOf(model: ScanModel): string {
  const second = model.firstClick.value !== null;
  const { heights, rod } = model;
  switch (model.mode.value) {
    case "wheels":
      return `Click the hub of the ${second ? "rear" : "front"} wheel on camera 1`;
    case "rod": {
      const { distance_m, height_m } = rod.next.value;
      if (distance_m === null) return "Enter the rod's distance on the right";
      return `Click the rod ${formatLength(distance_m, 2)} away, ${formatLength(height_m, 2)} above the road`;
    }
    case "height":
      if (!heights.contact.value) return "Click where a tyre stands on the road, on camera 1";
      return `Click ${heights.target.value ? TARGET_HINTS[heights.target.value] : "the target"}`;
    default:
      return `Click the vehicle's ${second ? "rear" : "front"} on camera 1`;
  }
}
