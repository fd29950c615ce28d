import { wordsOf } from "../../core/messages";
import { ROLE_NAMES, type Role } from "../../core/types";

/** What each role may do. */
export const DOES: Readonly<Record<Role, string>> = wordsOf("people-does-");

/** The one that may do least first. */
export const ROLES = Object.keys(DOES) as readonly Role[];

export function roleOptions(): { value: Role; label: string }[] {
  return ROLES.map((value) => ({ value, label: ROLE_NAMES[value] }));
}
