/** The survey whose pages are open: its name for the breadcrumbs, its steps for the rail. */
import { signal } from "@preact/signals";
import { api } from "./api";
import type { BodyOf } from "./routes";
import { toastProblem } from "./toasts";
import type { Survey } from "./types";

export const survey = signal<Survey | null>(null);
export const surveyProblem = signal<unknown>(null);
/** How often what was changed made a page read the survey again: what follows from the survey is asked for again then. */
export const changes = signal(0);
let wanted = 0;

/** Loads the survey, or loads it again when it is the open one already. Call it after anything that changes counts or steps. */
export async function loadSurvey(id: number): Promise<void> {
  if (survey.value?.id !== id) survey.value = null;
  surveyProblem.value = null;
  wanted = id;
  try {
    const found = await api.ask("GET /surveys/{survey_id}", { survey_id: id });
    if (wanted === id) survey.value = found; // another one may have been opened meanwhile
  } catch (error) {
    if (wanted !== id) return;
    // what is open stays open: a failed refresh must not take a half-done measurement off the screen
    if (survey.value?.id === id) toastProblem(error);
    else surveyProblem.value = error;
  }
}

/** Changes some of a survey, and shows it as it is then; what is not told stays. */
export async function changeSurvey(
  { id, name, site, description, version }: Survey,
  part: Partial<BodyOf<"PUT /surveys/{survey_id}">>,
): Promise<void> {
  const body = { name, site, description, version, ...part };
  await api.write("PUT /surveys/{survey_id}", { survey_id: id }, { body });
  await refreshSurvey();
}

export async function refreshSurvey(): Promise<void> {
  if (survey.value) await loadSurvey(survey.value.id);
  changes.value += 1;
}
