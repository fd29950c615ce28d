/** What is said belongs to what is asked: a number of vehicles to what is typed, a conclusion to its survey. */
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { ByLot, Conclusion, SamplePlan } from "./StatisticsScreen";

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

it("plans with the spread of the survey that is shown now", async () => {
  new FakeServer();
  const spread = () => [...document.querySelectorAll("input")].at(-1)?.value;
  render(<SamplePlan sdM={0.08} />, document.body);
  await vi.waitFor(() => expect(spread()).toBe("0.08"));
  render(<SamplePlan sdM={0.11} />, document.body);
  await vi.waitFor(() => expect(spread()).toBe("0.11"));
});

it("says why there is no conclusion in the place of an earlier one", async () => {
  const server = new FakeServer();
  server.on("GET", /conclusion/, () => ({ sentences: ["3 heights.", "Eyes are at 1.1 m."] }));
  render(<Conclusion surveyId={1} of={1} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain("Eyes are at 1.1 m."));
  server.on("GET", /conclusion/, () => {
    throw 400;
  });
  render(<Conclusion surveyId={1} of={2} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain("(status 400)"));
  expect(document.body.textContent).not.toContain("Eyes are at 1.1 m.");
});

it("says that it is not known how many heights were accepted by lot", async () => {
  new FakeServer().on("GET", /\/lots\/summary$/, () => {
    throw 400;
  });
  render(<ByLot surveyId={1} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain("(status 400)"));
});
