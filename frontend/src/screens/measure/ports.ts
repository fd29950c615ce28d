/** The server behind `Records` and `Vehicles`: addresses and bodies, nothing else. */
import { api } from "../../core/api";
import type { Measurement, Recording, Vehicle } from "../../core/types";
import { clickBody } from "../../viewer/values";
import type { RecordsPort } from "./records";
import type { VehiclesPort } from "./vehicles";

export const recordsPort: RecordsPort = {
  create: (vehicleId, clientKey, values) =>
    api.post<Measurement>(
      `/vehicles/${vehicleId}/measurements`,
      { client_key: clientKey, ...clickBody(values) },
      { retry: true },
    ),
  revise: (id, revision, values) =>
    api.put<Measurement>(`/measurements/${id}`, { revision, ...clickBody(values) }),
  withdraw: (id, revision) => api.del<Measurement>(`/measurements/${id}?revision=${revision}`),
  // a repeated one is answered with 409, which `Records` recognises as its own echo
  restore: (id, revision) =>
    api.post<Measurement>(`/measurements/${id}/restore`, { revision }, { retry: true }),
  read: (id) => api.get<Measurement>(`/measurements/${id}`),
};

export const vehiclesPort: VehiclesPort = {
  save: (id, version, changes) => api.put<Vehicle>(`/vehicles/${id}`, { version, ...changes }),
};

export const listVehicles = (surveyId: number) => api.get<Vehicle[]>(`/surveys/${surveyId}/vehicles`);
export const listRecordings = (surveyId: number) => api.get<Recording[]>(`/surveys/${surveyId}/recordings`);
export const readVehicle = (id: number) => api.get<Vehicle>(`/vehicles/${id}`);
export const addVehicle = (recordingId: number, first_frame: number, last_frame: number) =>
  api.post<Vehicle>(`/recordings/${recordingId}/vehicles`, { first_frame, last_frame });
/** Refused when somebody else changed the vehicle since `version`. */
export const removeVehicle = (id: number, version: number) => api.del(`/vehicles/${id}?version=${version}`);
export const restoreVehicle = (id: number) =>
  api.post<Vehicle>(`/vehicles/${id}/restore`, {}, { retry: true });
