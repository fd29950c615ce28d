import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { learn } from "../../core/messages";
import CatalogueScreen from "./CatalogueScreen";

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("says the years of a model as its suggestions do: one year once", async () => {
  await learn("catalogue");
  const size = { length_m: null, width_m: null, height_m: null, wheelbase_m: null };
  const model = (id: number, year_from: number | null, year_to: number | null) => ({
    ...{ id, make: "Karo", model: "Mira", category: null, source: "", retired_at: null, version: 1 },
    ...{ ...size, year_from, year_to },
  });
  const entries = [model(1, 2019, 2019), model(2, 2016, 2020), model(3, 2016, null), model(4, null, null)];
  new FakeServer().on("GET", /^\/catalogue\/page/, () => ({ entries, total: 4 }));
  render(<CatalogueScreen />, document.body);
  await vi.waitFor(() => expect(document.querySelectorAll("tbody tr")).toHaveLength(4));
  const years = [...document.querySelectorAll("tbody tr")].map((row) => row.children[1]?.textContent);
  expect(years).toEqual(["2019", "2016–2020", "2016–", ""]);
});
