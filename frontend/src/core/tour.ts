/** The tour of the demonstration: where it is, and who has been offered it; the panel itself loads when it begins. */
import { signal } from "@preact/signals";
import { navigate } from "./address";
import { api } from "./api";
import { say } from "./messages";
import { addressOf } from "./places";
import { me } from "./session";
import { stored } from "./stored";
import { toast } from "./toasts";
import type { EntryName } from "./work";

export const TOUR = [
  "survey",
  "recordings",
  "pose",
  "measure",
  "review",
  "statistics",
  "export",
] as const satisfies readonly EntryName[];

export interface TourAt {
  surveyId: number;
  step: number;
}

export const tour = signal<TourAt | null>(null);

/** The people who took it or left it in this browser; several may share one. */
const met = stored<number[]>("tour", [], (value) => Array.isArray(value));

export function isTourNew(): boolean {
  const person = me.value?.person.id;
  return person !== undefined && !met.value.includes(person);
}

export async function beginTour(): Promise<void> {
  const demo = (await api.ask("GET /surveys", {})).find((survey) => survey.is_demo);
  if (demo) goTo({ surveyId: demo.id, step: 0 });
  else toast(say("tour-none"));
}

export function stepTour(by: 1 | -1): void {
  const at = tour.value;
  if (at) goTo({ ...at, step: at.step + by });
}

/** It is over, or not wanted: it is not offered to this person again, and begins again from the menu. */
export function endTour(): void {
  tour.value = null;
  const person = me.value?.person.id;
  if (person !== undefined && isTourNew()) met.value = [...met.value, person];
}

function goTo(at: TourAt): void {
  const name = TOUR[at.step];
  if (!name) return;
  tour.value = at;
  navigate(addressOf(name, at.surveyId));
}
