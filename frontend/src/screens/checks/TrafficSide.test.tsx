import { signal } from "@preact/signals";
import { render } from "preact";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { me } from "../../core/session";
import type { Me } from "../../core/types";
import type { TrafficModel } from "./model";
import { TrafficSide } from "./TrafficSide";

beforeEach(() => {
  me.value = { person: { id: 1, role: "operator" } } as unknown as Me;
});
afterEach(() => {
  render(null, document.body);
  me.value = undefined;
});

function shown(proposed: boolean): string {
  const pose = {
    verdict: [],
    mean_rad: 0.00087,
    u_mean_rad: 0.001,
    spread_rad: 0.002,
    used: 6,
    vehicles: [],
    turned_from: null,
    proposed,
  };
  const model = {
    preview: signal(null),
    pose: signal(pose),
    passes: signal([]),
    turning: signal(false),
    reel: { recordings: signal([]), recording: signal(undefined) },
  } as unknown as TrafficModel;
  render(<TrafficSide model={model} />, document.body);
  return document.body.textContent ?? "";
}

describe("the verdict on the road's direction", () => {
  it("offers no turn where it says that none is needed, and one where it proposes it", () => {
    expect(shown(false)).not.toContain("Rotate");
    render(null, document.body);
    expect(shown(true)).toContain("Rotate");
  });
});
