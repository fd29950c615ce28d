/** How a pass reads in the list and on the timeline: which way it goes, and whether a person has seen it. */
import { say, wordsOf } from "../../../core/messages";
import type { Vehicle } from "../../../core/types";
import { vehicleName } from "../../../core/words";
import { isUnconfirmed } from "../../../parts/vehicles/passes";

const WAY = { right: "→", left: "←" } as const;
const WAY_WORDS = wordsOf("measure-way-");

/** "found →": the word for what the search found and nobody has touched; the arrow wherever it is known. */
export function PassMark({ vehicle }: { vehicle: Vehicle }) {
  const way = vehicle.direction;
  const found = isUnconfirmed(vehicle);
  if (!way && !found) return null;
  return (
    <span class="pass__way" title={passWords(vehicle)}>
      {found && <span class="pass__found">{say("measure-pass-found")}</span>}
      {way && <span aria-hidden="true">{WAY[way]}</span>}
      {way && <span class="visually-hidden">, {WAY_WORDS[way]}</span>}
    </span>
  );
}

/** The number with the arrow on the side to which the vehicle goes; a question mark while it is only found. */
export function spanLabel(vehicle: Vehicle): string {
  const number = `${vehicleName(vehicle.number)}${isUnconfirmed(vehicle) ? "?" : ""}`;
  if (vehicle.direction === "left") return `${WAY.left}${number}`;
  return vehicle.direction === "right" ? `${number}${WAY.right}` : number;
}

/** "to the right, found and not yet confirmed" */
export function passWords(vehicle: Vehicle): string {
  const way = vehicle.direction;
  if (!isUnconfirmed(vehicle)) return way ? WAY_WORDS[way] : "";
  return way ? say("measure-unconfirmed-way", { way }) : say("measure-unconfirmed");
}
