/** The survey whose pages are open: its name for the breadcrumbs, its steps for the rail. */
import { signal } from "@preact/signals";
import { api } from "../api";
import type { Survey } from "../types";

export const survey = signal<Survey | null>(null);
export const surveyProblem = signal<unknown>(null);

/** Loads the survey, or loads it again when it is the open one already. Call it after anything that changes counts or steps. */
export async function loadSurvey(id: number): Promise<void> {
  if (survey.value?.id !== id) survey.value = null;
  surveyProblem.value = null;
  try {
    survey.value = await api.get<Survey>(`/surveys/${id}`);
  } catch (error) {
    surveyProblem.value = error;
  }
}

export async function refreshSurvey(): Promise<void> {
  if (survey.value) await loadSurvey(survey.value.id);
}
