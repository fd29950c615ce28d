/** What the server sends for the curves of a figure; lengths in metres. */
import type { components } from "#schema";

type Schemas = components["schemas"];
export type Ecdf = Schemas["EcdfBody"];
export type Density = Schemas["DensityBody"];
export type Interval = Schemas["Interval"];
export type Standard = Schemas["Standard"];
export type RuleToday = Schemas["RuleToday"];
