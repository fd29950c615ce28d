import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { LineHeightQueue, ReviewItem, Verdict } from "../../core/types";
import { ReviewModel } from "./model";
import { Queue } from "./Queue";

const line = (id: number, mine: boolean): LineHeightQueue["items"][number] => ({
  id,
  scan_id: 4,
  scan_name: "East",
  vehicle_id: 10 + id,
  number: id,
  target: "roof",
  height_m: 1.45,
  U95_height_m: 0.03,
  mine,
});

const judged = (id: number, verdict: Verdict): ReviewItem =>
  ({
    measurement: { id, target: "roof", status: "ok", height_m: 1.5, U95_height_m: 0.02, review: { verdict } },
    mine: false,
    vehicle: { number: id },
    judged: { blind: false, signs: [], lot: { number: 2 } },
  }) as unknown as ReviewItem;

afterEach(() => render(null, document.body));

it("counts the heights of line scans that wait and leads to each one's bench", () => {
  const model = new ReviewModel(7);
  model.queue.items.value = [];
  model.queue.lineHeights.value = { to_review: 1, own: 1, items: [line(1, false), line(2, true)] };
  render(<Queue model={model} />, document.body);
  const rows = [...document.querySelectorAll<HTMLAnchorElement>("a.review__row")];
  expect(rows.map((one) => one.getAttribute("href"))).toEqual([
    "/surveys/7/scan?scan=4&vehicle=11",
    "/surveys/7/scan?scan=4&vehicle=12",
  ]);
  expect(rows[1]?.textContent).toContain("mine");
  const told = document.querySelector("[data-testid=review-lines]")?.textContent;
  expect(told).toContain("1 height of a line scan to review.");
  expect(told).toContain("1 of your own measurements waits");
  model.close();
});

it("leads back to the lot, and to its decision once its sample is reviewed", () => {
  history.replaceState(null, "", "/surveys/7/review?lot=3");
  const model = new ReviewModel(7);
  model.queue.items.value = [judged(1, "accepted"), judged(2, "to_review")];
  render(<Queue model={model} />, document.body);
  const decide = () => document.querySelector("[data-testid=review-lot-judged]");
  expect(decide()).toBeNull();
  const address = "/surveys/7/lots?lot=3";
  expect(document.querySelector("[data-testid=review-lot] a")?.getAttribute("href")).toBe(address);
  model.queue.items.value = [judged(1, "accepted"), judged(2, "rejected")];
  render(<Queue model={model} />, document.body);
  expect(decide()?.textContent).toContain("sample of this lot is reviewed");
  const next = [...document.querySelectorAll("a")].find((one) => one.textContent === "Decide on the lot");
  expect(next?.getAttribute("href")).toBe(address);
  model.close();
  history.replaceState(null, "", "/");
});
