import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { LineHeightQueue } from "../../core/types";
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

afterEach(() => render(null, document.body));

it("counts the heights of line scans that wait and leads to each one's bench", () => {
  const model = new ReviewModel(7);
  model.items.value = [];
  model.lineHeights.value = { to_review: 1, own: 1, items: [line(1, false), line(2, true)] };
  render(<Queue model={model} />, document.body);
  const rows = [...document.querySelectorAll<HTMLAnchorElement>("a.review__row")];
  expect(rows.map((one) => one.getAttribute("href"))).toEqual([
    "/surveys/7/scan?scan=4&vehicle=11",
    "/surveys/7/scan?scan=4&vehicle=12",
  ]);
  expect(rows[1]?.textContent).toContain("mine");
  const told = document.querySelector("[data-testid=review-lines]")?.textContent;
  expect(told).toContain("1 height of a line scan to review.");
  expect(told).toContain("1 of your own waits");
  model.close();
});
