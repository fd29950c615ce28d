import { describe, expect, it } from "vitest";
import type { Target } from "../../core/types";
import { imagePoint } from "../../viewer/points";
import { awaiting, type Flow, type FlowEvent, firstMissing, START, step } from "./flow";

const at = (x: number, y: number) => imagePoint(x, y);
const open: FlowEvent = { type: "open", vehicleId: 7, target: "roof" };

function run(...events: FlowEvent[]): Flow {
  return events.reduce((flow, event) => step(flow, event).flow, START);
}

describe("the measuring flow", () => {
  it("asks for the contact first, then stores the target", () => {
    const opened = run(open);
    expect(awaiting(opened, 40)).toBe("contact");
    const first = step(opened, { type: "click", frame: 40, point: at(100, 400) });
    expect(first.effect).toMatchObject({ type: "contact", before: null });
    expect(awaiting(first.flow, 40)).toBe("point");
    const second = step(first.flow, { type: "click", frame: 40, point: at(101, 250) });
    expect(second.effect).toEqual({
      type: "store",
      vehicleId: 7,
      target: "roof",
      frame: 40,
      contact: at(100, 400),
      point: at(101, 250),
    });
  });

  it("serves several targets with one contact", () => {
    const contact: FlowEvent = { type: "click", frame: 40, point: at(100, 400) };
    const flow = run(open, contact, { type: "stored", missing: ["driver_eye", "taillight"] });
    expect(flow.target).toBe("driver_eye");
    const eye = step(flow, { type: "click", frame: 40, point: at(90, 300) });
    expect(eye.effect).toMatchObject({ type: "store", target: "driver_eye", contact: at(100, 400) });
  });

  it("does not use a contact on another frame, and finds it again on its own", () => {
    const flow = run(open, { type: "click", frame: 40, point: at(100, 400) });
    expect(awaiting(flow, 41)).toBe("contact");
    expect(awaiting(flow, 40)).toBe("point");
  });

  it("places a new contact when asked, and remembers the one before", () => {
    const flow = run(open, { type: "click", frame: 40, point: at(1, 2) }, { type: "new-contact" });
    const outcome = step(flow, { type: "click", frame: 40, point: at(3, 4) });
    expect(outcome.effect).toEqual({ type: "contact", frame: 40, before: at(1, 2), point: at(3, 4) });
    expect(outcome.flow.renew).toBe(false);
  });

  it("stores nothing once all targets are there", () => {
    const flow = run(open, { type: "click", frame: 40, point: at(1, 2) }, { type: "stored", missing: [] });
    expect(flow.target).toBeNull();
    expect(awaiting(flow, 40)).toBeNull();
    expect(step(flow, { type: "click", frame: 40, point: at(5, 5) }).effect).toBeNull();
  });

  it("never stores without a vehicle", () => {
    const flow = run({ type: "choose", target: "roof" });
    expect(step(flow, { type: "click", frame: 1, point: at(5, 5) }).effect).toBeNull();
  });

  it("takes one thing back at each Esc", () => {
    const contact: FlowEvent = { type: "click", frame: 40, point: at(1, 2) };
    let flow = run(open, contact, { type: "new-contact" });
    flow = step(flow, { type: "select", selection: { key: null, role: "contact" } }).flow;
    const esc: FlowEvent = { type: "escape", frame: 40, used: false };
    flow = step(flow, esc).flow;
    expect(flow.selection).toBeNull();
    flow = step(flow, esc).flow;
    expect(flow.renew).toBe(false);
    flow = step(flow, esc).flow;
    expect(flow.contacts.has(40)).toBe(false);
    expect(step(flow, esc).flow.target).toBeNull();
  });

  it("keeps a contact that measurements stand on", () => {
    const flow = run(open, { type: "click", frame: 40, point: at(1, 2) });
    const after = step(flow, { type: "escape", frame: 40, used: true }).flow;
    expect(after.contacts.has(40)).toBe(true);
    expect(after.target).toBeNull();
  });

  it("leads through what is asked for", () => {
    const asked: readonly Target[] = ["roof", "taillight"];
    expect(firstMissing(new Set(), asked)).toBe("roof");
    expect(firstMissing(new Set<Target>(["roof"]), asked)).toBe("taillight");
    expect(firstMissing(new Set<Target>(["roof", "taillight"]), asked)).toBeNull();
  });
});
