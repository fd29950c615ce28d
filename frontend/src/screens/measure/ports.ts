/** What the measure page asks of the server, and passes made and taken out: addresses and bodies, nothing else. */
import { api } from "../../core/api";

export const listVehicles = (surveyId: number) =>
  api.ask("GET /surveys/{survey_id}/vehicles", { survey_id: surveyId });
export const listRecordings = (surveyId: number) =>
  api.ask("GET /surveys/{survey_id}/recordings", { survey_id: surveyId });
export const readVehicle = (id: number) => api.ask("GET /vehicles/{vehicle_id}", { vehicle_id: id });
export const addVehicle = (recordingId: number, first_frame: number, last_frame: number) =>
  api.write(
    "POST /recordings/{recording_id}/vehicles",
    { recording_id: recordingId },
    { body: { first_frame, last_frame } },
  );
/** Refused when somebody else changed the vehicle since `version`. */
export const removeVehicle = (id: number, version: number) =>
  api.write("DELETE /vehicles/{vehicle_id}", { vehicle_id: id, version });
export const restoreVehicle = (id: number) =>
  api.write("POST /vehicles/{vehicle_id}/restore", { vehicle_id: id }, { retry: true });
