/** Words come with the room that says them, in the language that is spoken. */
import { expect, it, vi } from "vitest";
import { learn, learnLate, say, sayCode, speak } from "./messages";

const files = vi.hoisted(() => ({
  french: null as (() => void) | null,
  failing: true,
  server: vi.fn(async () => ({ default: { "not-enough": "Too few" } })),
}));

vi.mock("virtual:words/en/everywhere", () => ({ default: { "app-name": "Sightline" } }));
vi.mock("virtual:words", () => ({
  default: {
    en: {
      checks: async () => ({ default: { "action-save": "Save" } }),
      "checks-late": async () => ({ default: { "action-cancel": "Cancel" } }),
      server: files.server,
      review: async () => {
        if (files.failing) throw new TypeError("offline");
        return { default: { "action-print": "Print" } };
      },
    },
    fr: {
      everywhere: async () => ({ default: { "app-name": "Sightline" } }),
      checks: async () => {
        await new Promise<void>((done) => {
          files.french = done;
        });
        return { default: { "action-save": "Enregistrer" } };
      },
    },
  },
}));

it("says a room's words once they are here, in a language chosen meanwhile too", async () => {
  const french = speak("fr");
  await learn("checks");
  expect(say("action-save")).toBe("Save");
  await vi.waitFor(() => expect(files.french).not.toBeNull());
  files.french?.();
  await french;
  expect(say("action-save")).toBe("Enregistrer");
  await speak("en");
  expect(say("action-save")).toBe("Save");
});

it("says what waits for an action once that is asked for", async () => {
  expect(say("action-cancel")).toBe("action-cancel");
  await learnLate();
  expect(say("action-cancel")).toBe("Cancel");
});

it("leaves to the server's own words what it said in the language and the unit shown", () => {
  expect(sayCode({ code: "not-enough", values: {}, message: "Too few" })).toBeNull();
  expect(files.server).not.toHaveBeenCalled();
});

it("tries again after a failure", async () => {
  await expect(learn("review")).rejects.toThrow("offline");
  files.failing = false;
  await learn("review");
  expect(say("action-print")).toBe("Print");
});

it("fetches the server's words for a sentence that no page says", async () => {
  expect(sayCode({ code: "not-enough", values: {} })).toBeNull();
  await vi.waitFor(() => expect(sayCode({ code: "not-enough", values: {} })).toBe("Too few"));
});
