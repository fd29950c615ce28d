import { Button, Checklist, type Choice, choices, DateField, named, OptionalField } from "../../components";
import { CommitField } from "../../components/CommitField";
import { query, setQuery } from "../../core/address";
import { say, wordsOf } from "../../core/messages";
import type { StatisticsBody } from "../../core/types";
import { kept, lengthUnit, parseSmall, smallScale, smallText } from "../../core/units";
import { ASKABLE, HEIGHT_WORDS, LIGHTING_WORDS, STATE_WORDS } from "../../core/words";
import { fixedRange } from "../../parts/figures/numbers";
import { FilmedFields, filmedOf } from "../../parts/filming/FilmedFields";
import { ClassChoice } from "../../parts/vehicles/ClassChoice";
import { CORRECTIONS, narrowed, type SingleName, setFilter, WIDE } from "./filters";

const CORRECTION_WORDS = wordsOf("statistics-correction-");

/** What stands behind "More": open where one of them is set. */
const MORE: readonly SingleName[] = [
  "target",
  "operator",
  "filmed_from",
  "filmed_to",
  "hour_from",
  "hour_to",
  "first_day",
  "last_day",
  "correction",
  "rounding",
  "u_reference_m",
];

/** What counts, and how figures are made. Each change goes into the address, and from there to the server. */
export function FilterBar({ found }: { found: StatisticsBody | null }) {
  const at = query.value;
  const choice = (name: SingleName, label: string, none: string, options: readonly Choice<string>[]) => (
    <OptionalField
      label={label}
      value={at.get(name)}
      none={none}
      options={options}
      onInput={(value) => setFilter({ [name]: value })}
    />
  );
  const any = say("statistics-filter-any");
  return (
    <form
      class="panel panel__body grid grid--4 stat-noprint"
      aria-label={say("statistics-filter")}
      onSubmit={(event) => event.preventDefault()}
    >
      <Surveys found={found} chosen={at.getAll("survey")} />
      {choice("state", say("statistics-filter-state"), STATE_WORDS.accepted, [
        ...choices<string>(STATE_WORDS, ["to_review", "rejected"]),
        { value: "all", label: say("statistics-filter-state-all") },
      ])}
      {choice("lighting", say("statistics-filter-lighting"), any, choices<string>(LIGHTING_WORDS))}
      <ClassChoice
        classSets={at.getAll("class_set")}
        categories={at.getAll("category")}
        onClassSets={(class_set) => setFilter({ class_set })}
        onCategories={(category) => setFilter({ category })}
      />
      <details class="more across" open={MORE.some((name) => at.get(name))}>
        <summary>{say("statistics-filter-more")}</summary>
        <div class="grid grid--5">
          {choice(
            "target",
            say("statistics-filter-target"),
            say("statistics-filter-target-all"),
            choices<string>(HEIGHT_WORDS, ASKABLE),
          )}
          {choice(
            "operator",
            say("statistics-filter-operator"),
            say("statistics-filter-anybody"),
            named(found?.operators ?? []),
          )}
          <FilmedFields value={filmedOf(at)} onChange={setQuery} />
          <Day name="first_day" label={say("statistics-filter-first-day")} />
          <Day name="last_day" label={say("statistics-filter-last-day")} />
          {choice(
            "correction",
            say("statistics-filter-correction"),
            CORRECTION_WORDS.inset,
            choices<string>(CORRECTION_WORDS, CORRECTIONS.slice(1)),
          )}
          {choice("rounding", say("statistics-filter-rounding"), say("statistics-rounding-none"), [
            { value: "cm", label: say("statistics-rounding-cm") },
          ])}
          <ReferenceU value={at.get("u_reference_m")} />
        </div>
      </details>
      {narrowed(at) && (
        <div class="stat-filter__clear">
          <Button says="action-clear-filter" small onClick={() => setFilter(WIDE)} />
        </div>
      )}
    </form>
  );
}

function Surveys({ found, chosen }: { found: StatisticsBody | null; chosen: readonly string[] }) {
  const list = found?.surveys ?? [];
  const only = chosen.length === 1 ? list.find((one) => String(one.id) === chosen[0]) : undefined;
  const word =
    chosen.length === 0
      ? say("statistics-filter-surveys-none")
      : (only?.name ?? say("statistics-filter-surveys-some", { count: chosen.length }));
  return (
    <Checklist
      label={say("statistics-filter-surveys")}
      words={word}
      help={say("statistics-filter-surveys-help")}
      groups={[{ options: named(list), chosen, onChange: (survey) => setFilter({ survey }) }]}
    />
  );
}

function Day({ name, label }: { name: "first_day" | "last_day"; label: string }) {
  return (
    <DateField
      label={label}
      value={query.value.get(name) ?? ""}
      onChange={(day) => setFilter({ [name]: day })}
    />
  );
}

const USUAL_U_M = 0.0173;

/** The standard uncertainty of reference heights that have none of their own, as a small length. */
function ReferenceU({ value }: { value: string | null }) {
  const now = value === null ? USUAL_U_M : Number(value);
  const [, unit] = smallScale();
  const usual = smallText(USUAL_U_M, lengthUnit.value, 2);
  const read = (text: string) => kept(text, usual, USUAL_U_M, parseSmall);
  return (
    <CommitField
      says="statistics-reference-u"
      hint={say("statistics-reference-u-hint", { limit: fixedRange(Math.sqrt(3) * now) })}
      unit={unit}
      value={smallText(now, lengthUnit.value, 2)}
      usual={usual}
      check={(text) =>
        (read(text) ?? -1) < 0
          ? say(unit === "in" ? "statistics-reference-u-inches" : "statistics-reference-u-millimetres")
          : null
      }
      onCommit={(text) => {
        const metres = Number((read(text) ?? USUAL_U_M).toFixed(6));
        setFilter({ u_reference_m: metres === USUAL_U_M ? null : String(metres) });
      }}
    />
  );
}
