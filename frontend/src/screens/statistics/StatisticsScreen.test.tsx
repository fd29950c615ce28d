/** The number of vehicles that is said belongs to what is typed. */
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../testing/server";
import { SamplePlan } from "./StatisticsScreen";

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("says no number of vehicles until the one of what is typed now has come", async () => {
  const server = new FakeServer();
  let answer = (_: object) => {};
  const words = (vehicles: number) => ({
    words: { code: "x", values: {}, message: `${vehicles} vehicles.` },
  });
  server.on("GET", /^\/statistics\/sample-size\?percent=10&/, () => words(155));
  server.on("GET", /^\/statistics\/sample-size\?percent=15&/, () => new Promise((come) => (answer = come)));
  render(<SamplePlan sdM={0.08} />, document.body);
  const told = () => document.querySelector("[data-testid=sample-size]")?.textContent;
  await vi.waitFor(() => expect(told()).toBe("155 vehicles."));
  const box = document.querySelector("input") as HTMLInputElement;
  box.value = "15";
  box.dispatchEvent(new Event("input", { bubbles: true }));
  await vi.waitFor(() => expect(told()).toBe(""));
  answer(words(120));
  await vi.waitFor(() => expect(told()).toBe("120 vehicles."));
});
