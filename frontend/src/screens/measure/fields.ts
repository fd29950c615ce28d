/** What an operator may say of a vehicle, and where two people said different things. */
import { wordsOf } from "../../core/messages";
import type { ChangedVehicle, Vehicle } from "../../core/types";

export type Field = Exclude<keyof ChangedVehicle, "version">;
export type Changes = Partial<Pick<Vehicle, Field>>;

export const FIELD_WORDS: Readonly<Record<Field, string>> = wordsOf("measure-field-");

/** Fields that both sides changed from the base, to different values. */
export function disputedFields(base: Vehicle, mine: Changes, theirs: Vehicle): Field[] {
  return (Object.keys(mine) as Field[]).filter(
    (field) => mine[field] !== base[field] && theirs[field] !== base[field] && theirs[field] !== mine[field],
  );
}
