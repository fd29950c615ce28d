import { useState } from "preact/hooks";
import {
  Button,
  choices,
  DataTable,
  Empty,
  Loading,
  PageHead,
  Problem,
  Segments,
  TextField,
} from "../../components";
import { useAction } from "../../core/action";
import { query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { toast, toastProblem } from "../../core/toasts";
import type { CatalogueRow } from "../../core/types";
import { formatSmall, lengthScale, plainLength } from "../../core/units";
import { CATEGORY_WORDS } from "../../core/words";
import { yearsOf } from "../../parts/vehicles/ModelYears";
import { ImportDialog } from "./ImportDialog";
import { ModelDialog } from "./ModelDialog";
import { SIZE_WORDS, SIZES, type Size } from "./model";
import "./catalogue.css";

const A_PAGE = 50;

export default function CatalogueScreen() {
  const q = query.value.get("q") ?? "";
  const retired = query.value.get("retired") === "true";
  const offset = Number(query.value.get("offset") ?? 0) || 0;
  const found = useAsked("GET /catalogue/page", { q, retired, offset }, { keep: true });
  const [edited, setEdited] = useState<CatalogueRow | "new" | null>(null);
  const [importing, setImporting] = useState(false);
  const { problem, run } = useAction(found.reload);
  const put = (row: CatalogueRow) => {
    const body = { version: row.version, retired: row.retired_at === null };
    return api.write("POST /catalogue/{entry_id}/retire", { entry_id: row.id }, { body });
  };
  const retire = (row: CatalogueRow) =>
    run(async () => {
      const now = await put(row);
      const model = `${now.make} ${now.model}`;
      const run = () => void put(now).catch(toastProblem).then(found.reload);
      toast(say("catalogue-retire-done", { model, retired: now.retired_at === null ? "no" : "yes" }), {
        action: { label: say("command-undo"), run },
      });
    });
  return (
    <div class="page page--alone catalogue-page">
      <PageHead says="page-catalogue" lead={say("catalogue-lead")}>
        <div class="row">
          <Button says="catalogue-export" href="/api/catalogue/export" icon="download" />
          {canWork.value && (
            <>
              <Button says="catalogue-add" icon="add" onClick={() => setEdited("new")} />
              <Button
                says="catalogue-import"
                kind="primary"
                icon="upload"
                onClick={() => setImporting(true)}
              />
            </>
          )}
        </div>
      </PageHead>
      <div class="catalogue-search">
        <TextField
          says="catalogue-search"
          type="search"
          value={q}
          onInput={(text) => setQuery({ q: text || null, offset: null })}
        />
        <Segments
          says="catalogue-which"
          value={retired ? "retired" : "offered"}
          options={choices(wordsOf("catalogue-", "offered", "retired"))}
          onInput={(value) => setQuery({ retired: value === "retired" ? "true" : null, offset: null })}
        />
      </div>
      <Problem error={problem ?? found.error} again={found.reload} />
      {!found.data && found.loading && <Loading what={say("catalogue-loading")} />}
      {found.data && (
        <section class="panel" aria-label={say("page-catalogue")}>
          {found.data.total === 0 ? (
            <Empty says="catalogue-none" why={q ? "catalogue-none-found" : "catalogue-none-yet"} />
          ) : (
            <Models rows={found.data.entries} edit={setEdited} retire={retire} />
          )}
          <Pages offset={offset} total={found.data.total} />
        </section>
      )}
      {edited && (
        <ModelDialog
          row={edited === "new" ? null : edited}
          close={() => setEdited(null)}
          saved={() => {
            setEdited(null);
            void found.reload();
          }}
        />
      )}
      {importing && <ImportDialog close={() => setImporting(false)} imported={() => void found.reload()} />}
    </div>
  );
}

interface ModelsProps {
  rows: readonly CatalogueRow[];
  edit: (row: CatalogueRow) => void;
  retire: (row: CatalogueRow) => Promise<unknown>;
}

function Models({ rows, edit, retire }: ModelsProps) {
  const unit = lengthScale()[1];
  return (
    <DataTable
      label={say("page-catalogue")}
      class="table--dense"
      data-testid="catalogue"
      rows={rows}
      keyOf={(row) => row.id}
      columns={({ col, num, actions }) => [
        col(say("catalogue-model"), (row) => (
          <>
            <strong>{row.make}</strong> {row.model}
          </>
        )),
        col(say("catalogue-years"), yearsOf, "nowrap"),
        col(say("catalogue-category"), (row) => (row.category ? CATEGORY_WORDS[row.category] : "")),
        ...SIZES.map((size) => ({
          ...num(say("catalogue-size-head", { size: SIZE_WORDS[size], unit }), (row) => sizeWords(row, size)),
          cellTitle: (row: CatalogueRow) =>
            row[`${size}_m`] === null ? undefined : (row[`${size}_source`] ?? row.source),
        })),
        actions(
          say("people-actions"),
          (row) =>
            canWork.value && (
              <>
                <Button
                  says="catalogue-correct"
                  small
                  label={say("catalogue-correct-model", { model: `${row.make} ${row.model}` })}
                  onClick={() => edit(row)}
                />{" "}
                <Button
                  says={row.retired_at === null ? "catalogue-retire" : "catalogue-restore"}
                  small
                  onClick={() => void retire(row)}
                />
              </>
            ),
          "nowrap",
        ),
      ]}
    />
  );
}

/** A size over its standard uncertainty; where it comes from stands in the title. */
function sizeWords(row: CatalogueRow, size: Size) {
  const value = row[`${size}_m`];
  const u = row[`u_${size}_m`];
  if (value === null) return "–";
  return (
    <>
      {plainLength(value, 3)}
      {u !== null && <div class="muted small">{say("catalogue-u", { u: formatSmall(u) })}</div>}
    </>
  );
}

function Pages({ offset, total }: { offset: number; total: number }) {
  const last = Math.min(offset + A_PAGE, total);
  return (
    <footer class="row catalogue-pages small">
      <span class="grow">{say("catalogue-shown", { first: Math.min(offset + 1, total), last, total })}</span>
      <Button
        says="catalogue-before"
        small
        disabled={offset === 0}
        onClick={() => setQuery({ offset: Math.max(0, offset - A_PAGE) || null })}
      />
      <Button
        says="catalogue-after"
        small
        disabled={last >= total}
        onClick={() => setQuery({ offset: offset + A_PAGE })}
      />
    </footer>
  );
}
