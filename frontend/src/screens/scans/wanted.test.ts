import { afterEach, expect, it } from "vitest";
import { lengthUnit } from "../../core/units";
import { scannedWords } from "./wanted";

afterEach(() => {
  lengthUnit.value = "m";
});

it("tells sizes with what they are and their unit, in feet to those who read feet", () => {
  const facts = { make: "Fiat", true_length_m: 3.6534, true_wheelbase_m: null };
  const told = () => scannedWords({ facts }).replace(/\s/g, " ");
  expect(told()).toBe("Fiat, Reference length: 3.653 m");
  lengthUnit.value = "ft";
  expect(told()).toBe("Fiat, Reference length: 11.986 ft");
});
