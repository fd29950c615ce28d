/** A reviewer reads how the points were set, and by whom. */
import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer, recording } from "../../../testing/server";
import { formatMoment } from "../../core/times";
import type { Made, ReviewItem } from "../../core/types";
import { ReviewModel } from "./model";
import { VerdictPanel } from "./VerdictPanel";

const box = document.createElement("div");
let server: FakeServer;

beforeEach(() => {
  server = new FakeServer("reviewer");
  server.on("GET", /\/review-plan$/, () => ({ blind_one_in: 0, version: 0 }));
  server.on("GET", /\/history$/, () => ({ revisions: [], reviews: [] }));
  server.on("GET", /\/recordings$/, () => [recording()]);
  document.body.append(box);
});

afterEach(() => {
  render(null, box);
  box.remove();
  vi.unstubAllGlobals();
});

it.each([
  ["confirmed", "suggested, confirmed by Marie, "],
  ["moved", "suggested, moved by Marie, "],
  ["snapped", "contact snapped to the tyre, target clicked by Marie, "],
  ["clicked", "clicked by Marie, "],
] as [Made, string][])("points that were %s", async (made, words) => {
  const measurement = server.save(1, {
    target: "roof",
    frame: 40,
    contact: [100, 400],
    target_point: [101, 250],
    revision: 1,
    withdrawn: false,
    made,
    created_by: { id: 3, name: "René" }, // restored it
    created_at: "2026-11-26T10:00:00Z", // when it was restored
  });
  const operator = { id: 2, name: "Marie" };
  const clicked_at = "2026-11-24T10:00:00Z";
  const judged = { blind: false, signs: [], error_m: null, U95_error_m: null, operator, clicked_at };
  const item = { measurement, mine: false, vehicle: { number: 3 }, judged } as unknown as ReviewItem;
  server.on("GET", /\/review-queue/, () => [item]);
  const model = new ReviewModel(5);
  await model.load();
  render(<VerdictPanel model={model} item={item} />, box);
  const said = box.querySelector('[data-testid="review-made"]')?.textContent;
  expect(said).toBe(words + formatMoment(clicked_at));
});
