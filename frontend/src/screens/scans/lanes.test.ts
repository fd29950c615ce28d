import { describe, expect, it } from "vitest";
import { type LaneTyped, lanesOf, NEW_LANE, type RigLane, sameLanes, typedLanes } from "./lanes";

const LANES: RigLane[] = [
  {
    name: "near",
    distance_m: 5.5,
    u_distance_m: 0.15,
    direction: null,
    tyres_from_px: 200,
    tyres_to_px: 256,
    shadow_share: null,
  },
  {
    name: "far",
    distance_m: 9,
    u_distance_m: 0,
    direction: "camera_2_first",
    tyres_from_px: null,
    tyres_to_px: null,
    shadow_share: 0.3,
  },
];

describe("lanes as they are typed", () => {
  it("come back as they were", () => {
    const typed = typedLanes(LANES);
    expect(lanesOf(typed)).toEqual({ lanes: LANES, problems: [{}, {}] });
    expect(sameLanes(typed, LANES)).toBe(true);
    expect(sameLanes(typed.slice(1), LANES)).toBe(false);
  });

  it("keep the digits of a distance that nobody typed when another lane is changed", () => {
    const stored = LANES.map((one) => ({
      ...one,
      distance_m: one.distance_m + 0.0041,
      u_distance_m: 0.012345,
    }));
    const [near, far] = typedLanes(stored) as [LaneTyped, LaneTyped];
    const { lanes } = lanesOf([{ ...near, distance: "5.6" }, far]);
    expect(lanes).toEqual([{ ...stored[0], distance_m: 5.6 }, stored[1]]);
    const swapped = lanesOf([
      { ...near, name: "far" },
      { ...far, name: "kerb" },
    ]);
    expect(swapped.lanes).toEqual([
      { ...stored[0], name: "far" },
      { ...stored[1], name: "kerb" },
    ]);
  });

  it("say what is wrong at the field", () => {
    const { lanes, problems } = lanesOf([
      NEW_LANE,
      { ...NEW_LANE, name: "a", distance: "5", from: "20", to: "10" },
      { ...NEW_LANE, name: "a", distance: "5", from: "20" },
      { ...NEW_LANE, name: "b", distance: "0", shadow: "70" },
    ]);
    expect(lanes).toEqual([]);
    expect(problems.map((one) => Object.keys(one).sort())).toEqual([
      ["distance", "name"],
      ["to"],
      ["name", "to"],
      ["distance", "shadow"],
    ]);
  });
});
