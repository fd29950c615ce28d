import { render } from "preact";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { type Body, FakeServer } from "../../../testing/server";
import type { Survey } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { INSET_NAMES } from "../../core/words";
import { EditSurvey } from "./EditSurvey";

const inset = { inset_m: 0.12, u_inset_m: 0.05, note: "", code: "roof" };
const survey = {
  id: 5,
  name: "Rouen south",
  site: "",
  description: "",
  version: 1,
  traffic: { traffic_side: null, steering_side: null, camera_place: null },
  place: {
    latitude_deg: null,
    longitude_deg: null,
    road_class: null,
    lane: null,
    travel_direction: null,
    speed_limit_mps: null,
    street_lamps: null,
    time_zone: null,
  },
  asked: { daytime: ["roof", "driver_eye"], low_light: ["roof", "taillight"] },
  insets: Object.fromEntries(INSET_NAMES.map((name) => [name, inset])) as Survey["insets"],
} as unknown as Survey;

const box = (label: string): HTMLInputElement => {
  const found = [...document.querySelectorAll("label")].find((one) => one.textContent?.startsWith(label));
  return document.getElementById(found?.htmlFor ?? "") as HTMLInputElement;
};

async function save(): Promise<Survey["insets"]> {
  const put = vi.fn((_match: unknown, body: Body) => body);
  new FakeServer().on("PUT", /^\/surveys\/5$/, put);
  document.querySelector("form")?.dispatchEvent(new Event("submit", { bubbles: true, cancelable: true }));
  await vi.waitFor(() => expect(put).toHaveBeenCalled());
  return put.mock.calls[0]?.[1]["insets"] as Survey["insets"];
}

beforeEach(() => {
  HTMLDialogElement.prototype.showModal ??= () => {};
});

afterEach(() => {
  render(null, document.body);
  lengthUnit.value = "m";
  vi.unstubAllGlobals();
});

describe("the insets of a survey", () => {
  it("are shown and typed in feet where lengths are in feet", async () => {
    lengthUnit.value = "ft";
    render(<EditSurvey survey={survey} close={() => {}} />, document.body);
    const roof = box("Roof, cars: inset in feet");
    expect(roof.value).toBe("0.3937");
    roof.value = "1";
    roof.dispatchEvent(new Event("input", { bubbles: true }));
    await vi.waitFor(() => expect(box("Roof, cars: inset in feet").value).toBe("1"));
    expect((await save()).roof.inset_m).toBeCloseTo(0.3048, 12);
  });

  it("that were not touched are stored as they were, not as they were shown", async () => {
    lengthUnit.value = "ft";
    render(<EditSurvey survey={survey} close={() => {}} />, document.body);
    expect((await save()).taillight).toEqual(inset);
  });
});
