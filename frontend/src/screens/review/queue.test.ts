import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import type { ReviewItem } from "../../core/types";
import { ReviewQueue } from "./queue";

afterEach(() => vi.unstubAllGlobals());

const item = (revision: number, error_m: number): ReviewItem =>
  ({
    measurement: { id: 4, revision, target: "roof", height_m: 1.5 + error_m },
    mine: revision > 1,
    vehicle: { number: 3 },
    judged: { blind: false, signs: [{ code: "far" }], error_m, U95_error_m: 0.02 },
  }) as unknown as ReviewItem;

it("does not tell the error of the revision before a fix beside the height after it", async () => {
  const server = new FakeServer();
  const queue = new ReviewQueue(7);
  queue.items.value = [item(1, 0.12)];
  queue.replace({ ...item(1, 0.12).measurement });
  expect(queue.find(4)?.judged.error_m).toBe(0.12);
  server.on("GET", /review-queue/, () => [item(2, 0.01)]);
  queue.replace(item(2, 0.01).measurement);
  expect(queue.find(4)?.judged).toMatchObject({ signs: [], error_m: null, U95_error_m: null });
  await vi.waitFor(() => expect(queue.find(4)?.judged.error_m).toBe(0.01));
  expect(queue.find(4)?.mine).toBe(true);
});
