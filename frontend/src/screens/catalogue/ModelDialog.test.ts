import { afterEach, expect, it } from "vitest";
import type { CatalogueRow } from "../../core/types";
import { lengthUnit } from "../../core/units";
import { read, typedOf } from "./ModelDialog";

afterEach(() => {
  lengthUnit.value = "m";
});

it("sizes that nobody typed are saved as they are stored, in metres and in feet", () => {
  const row = { height_m: 1.45, u_height_m: 0.005, wheelbase_m: 2.58826 } as unknown as CatalogueRow;
  for (const unit of ["m", "ft"] as const) {
    lengthUnit.value = unit;
    const typed = typedOf(row);
    expect(read(typed, row)).toMatchObject(row);
    const other = { ...typed, height: { ...typed.height, size: "1.5" } };
    expect(read(other, row)).toMatchObject({ ...row, height_m: unit === "m" ? 1.5 : 1.5 * 0.3048 });
  }
});
