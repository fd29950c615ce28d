import { choices } from "../../components";
import { wordsOf } from "../../core/messages";
import { ROLE_NAMES, type Role } from "../../core/types";

export const DOES: Readonly<Record<Role, string>> = wordsOf("people-does-");

/** The one that may do least first. Asked when it is drawn: a room's words may come after its code. */
export const roles = (): readonly Role[] => Object.keys(DOES) as Role[];

export const roleOptions = () => choices(ROLE_NAMES, roles());
