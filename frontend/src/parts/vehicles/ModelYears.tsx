/** Says where the catalogue knows a model, but not of the year that is given: nothing is refused. */
import { api } from "../../core/api";
import { anyOf, say } from "../../core/messages";
import { useResource } from "../../core/resource";
import type { CatalogueRow } from "../../core/types";

interface Props {
  make: string | null;
  model: string | null;
  year: number | null;
}

export function ModelYears({ make, model, year }: Props) {
  const rows = useResource<CatalogueRow[]>(
    async (signal) =>
      make && model && year !== null ? api.ask("GET /catalogue", { q: `${make} ${model}` }, { signal }) : [],
    [make, model, year],
  ).data;
  const words = year === null || !rows ? null : yearsElsewhere(rows, make ?? "", model ?? "", year);
  return (
    <p class="field__hint" role="status" data-testid="model-years">
      {words && say("catalogue-other-years", { model: `${make} ${model}`, years: words })}
    </p>
  );
}

/** The years of a model in the catalogue, where none of them holds this one; null where one does, or none is known. */
export function yearsElsewhere(
  rows: readonly CatalogueRow[],
  make: string,
  model: string,
  year: number,
): string | null {
  const same = rows.filter((row) => isSame(row.make, make) && isSame(row.model, model));
  const fits = ({ year_from, year_to }: CatalogueRow) =>
    (year_from === null || year >= year_from) && (year_to === null || year <= year_to);
  return same.length === 0 || same.some(fits) ? null : anyOf(same.map(yearsOf));
}

/** "2016–2020", "2016–" while it is built; empty where nothing is known. */
export function yearsOf({ year_from, year_to }: CatalogueRow): string {
  if (year_from === null && year_to === null) return "";
  if (year_from === year_to) return String(year_from);
  return `${year_from ?? ""}–${year_to ?? ""}`;
}

function isSame(one: string, other: string): boolean {
  return one.trim().localeCompare(other.trim(), undefined, { sensitivity: "base" }) === 0;
}
