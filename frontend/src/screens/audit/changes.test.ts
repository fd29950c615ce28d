import { expect, it, vi } from "vitest";
import { changesOf } from "./changes";

it("lists what differs, and nothing else", () => {
  const before = { name: "A", lighting: null, points: [1, 2], same: 3 };
  const after = { name: "B", lighting: "daytime", points: [1, 3], same: 3 };
  expect(changesOf(before, after)).toEqual([
    { name: "name", before: "A", after: "B" },
    { name: "lighting", before: null, after: "daytime" },
    { name: "points", before: "[1,2]", after: "[1,3]" },
  ]);
});

it("reads a new record as everything added, a removed one as everything gone", () => {
  expect(changesOf(null, { name: "A" })).toEqual([{ name: "name", before: null, after: "A" }]);
  expect(changesOf({ name: "A" }, null)).toEqual([{ name: "name", before: "A", after: null }]);
  expect(changesOf(null, null)).toEqual([]);
});

it("says reasons and flags that events hold by their codes", async () => {
  const horizon = { code: "height-contact-above-horizon", values: {} };
  const flags = [horizon, { code: "height-flag-u-large", values: {} }];
  await vi.waitFor(() =>
    expect(changesOf(null, { reason: horizon })[0]?.after).toMatch(/^The contact point lies at/),
  );
  expect(changesOf(null, { flags })[0]?.after).toMatch(
    /there is no road\. The 95\u00a0% interval is approximate/,
  );
  expect(changesOf(null, { flags: [] })[0]?.after).toBe("[]");
});
