/** Whether an answer is a vehicle record with its measurements: what else it holds is only shown. */
import { shapeOf } from "../core/shape";
import type { Vehicle } from "../core/types";

export const isVehicle = shapeOf<Vehicle>({
  id: "number",
  version: "number",
  recording_id: "number",
  number: "number",
  first_frame: "number",
  last_frame: "number",
  measurements: "list",
});
