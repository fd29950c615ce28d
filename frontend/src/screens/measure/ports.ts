/** The server behind `Records` and `Vehicles`: addresses and bodies, nothing else. */
import { api } from "../../core/api";
import { clickBody } from "../../viewer/values";
import type { RecordsPort } from "./records";
import type { VehiclesPort } from "./vehicles";

export const recordsPort: RecordsPort = {
  create: (vehicleId, clientKey, values) =>
    api.write(
      "POST /vehicles/{vehicle_id}/measurements",
      { vehicle_id: vehicleId },
      { body: { client_key: clientKey, ...clickBody(values) }, retry: true },
    ),
  revise: (id, revision, values) =>
    api.write(
      "PUT /measurements/{measurement_id}",
      { measurement_id: id },
      { body: { revision, ...clickBody(values) } },
    ),
  withdraw: (id, revision) =>
    api.write("DELETE /measurements/{measurement_id}", { measurement_id: id, revision }),
  // a repeated one is answered with 409, which `Records` recognises as its own echo
  restore: (id, revision) =>
    api.write(
      "POST /measurements/{measurement_id}/restore",
      { measurement_id: id },
      { body: { revision }, retry: true },
    ),
  read: (id) => api.ask("GET /measurements/{measurement_id}", { measurement_id: id }),
};

export const vehiclesPort: VehiclesPort = {
  save: (id, version, changes) =>
    api.write("PUT /vehicles/{vehicle_id}", { vehicle_id: id }, { body: { version, ...changes } }),
};

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
