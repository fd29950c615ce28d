/** Reference values from a CSV: what each line would do, before anything is stored. */
import { useState } from "preact/hooks";
import { Button, DataTable, Dialog, DropFiles, Loading, Notice, Problem } from "../../components";
import { CommitField } from "../../components/CommitField";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { apart, say, sentenceOf, sentencesOf, wordsOf } from "../../core/messages";
import type { ReferencePlan, ReferenceRow } from "../../core/types";
import { fixed, formatCount, parseNumber } from "../../core/units";
import type { ScanModel } from "./model";
import { apartWords, QUANTITY_WORDS, referenceValue } from "./referenceWords";

const CHANGES = wordsOf("scan-references-", "new", "replaces", "same", "ambiguous", "refused");

interface Done {
  values: number;
  cars: number;
  plan: ReferencePlan;
}

export function ReferenceImport({ model, onClose }: { model: ScanModel; onClose: () => void }) {
  const [file, setFile] = useState<File | null>(null);
  const [plan, setPlan] = useState<ReferencePlan | null>(null);
  const [done, setDone] = useState<Done | null>(null);
  const { busy, problem, run } = useAction();
  const [tolerance_s, setTolerance] = useState(1);
  const scan = { scan_id: model.id };
  const attempt = async (work: () => Promise<void>): Promise<void> => {
    if (!(await run(work))) setPlan(null);
  };
  const look = (chosen: File, within_s = tolerance_s) =>
    attempt(async () => {
      setFile(chosen);
      setTolerance(within_s);
      const asked = { ...scan, tolerance_s: within_s };
      setPlan(await api.ask("POST /scans/{scan_id}/references/preview", asked, { body: chosen }));
    });
  const store = () =>
    attempt(async () => {
      if (!file) return;
      const asked = { ...scan, tolerance_s };
      setDone(await api.write("POST /scans/{scan_id}/references/import", asked, { body: file }));
      await model.refresh();
    });
  const usable = plan ? (plan.counts["new"] ?? 0) + (plan.counts["replaces"] ?? 0) : 0;
  return (
    <Dialog
      wide
      title={say("scan-references-import-title")}
      onClose={onClose}
      actions={
        <>
          <Button says={done ? "action-close" : "action-cancel"} onClick={onClose} />
          {!done && (
            <Button kind="primary" busy={busy} disabled={usable === 0} onClick={() => void store()}>
              {say("scan-references-store", { count: usable })}
            </Button>
          )}
        </>
      }
    >
      <div class="stack">
        {done ? (
          <Notice>{say("scan-references-done", { values: done.values, cars: done.cars })}</Notice>
        ) : (
          <DropFiles
            label={say("scan-references-choose")}
            title={file ? file.name : say("scan-references-drop")}
            hint={say("scan-references-hint")}
            accept=".csv,text/csv"
            add={(files) => files[0] && void look(files[0])}
          />
        )}
        <Problem error={problem} />
        {busy && !plan && <Loading what={say("scan-references-looking")} />}
        {plan && !done && plan.tolerance_s !== null && (
          <CommitField
            says="scan-references-tolerance"
            value={String(tolerance_s)}
            unit="s"
            hint={say("scan-references-tolerance-hint")}
            check={(text) => (toleranceOf(text) === null ? say("scan-references-tolerance-problem") : null)}
            onCommit={(text) => file && void look(file, toleranceOf(text) ?? tolerance_s)}
          />
        )}
        {plan && !done && <Preview plan={plan} />}
      </div>
    </Dialog>
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
      {plan.notes.map(sentenceOf).map((note) => (
        <Notice key={note}>{note}</Notice>
      ))}
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
