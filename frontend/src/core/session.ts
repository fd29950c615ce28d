import { computed, effect, signal, untracked } from "@preact/signals";
import { navigate, pathname, surveyHere } from "./address";
import { ApiError, api, onSignedOut } from "./api";
import { outbox } from "./outbox";
import { survey } from "./survey";
import type { ActingRole, Me } from "./types";

/** undefined while it is not yet known, null when nobody is signed in */
export const me = signal<Me | null | undefined>(undefined);
export const sessionProblem = signal<unknown>(null);

const RANK: Record<ActingRole, number> = { viewer: 0, operator: 1, reviewer: 2, manager: 3, admin: 4 };

/** Whether the person may do what `role` may, in the survey that the page is about where it is about one. The server
 *  decides; this only keeps buttons honest. */
export function may(role: ActingRole): boolean {
  const there = survey.value?.id === surveyHere.value ? survey.value.my_role : undefined;
  const have = there ?? me.value?.person.role;
  return have !== undefined && RANK[have] >= RANK[role];
}

export const canWork = computed(() => may("operator"));

/** Asks who is signed in. A sign-in that was quicker than the answer knows better: the answer is let go. */
export async function loadSession(): Promise<void> {
  let found: Me | null = null;
  try {
    sessionProblem.value = null;
    found = await api.ask("GET /session", {}, { allowSignedOut: true });
  } catch (error) {
    if (!(error instanceof ApiError && error.status === 401)) {
      sessionProblem.value = error;
      return;
    }
  }
  if (me.value === undefined) me.value = found;
}

/** Whose things this page may still hold, where their session ended by itself. */
let leftBy: number | null = null;

/** Goes on as the person who signed in. What the page holds of somebody else is dropped with it: it is loaded anew. */
export function enter(answer: Me, to: string): void {
  if (leftBy !== null && leftBy !== answer.person.id) {
    location.replace(to);
    return;
  }
  me.value = answer;
  navigate(to, { replace: true });
}

/** Signs out; the page is loaded anew, so that nothing of a survey stays in its memory. */
export async function signOut(): Promise<void> {
  await api.ask("DELETE /session");
  me.value = null;
  navigate("/sign-in");
  location.reload();
}

// a page that the browser kept whole behind a later one would come back with what it showed
window.addEventListener("pageshow", (event) => {
  if (event.persisted) location.reload();
});

const personId = computed(() => me.value?.person.id ?? null);
// what a person left unsaved is sent as theirs, and as nobody else's
effect(() => {
  const id = personId.value;
  untracked(() => outbox.open(id));
});

onSignedOut(() => {
  if (pathname.value === "/sign-in") return;
  const back = location.pathname + location.search;
  leftBy = me.value?.person.id ?? leftBy;
  me.value = null;
  navigate(`/sign-in?next=${encodeURIComponent(back)}`, { replace: true });
});

/** Where to go after signing in: a path of this site and nothing else. */
export function safeNext(next: string | null): string {
  return next && /^\/(?![/\\])/.test(next) && !next.startsWith("/sign-in") ? next : "/";
}
