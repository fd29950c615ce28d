import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import { vehicle } from "../../../testing/server";
import { speak } from "../../core/messages";
import type { ModelFits } from "../../core/types";
import { CannotFit } from "./WhichModel";

afterEach(async () => {
  render(null, document.body);
  await speak("en");
});

it.each([
  [0.002, "0,002"],
  [0.00002, "< 0,0001"],
])("tells probabilities as the language writes numbers: %f", async (p, told) => {
  await speak("fr");
  const entry = { make: "Fiat", model: "Panda" };
  const fits = { chosen: { cannot: true, p, entry, differences: [] }, limit_p: 0.01 };
  const one = vehicle([], { make: "Fiat", model: "Panda" });
  render(<CannotFit fits={fits as unknown as ModelFits} vehicle={one} />, document.body);
  expect(document.body.textContent).toContain(told);
  expect(document.body.textContent).toContain("0,01");
});
