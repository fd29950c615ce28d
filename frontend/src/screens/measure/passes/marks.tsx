/** How a pass reads in the list and on the timeline: which way it goes, and whether a person has seen it. */
import type { Vehicle } from "../../../core/types";
import { isUnconfirmed } from "../../../parts/vehicles/passes";

const WAY = { right: "→", left: "←" } as const;
const WAY_WORDS = { right: "to the right", left: "to the left" } as const;

/** "found →": the word for what the search found and nobody has touched; the arrow wherever it is known. */
export function PassMark({ vehicle }: { vehicle: Vehicle }) {
  const way = vehicle.direction;
  const found = isUnconfirmed(vehicle);
  if (!way && !found) return null;
  return (
    <span class="pass__way" title={passWords(vehicle)}>
      {found && <span class="pass__found">found</span>}
      {way && <span aria-hidden="true">{WAY[way]}</span>}
      {way && <span class="visually-hidden">, {WAY_WORDS[way]}</span>}
    </span>
  );
}

/** The number with the arrow on the side to which the vehicle goes; a question mark while it is only found. */
export function spanLabel(vehicle: Vehicle): string {
  const number = `${String(vehicle.number).padStart(2, "0")}${isUnconfirmed(vehicle) ? "?" : ""}`;
  if (vehicle.direction === "left") return `${WAY.left}${number}`;
  return vehicle.direction === "right" ? `${number}${WAY.right}` : number;
}

/** ", to the right, found and not yet confirmed" */
export function passWords(vehicle: Vehicle): string {
  const words = [
    vehicle.direction && WAY_WORDS[vehicle.direction],
    isUnconfirmed(vehicle) && "found by the search, not yet confirmed",
  ].filter(Boolean);
  return words.join(", ");
}
