import { Button, choices, OptionalField, SelectField } from "../../components";
import { CommitField, LengthField } from "../../components/CommitField";
import { query, setQuery } from "../../core/address";
import { say } from "../../core/messages";
import type { Standard } from "../../core/types";
import { parseLength, parseNumber, speedScale } from "../../core/units";
import { ASKABLE, CATEGORY_WORDS, HEIGHT_WORDS, LIGHTING_WORDS, STATE_WORDS } from "../../core/words";
import { formatLimit, inWords, STANDARD_OF, standardKey } from "../../parts/figures/standards";
import { ClassChoice } from "../../parts/vehicles/ClassChoice";
import {
  KIND_WORDS,
  type Kind,
  type OfStandard,
  ofHeight,
  ofStandard,
  type Sight,
  STANDARDS_OBJECT,
  sharesOf,
  standardAt,
  usualObject,
} from "./model";

/** What the crests are computed from. Each change goes into the address, and from there to the server. */
export function SightForm({ standards, found }: { standards: readonly Standard[]; found: Sight | null }) {
  return (
    <form
      class="panel panel__body stack sight-form"
      aria-label={say("sight-form")}
      onSubmit={(event) => event.preventDefault()}
    >
      <fieldset>
        <legend>{say("sight-form-standard")}</legend>
        <StandardChoice
          name="eye_m"
          usual={1.08}
          label={say("sight-eye")}
          options={standards.filter((one) => one.what.startsWith("eye"))}
        />
        <StandardChoice
          name="object_m"
          usual={0.6}
          label={say("sight-object")}
          options={standards.filter((one) => one.what.startsWith("object"))}
        />
      </fieldset>
      <SurveyRule />
      <Road />
      {found && found.classes.length > 0 && <Fleet found={found} />}
    </form>
  );
}

interface StandardChoiceProps {
  name: OfStandard;
  usual: number;
  label: string;
  options: readonly Standard[];
}

function StandardChoice({ name, usual, label, options }: StandardChoiceProps) {
  const height = Number(query.value.get(name) ?? usual);
  const chosen = standardAt(query.value, name, height, options);
  return (
    <>
      <SelectField
        label={label}
        value={chosen ? standardKey(chosen) : ""}
        options={[
          ...options.map((one) => ({
            value: standardKey(one),
            label: say("sight-standard-option", {
              standard: inWords(one).name,
              what: STANDARD_OF[one.what],
              height: formatLimit(one.height_m),
            }),
          })),
          { value: "", label: say("sight-standard-any") },
        ]}
        onInput={(value) => {
          const one = options.find((option) => standardKey(option) === value);
          if (one) setQuery(ofStandard(name, one));
        }}
      />
      <Length
        name={name}
        label={say("sight-standard-height")}
        usual={usual}
        change={(metres) => setQuery(ofHeight(name, metres, options))}
      />
    </>
  );
}

/** How the survey's own heights are read: which percentile, of what. */
function SurveyRule() {
  const at = query.value;
  const kind = at.get("kind");
  return (
    <fieldset>
      <legend>{say("sight-form-survey")}</legend>
      <Percent name="eye_percent" label={say("sight-eye-percent")} usual="10" />
      <SelectField
        says="sight-object-target"
        value={at.get("object_target") ?? usualObject(kind)}
        options={[
          ...choices<string>(HEIGHT_WORDS, ASKABLE),
          { value: STANDARDS_OBJECT, label: say("sight-object-standard") },
        ]}
        onInput={(value) => setQuery({ object_target: value })}
      />
      <Percent name="object_percent" label={say("sight-object-percent")} usual="5" />
      <OptionalField
        says="statistics-filter-state"
        value={at.get("state")}
        none={STATE_WORDS.accepted}
        options={[{ value: "all", label: say("statistics-filter-state-all") }]}
        onInput={(state) => setQuery({ state })}
      />
      <OptionalField
        says="statistics-filter-lighting"
        value={at.get("lighting")}
        none={say("statistics-filter-any")}
        options={choices<string>(LIGHTING_WORDS)}
        onInput={(lighting) => setQuery({ lighting })}
      />
      <ClassChoice
        classSets={at.getAll("class_set")}
        categories={at.getAll("category")}
        onClassSets={(chosen) => setQuery({ class_set: chosen })}
        onCategories={(chosen) => setQuery({ category: chosen })}
      />
    </fieldset>
  );
}

function Road() {
  const at = query.value;
  const [perSecond, unit] = speedScale();
  const speed = Number(at.get("speed_mps") ?? 100 / 3.6);
  return (
    <fieldset>
      <legend>{say("sight-form-road")}</legend>
      <SelectField<Kind>
        says="sight-kind"
        value={(at.get("kind") ?? "stopping") as Kind}
        options={choices(KIND_WORDS)}
        onInput={(value) => setQuery({ kind: value === "stopping" ? null : value })}
      />
      <CommitField
        says="sight-speed"
        unit={unit}
        value={String(Number((speed * perSecond).toFixed(1)))}
        check={(text) => numberProblem(text, 0, 400)}
        onCommit={(text) => setQuery({ speed_mps: (parseNumber(text) ?? 0) / perSecond })}
      />
      <Percent name="difference_percent" label={say("sight-difference")} usual="6" below={100.001} />
      <Length name="headlight_m" label={say("sight-headlight")} usual={0.6} />
      <Length name="radius_m" label={say("sight-radius")} usual={500} most={100_000} />
    </fieldset>
  );
}

/** Another fleet: shares by class, those of the survey to begin with. */
function Fleet({ found }: { found: Sight }) {
  const shares = sharesOf(query.value);
  const begin = () =>
    setShares(new Map(found.classes.map((one) => [one.category, Number((100 * one.share).toFixed(1))])));
  if (shares.size === 0)
    return (
      <div class="row row--far">
        <Button says="sight-fleet-begin" icon="add" onClick={begin} />
        <span class="field__hint">{say("sight-fleet-hint")}</span>
      </div>
    );
  return (
    <fieldset>
      <legend>{say("sight-form-fleet")}</legend>
      {found.classes.map((one) => (
        <CommitField
          key={one.category}
          label={CATEGORY_WORDS[one.category]}
          unit="%"
          hint={say("sight-fleet-measured", { eyes: one.eyes, objects: one.objects })}
          value={String(shares.get(one.category) ?? 0)}
          check={(text) => numberProblem(text, -0.001, 100.001)}
          onCommit={(text) => setShares(new Map(shares).set(one.category, parseNumber(text) ?? 0))}
        />
      ))}
      <Button says="sight-fleet-end" small icon="close" onClick={() => setShares(new Map())} />
    </fieldset>
  );
}

function setShares(shares: ReadonlyMap<string, number>): void {
  setQuery({ share: [...shares].map(([name, percent]) => `${name}:${percent}`) });
}

interface LengthProps {
  name: "eye_m" | "object_m" | "headlight_m" | "radius_m";
  label: string;
  usual: number;
  most?: number;
  change?(metres: number | null): void;
}

function Length({ name, label, usual, most = 10, change }: LengthProps) {
  const stands = Number(query.value.get(name) ?? usual);
  return (
    <LengthField
      label={label}
      metres={stands}
      digits={3}
      check={(text) => {
        const metres = parseLength(text);
        return metres === null || metres < 0 || metres > most ? say("sight-number-problem") : null;
      }}
      onCommit={change ?? ((metres) => setQuery({ [name]: metres }))}
    />
  );
}

interface PercentProps {
  name: "eye_percent" | "object_percent" | "difference_percent";
  label: string;
  usual: string;
  below?: number;
}

function Percent({ name, label, usual, below = 100 }: PercentProps) {
  return (
    <CommitField
      label={label}
      unit="%"
      value={query.value.get(name) ?? usual}
      check={(text) => numberProblem(text, 0, below)}
      onCommit={(text) => setQuery({ [name]: parseNumber(text) })}
    />
  );
}

function numberProblem(text: string, above: number, below: number): string | null {
  const value = parseNumber(text);
  return value === null || value <= above || value >= below ? say("sight-number-problem") : null;
}
