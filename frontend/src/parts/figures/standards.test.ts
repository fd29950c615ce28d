import { afterEach, describe, expect, it } from "vitest";
import { speak } from "../../core/messages";
import { insetNote } from "../../core/words";
import { inWords } from "./standards";

afterEach(() => speak("en"));

describe("the words of the program's standards and insets", () => {
  const LOW = { name: "United Kingdom, low", vehicle_class: "", code: "uk_object_low" };

  it("are said in the reader's language", async () => {
    expect(inWords(LOW)).toEqual(LOW);
    await speak("fr");
    expect(inWords(LOW)).toEqual({ ...LOW, name: "Royaume-Uni, bas" });
    expect(insetNote({ code: "headlight", note: "outer edge of the lamp (estimate)" })).toBe(
      "bord extérieur du feu (estimation)",
    );
  });

  it("stay as a person wrote them", async () => {
    await speak("fr");
    expect(inWords({ ...LOW, code: null }).name).toBe("United Kingdom, low");
    expect(inWords({ ...LOW, code: "of_a_later_program" }).name).toBe("United Kingdom, low");
    expect(insetNote({ code: null, note: "not known" })).toBe("not known");
  });
});
