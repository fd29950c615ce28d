import { ROLE_NAMES, type Role } from "../../core/types";

const DOES: Record<Role, string> = {
  viewer: "sees everything, exports packages",
  operator: "brings in recordings, calibrates, measures",
  reviewer: "what an operator does, and reviews the work of others",
  admin: "everything, and people",
};

/** Each role with its name and what it may do, the least first. */
export const ROLES = (Object.keys(DOES) as Role[]).map((value) => ({
  value,
  label: ROLE_NAMES[value],
  does: DOES[value],
}));
