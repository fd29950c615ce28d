/** Reference values from a CSV: what each line would do, before anything is stored. */
import { DataTable, Notices } from "../../components";
import { CommitField } from "../../components/CommitField";
import { api } from "../../core/api";
import { apart, say, sentencesOf, wordsOf } from "../../core/messages";
import type { ReferencePlan, ReferenceRow } from "../../core/types";
import { fixed, formatCount, parseNumber } from "../../core/units";
import { ImportCsv } from "../../parts/ImportCsv";
import type { ScanModel } from "./model";
import { apartWords, QUANTITY_WORDS, referenceValue } from "./referenceWords";

const CHANGES = wordsOf("scan-references-", "new", "replaces", "same", "ambiguous", "refused");

const WORDS = wordsOf("scan-references-", "title", "choose", "drop", "hint", "looking");

export function ReferenceImport({ model, onClose }: { model: ScanModel; onClose: () => void }) {
  const scan = { scan_id: model.id };
  return (
    <ImportCsv
      words={WORDS}
      usual={{ tolerance_s: 1 }}
      keep
      look={(body, taken) =>
        api.ask("POST /scans/{scan_id}/references/preview", { ...scan, ...taken }, { body })
      }
      store={async (body, taken) => {
        const asked = { ...scan, ...taken };
        const done = await api.write("POST /scans/{scan_id}/references/import", asked, { body });
        await model.refresh();
        return done;
      }}
      usable={({ counts }) => (counts["new"] ?? 0) + (counts["replaces"] ?? 0)}
      storeWords={(count) => say("scan-references-store", { count })}
      doneWords={({ values, cars }) => say("scan-references-done", { values, cars })}
      preview={(plan, { tolerance_s }, change) => (
        <>
          {plan.tolerance_s !== null && (
            <CommitField
              says="scan-references-tolerance"
              value={String(tolerance_s)}
              unit="s"
              hint={say("scan-references-tolerance-hint")}
              check={(text) => (toleranceOf(text) === null ? say("scan-references-tolerance-problem") : null)}
              onCommit={(text) => change({ tolerance_s: toleranceOf(text) ?? tolerance_s })}
            />
          )}
          <Preview plan={plan} />
        </>
      )}
      onClose={onClose}
    />
  );
}

const MOST_TOLERANCE_S = 60;

/** Seconds above 0 and up to a minute; null for anything else. */
function toleranceOf(text: string): number | null {
  const found = parseNumber(text);
  return found !== null && found > 0 && found <= MOST_TOLERANCE_S ? found : null;
}

function Preview({ plan }: { plan: ReferencePlan }) {
  const timed = plan.tolerance_s !== null;
  return (
    <>
      <Notices of={plan.notes} />
      <p class="row row--wrap" data-testid="reference-counts">
        {Object.entries(CHANGES).map(([name, word]) => (
          <span key={name}>
            <strong>{formatCount(plan.counts[name as keyof typeof CHANGES] ?? 0)}</strong> {word}
          </span>
        ))}
      </p>
      <DataTable
        label={say("scan-references-lines")}
        scroll="scan__lines"
        class="table--dense"
        data-testid="reference-lines"
        rows={plan.rows}
        keyOf={(row) => row.line}
        columns={({ col, num }) => [
          num(say("scan-references-line"), (row) => row.line),
          ...(timed ? [col(say("scan-references-time"), (row) => row.time, "nowrap")] : []),
          num(say("scan-references-vehicle"), (row) =>
            row.by_time ? say("scan-references-by-time", row) : row.number,
          ),
          ...(timed ? [num(say("scan-references-apart"), (row) => apartSeconds(row.apart_s), "nowrap")] : []),
          col(say("scan-references-given"), givenWords),
          col(say("scan-references-what"), (row) => CHANGES[row.change], "nowrap"),
          col(say("scan-references-why"), (row) => sentencesOf(row.words)),
        ]}
      />
    </>
  );
}

/** "+0.3 s": how much later the line's time is than the vehicle's. */
function apartSeconds(apart_s: number | null): string {
  if (apart_s === null) return "–";
  return `${apart_s < 0 ? "−" : "+"}${fixed(Math.abs(apart_s), 2)} s`;
}

function givenWords({ given, run_of, source }: ReferenceRow): string {
  const values = given.map((one) =>
    say("scan-references-one", {
      quantity: QUANTITY_WORDS[one.quantity],
      value: referenceValue({ ...one, U95: null }),
      u: apartWords(one.quantity, one.u),
    }),
  );
  return apart([...values, run_of ?? "", given.length ? "" : source].filter(Boolean));
}
