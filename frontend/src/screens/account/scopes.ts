import { wordsOf } from "../../core/messages";
import type { ApiToken } from "../../core/types";

export type Scope = ApiToken["scopes"][number];

export const SCOPES: readonly Scope[] = ["read", "upload", "measure", "review", "export"];

export const SCOPE_NAMES = wordsOf("token-scope-", "read", "upload", "measure", "review", "export");

export const SCOPE_HINTS = wordsOf("token-scope-hint-");
