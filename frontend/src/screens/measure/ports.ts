import { api } from "../../core/api";

export const listVehicles = (surveyId: number) =>
  api.ask("GET /surveys/{survey_id}/vehicles", { survey_id: surveyId });
export const listRecordings = (surveyId: number) =>
  api.ask("GET /surveys/{survey_id}/recordings", { survey_id: surveyId });
export const readVehicle = (id: number) => api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id });
