import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { ReviewItem, Verdict } from "../../core/types";
import { ReviewModel } from "./model";
import { Queue } from "./Queue";

const judged = (id: number, verdict: Verdict): ReviewItem =>
  ({
    measurement: { id, target: "roof", status: "ok", height_m: 1.5, U95_height_m: 0.02, review: { verdict } },
    mine: false,
    vehicle: { number: id, scan_name: null },
    judged: { blind: false, signs: [], lot: { number: 2 } },
  }) as unknown as ReviewItem;

afterEach(() => render(null, document.body));

it("has heights of line scans among the others, and says of which", () => {
  const model = new ReviewModel(7);
  const filmed = judged(1, "to_review");
  const scanned = judged(2, "to_review");
  model.queue.items.value = [filmed, { ...scanned, vehicle: { ...scanned.vehicle, scan_name: "East" } }];
  render(<Queue model={model} />, document.body);
  const badges = [...document.querySelectorAll(".review__row")].map((row) =>
    [...row.querySelectorAll<HTMLElement>(".badge")].map((one) => one.title || one.textContent),
  );
  expect(badges.map((one) => one.includes("East"))).toEqual([false, true]);
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
