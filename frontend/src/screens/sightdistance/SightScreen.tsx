/** From heights to roads: crests by a standard's heights, by the survey's and by another fleet's. */
import { useEffect } from "preact/hooks";
import { Facts, Loading, Notice, num, PageHead, Panel, Problem, Table } from "../../components";
import { PageTabs } from "../../components/PageTabs";
import { query } from "../../core/address";
import { api, fromAddress } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useResource } from "../../core/resource";
import { resultsTabs } from "../../core/tabs";
import { fixed, formatLength, formatSpeed, lengthScale, numbersIn, plainHeight } from "../../core/units";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { loadPlot } from "../../parts/figures/PlotFigure";
import { KFigure } from "./KFigure";
import { type Bounded, CASE_WORDS, type Case, type Sight, sightQuery, withoutCrest } from "./model";
import { SightForm } from "./SightForm";
import "./sightdistance.css";

export default function SightScreen(_props: ScreenProps) {
  const asked = fromAddress<"GET /sightdistance">(sightQuery(query.value));
  const speed_mps = Number(query.value.get("speed_mps") ?? 100 / 3.6);
  // the speed stays with the distance that is of it, while that of another is on its way
  const found = useResource(
    async (signal) => ({ speed_mps, ...(await api.ask("GET /sightdistance", asked, { signal })) }),
    [JSON.stringify(asked)],
    { keep: true },
  );
  const only = query.value.getAll("survey").length === 1 ? Number(query.value.get("survey")) : null;
  const standards = useAsked(only === null ? null : "GET /surveys/{survey_id}/standards", {
    survey_id: only ?? 0,
  });
  useEffect(() => {
    loadPlot().catch(() => null); // while the server computes; who draws tells what is wrong
  }, []);
  const data = found.data;
  return (
    <div class="page page--alone page--wide">
      <PageHead says="page-sight-distance" lead={say("sight-lead")} />
      <PageTabs label={say("page-statistics")} tabs={resultsTabs("sight-distance")} />
      {query.value.getAll("survey").map((id) => (
        <OutOfDateNotice key={id} surveyId={Number(id)} computed={found.reload} />
      ))}
      <SightForm standards={standards.data?.standards ?? []} found={data} />
      <Problem error={found.error ?? standards.error} again={found.reload} />
      {!data && found.loading && <Loading what={say("sight-loading")} />}
      {data && !found.error && (
        <div class="figures-body" aria-busy={found.loading}>
          <Sentences sight={data} />
          <Cases sight={data} />
          <KFigure sight={data} />
          <Besides sight={data} />
        </div>
      )}
    </div>
  );
}

function Sentences({ sight }: { sight: Sight }) {
  const standard = sight.cases.find((one) => one.name === "standard");
  const others = sight.cases.filter((one) => one.name !== "standard");
  return (
    <section
      class="panel stack stack--near sight-sentence"
      aria-label={say("sight-sentence")}
      data-testid="sight-sentence"
    >
      {others.map((one) => (
        <p key={one.name}>{caseWords(one, standard, sight)}</p>
      ))}
    </section>
  );
}

function caseWords(one: Case, standard: Case | undefined, sight: Sight): string {
  const { crest, comparison } = one;
  if (!crest || !comparison || !standard?.crest) return withoutCrest(one);
  return say(`sight-verdict-${comparison.verdict}`, {
    case: one.name === "mix" ? "mix" : "survey",
    eye: formatLength(crest.eye_m.value),
    object: formatLength(crest.object_m.value),
    constant: plain(crest.constant_m.value, 1),
    standard: plain(standard.crest.constant_m.value, 1),
    change: changeOf(comparison),
    k: plain(crest.k_m.value, 1),
    k_standard: plain(standard.crest.k_m.value, 1),
    distance: formatLength(sight.distance.design_m, 0),
    seen: formatLength(crest.seen_m.value, 0),
    reason: sentenceOf(crest.constant_m.reason) ?? "",
  });
}

/** Shorter and longer are said in words; elsewhere the sign tells them apart. */
function changeOf({ verdict, k_change }: NonNullable<Case["comparison"]>): string {
  const sign = verdict === "shorter" || verdict === "longer" ? "" : k_change < 0 ? "\u2212" : "+";
  return `${sign}${fixed(100 * Math.abs(k_change), 1)} %`;
}

const plain = (metres: number, digits: number) => fixed(metres * lengthScale()[0], digits);
const tenths = (metres: number) => plain(metres, 1);
const whole = (metres: number) => plain(metres, 0);

function Cases({ sight }: { sight: Sight & { speed_mps: number } }) {
  const unit = lengthScale()[1];
  return (
    <Panel
      says="sight-cases-title"
      note={say("sight-cases-distance", {
        speed: formatSpeed(sight.speed_mps, null, 0),
        distance: formatLength(sight.distance.distance_m, 1),
        design: formatLength(sight.distance.design_m, 0),
        formula: numbersIn(sight.distance.formula),
      })}
    >
      <Table
        label={say("sight-cases-title")}
        data-testid="sight-cases"
        heads={[
          say("sight-case"),
          num(say("sight-column-eye", { unit })),
          num(say("sight-column-object", { unit })),
          num(say("sight-column-constant", { unit })),
          num(say("sight-column-k", { unit })),
          num(say("sight-column-length", { unit })),
          num(say("sight-column-seen", { unit })),
        ]}
      >
        {sight.cases.map((one) => (
          <tr key={one.name}>
            <th scope="row">{CASE_WORDS[one.name]}</th>
            {one.crest ? (
              <>
                <Cell of={one.crest.eye_m} print={plainHeight} />
                <Cell of={one.crest.object_m} print={plainHeight} />
                <Cell of={one.crest.constant_m} print={tenths} />
                <Cell of={one.crest.k_m} print={tenths} strong />
                <Cell of={one.crest.length_m} print={whole} />
                <Cell of={one.crest.seen_m} print={whole} />
              </>
            ) : (
              <td colSpan={6}>{withoutCrest(one)}</td>
            )}
          </tr>
        ))}
      </Table>
      <p class="field__hint panel__note">
        {say("sight-cases-note", {
          eyes: sight.eyes,
          objects: sight.objects,
          whose: say("sight-read", { whose: sight.of_class }),
        })}{" "}
        {sight.distance.source}.
      </p>
    </Panel>
  );
}

/** A value over its 95 % interval, without the unit that the column's head names. */
function Cell({ of, print, strong }: { of: Bounded; print: (metres: number) => string; strong?: boolean }) {
  const value = print(of.value);
  return (
    <td class="num" title={sentenceOf(of.reason) ?? undefined}>
      {strong ? <strong>{value}</strong> : value}
      {of.low !== null && of.high !== null && (
        <div class="stat-ci">{say("sight-interval", { low: print(of.low), high: print(of.high) })}</div>
      )}
      {of.reason && <div class="stat-ci">{say("sight-no-interval")}</div>}
    </td>
  );
}

/** What heights of eyes do not change: a sag by headlights, and the room beside a curve. */
function Besides({ sight }: { sight: Sight }) {
  const unit = lengthScale()[1];
  return (
    <Panel says="sight-besides-title" class="sight-besides">
      <Facts
        of={[
          [
            say("sight-sag"),
            say("sight-sag-words", {
              k: plain(sight.sag_k_m, 1),
              unit,
              length: formatLength(sight.sag.length_m, 0),
              case: sight.sag.case === "S < L" ? "within" : sight.sag.case === "S > L" ? "beyond" : "none",
            }),
          ],
          [
            say("sight-curve"),
            sight.offset_m === null
              ? say("sight-curve-none")
              : say("sight-curve-words", { offset: formatLength(sight.offset_m, 2) }),
          ],
        ]}
      />
      <Notice>{say("sight-besides-note")}</Notice>
    </Panel>
  );
}
