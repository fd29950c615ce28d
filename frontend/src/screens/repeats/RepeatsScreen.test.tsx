import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import RepeatsScreen from "./RepeatsScreen";

let server: FakeServer;
beforeEach(() => {
  server = new FakeServer();
  server.on("GET", /\/anchoring$/, () => {
    throw 404;
  });
});
afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

async function shown(people: number, oneIn: number): Promise<string> {
  const who = Array.from({ length: people }, (_, i) => ({ person: { id: i + 1, name: `P${i}` } }));
  server.on("GET", /\/repeats$/, () => ({ repeats: 0, people: who, targets: [], differences: [] }));
  server.on("GET", /\/review-plan$/, () => ({ blind_one_in: oneIn, version: 1 }));
  render(<RepeatsScreen surveyId={5} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain("No repeat measurements yet"));
  return document.body.textContent ?? "";
}

it("asks to turn on blind checks only where they are off", async () => {
  expect(await shown(2, 0)).toContain("turn on blind checks");
  render(null, document.body);
  const on = await shown(2, 5);
  expect(on).not.toContain("turn on blind checks");
  expect(on).toContain("1 measurement in 5 is repeated");
});

it("promises nothing between operators where there is one alone", async () => {
  expect(await shown(1, 5)).toContain("once a second one repeats them");
  render(null, document.body);
  expect(await shown(2, 5)).not.toContain("once a second one repeats them");
});
