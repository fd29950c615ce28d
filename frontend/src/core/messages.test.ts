import { afterEach, expect, test, vi } from "vitest";
import { language, preferredLanguage, say, sayCode, sentence, sentenceOf, speak } from "./messages";
import { budgetSource } from "./words";

afterEach(() => speak("en"));

test("a sentence is the catalogue's", () => {
  expect(say("page-repeats")).toBe("Repeatability");
});

test("a sentence counts as its language does, thousands set apart from 10,000 on", async () => {
  const counted = (count: number) => say("scans-count-vehicles", { count });
  expect([0, 1, 9999].map(counted)).toEqual(["0\u00a0vehicles", "1\u00a0vehicle", "9999\u00a0vehicles"]);
  expect(counted(1234567)).toContain("1\u202f234\u202f567");
  expect(say("measure-progress", { count: 1, all: 12345 })).toBe("1 of 12\u202f345");
  await speak("fr");
  expect(counted(12345)).toContain("12\u202f345");
  expect(counted(9999)).toContain("9999");
});

test("of the server's numbers those stand apart that are counts, as the server writes them", async () => {
  for (const language of ["en", "fr"]) {
    await speak(language);
    const all = { code: "overview-scans-accepted", values: { count: 12345, all: 54321 } };
    await vi.waitFor(() => expect(sayCode(all)).toMatch(/12\u202f345 .*54\u202f321/));
    await vi.waitFor(() =>
      expect(sayCode({ code: "video-frame-changed", values: { n: 12345 } })).toContain("12345"),
    );
    expect(sayCode({ code: "stream-clock-set", values: { jump_s: 12345.5, lines: 10000 } })).toMatch(
      /12\u202f345[.,]5.* 10000/,
    );
  }
});

test("a number stays in the line of its unit, and of what it is the uncertainty", async () => {
  const said = { value: "1.2 m", u: "0.1 m" };
  expect(say("with-u", said)).toBe("1.2\u00a0m (u\u00a0=\u00a00.1\u00a0m)");
  expect(say("percent", { percent: "5" })).toBe("5\u00a0%");
  expect(say("with-unit", { name: "after 5 s.", unit: "m/s²" })).toBe("after 5\u00a0s. (m/s²)");
  // no unit, though it begins as one
  expect(say("with-unit", { name: "12 sites", unit: "m" })).toBe("12 sites (m)");
});

test("a key that no file has is shown as it is", () => {
  expect(sentence("no-such-key")).toBe("no-such-key");
});

test("a value that is missing is told to the developer and marked in the sentence", () => {
  const told = vi.spyOn(console, "error").mockImplementation(() => undefined);
  expect(sentence("again-back-to-frame", {})).toContain("{$frame}");
  expect(told).toHaveBeenCalled();
});

test("the first of the browser's languages that there is, else English", () => {
  expect(preferredLanguage(["xx", "en-GB"])).toBe("en");
  expect(preferredLanguage(["xx"])).toBe("en");
});

test("a language without a file leaves English", async () => {
  await speak("xx");
  expect(language.value).toBe("en");
});

test("a sentence of the server: numbers are not grouped, one that is not known is left to its English", () => {
  expect(sayCode({ code: "said", values: { sentence: 123456 } })).toBe("123456");
  expect(sayCode({ code: "no-such-key", values: {} })).toBeNull();
});

test("a reason within a reason, and the server's own words where this program has none", async () => {
  const message = "Frame 2 of 3: The horizon.";
  const horizon = { code: "height-contact-above-horizon", values: {}, message: "The horizon." };
  const within = { code: "height-of-frame", values: { frame: 2, frames: 3, reason: horizon }, message };
  expect(sentenceOf({ ...within, code: "no-such-key" })).toBe(message);
  await vi.waitFor(() =>
    expect(sentenceOf(within)).toBe(
      "Frame 2 of 3: The contact point lies at or above the horizon, where there is no road.",
    ),
  );
});

test("a source of uncertainty is said in words, as it is stored only where it has none", async () => {
  expect(["click, target", "board bow", "width 0.6"].map(budgetSource)).toEqual([
    "Click on the target",
    "Board flatness",
    "width 0.6",
  ]);
  await speak("fr");
  expect(["click, target", "board bow"].map(budgetSource)).toEqual([
    "Pointé de la cible",
    "Planéité de la mire",
  ]);
});
