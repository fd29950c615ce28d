/** A reviewer reads how the points were set, and by whom. */
import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Made, ReviewItem } from "../../core/types";
import { FakeServer, recording } from "../../testing/server";
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

const MARIE = { id: 2, name: "Marie" };
const RENE = { id: 3, name: "René" };
const AT = ", 26 Nov 2026,"; // the hour follows the browser's zone

it.each([
  ["confirmed", MARIE, "suggested, confirmed by Marie", AT],
  ["moved", MARIE, "suggested, moved by Marie", AT],
  ["snapped", MARIE, "contact snapped to the tyre, target clicked by Marie", AT],
  ["clicked", MARIE, "clicked by Marie", AT],
  ["clicked", RENE, "clicked by Marie", ""], // he restored it, at another time
] as [Made, typeof MARIE, string, string][])(
  "points that were %s, stored by %o",
  async (made, by, words, at) => {
    const measurement = server.save(1, {
      target: "roof",
      frame: 40,
      contact: [100, 400],
      target_point: [101, 250],
      revision: 1,
      withdrawn: false,
      made,
      created_by: by,
      created_at: "2026-11-26T10:00:00Z",
    });
    const judged = { blind: false, signs: [], error_m: null, U95_error_m: null, operator: MARIE };
    const item = { measurement, mine: false, vehicle: { number: 3 }, judged } as unknown as ReviewItem;
    server.on("GET", /\/review-queue/, () => [item]);
    const model = new ReviewModel(5);
    await model.load();
    render(<VerdictPanel model={model} item={item} />, box);
    const said = box.querySelector('[data-testid="review-made"]')?.textContent;
    expect(at ? said?.startsWith(words + at) : said === words).toBe(true);
  },
);
