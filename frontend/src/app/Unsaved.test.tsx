import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it } from "vitest";
import { outbox, type Wish } from "../core/outbox";
import { saveState } from "../core/save";
import { SaveWord } from "./TopBar";
import { Unsaved } from "./Unsaved";

const REFUSED: Wish = {
  key: "m1",
  kind: "measurement",
  lane: "vehicle.7",
  about: {},
  what: "roof < eye",
  mine: "1.460 m",
  page: "/surveys/5/measure?vehicle=7",
  saved: null,
  want: {},
  state: "failed",
  problem: "The recording has no road pose; find it first.",
  theirs: null,
};

function show(wish: Wish): string {
  outbox.wishes.value = new Map([[wish.key, wish]]);
  act(() => render(<Unsaved />, document.body));
  return document.querySelector("[data-testid=unsaved] .grow")?.textContent ?? "";
}

afterEach(() => {
  render(null, document.body);
  outbox.wishes.value = new Map();
});

it("the bar does not say saved while something refused rests", () => {
  saveState.value = { pending: 0, waiting: 0, savedAt: new Date(), failed: false };
  show(REFUSED);
  act(() => render(<SaveWord />, document.body));
  expect(document.querySelector("[data-testid=save-state]")?.textContent).toBe("1 not yet saved");
  saveState.value = { ...saveState.value, savedAt: null };
});

describe("what was refused", () => {
  it("is told in one sentence, with a link to where it was done", () => {
    expect(show(REFUSED)).toBe(
      "roof < eye: The recording has no road pose; find it first. Yours: 1.460\u00a0m.",
    );
    const link = document.querySelector("[data-testid=unsaved] a");
    expect(link?.getAttribute("href")).toBe(REFUSED.page);
    expect(link?.textContent).toBe("roof < eye");
  });

  it("names both values where somebody else changed it", () => {
    outbox.register("measurement", { words: () => "1.480 m" } as never);
    const told = show({ ...REFUSED, state: "conflict", problem: "Olga changed it at 10:04." });
    expect(told).toBe("roof < eye: Olga changed it at 10:04. Yours: 1.460\u00a0m. Theirs: 1.480\u00a0m.");
  });
});
