/** What is said belongs to what is asked: a number of vehicles to what is typed, a conclusion to its survey. */
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import type { Lateral } from "./model";
import { ByLot, Conclusion, LanesTable, SamplePlan } from "./StatisticsScreen";

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

it("keeps a lane's rows when another lane comes before it", () => {
  const spread = (word: string) => ({ word, n: 3, mean_m: 4, sd_m: 0.1, percentiles: [] });
  const show = (...lanes: string[]) => {
    const classes = Object.fromEntries(lanes.map((lane) => [lane, { groups: [spread("van")] }]));
    const lateral = { all: spread("all"), lanes: { groups: lanes.map(spread) }, classes };
    render(<LanesTable lateral={lateral as unknown as Lateral} />, document.body);
    return [...document.querySelectorAll("tbody tr")];
  };
  const [, far, ofFar] = show("far");
  const rows = show("near", "far");
  expect(rows.indexOf(far as Element)).toBe(3);
  expect(rows.indexOf(ofFar as Element)).toBe(4);
});
