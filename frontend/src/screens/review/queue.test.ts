import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
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

describe("what is not in the list", () => {
  const named = (id: number) => ({ ...item(1, 0), measurement: { ...item(1, 0).measurement, id } });
  const page = Array.from({ length: 200 }, (_, at) => named(100 + at));
  const ids = (queue: ReviewQueue) => queue.items.value?.map(({ measurement }) => measurement.id);
  let server: FakeServer;
  let queue: ReviewQueue;
  beforeEach(async () => {
    server = new FakeServer();
    server.on("GET", /review-(plan|work)/, () => ({}));
    server.on("GET", /review-queue/, () => page);
    server.on("GET", /review-queue.*after=299/, () => [named(300)]);
    server.on("GET", /review-queue.*measurement=4/, () => [named(4)]);
    queue = new ReviewQueue(7);
    await queue.load(null);
  });

  it("is brought once where the list has it by then", async () => {
    const under = queue.bring(4);
    queue.items.value = [named(3), named(4)];
    expect((await under)?.measurement.id).toBe(4);
    expect(ids(queue)).toEqual([3, 4]);
  });

  it("leaves a list that is on its way alone where there is no such measurement", async () => {
    server.on("GET", /review-queue.*measurement=4/, () => []);
    queue.items.value = null;
    expect(await queue.bring(4)).toBeUndefined();
    expect(queue.items.value).toBeNull();
  });

  it("stays before the list when more of it comes", async () => {
    const under = queue.loadMore();
    queue.items.value = [named(4), ...page];
    await under;
    expect(ids(queue)).toEqual([4, ...page.map(({ measurement }) => measurement.id), 300]);
  });

  it("does not get more of a list that another has replaced", async () => {
    const under = queue.loadMore();
    queue.items.value = [named(5)];
    await under;
    expect(ids(queue)).toEqual([5]);
  });
});
