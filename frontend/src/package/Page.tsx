import { useEffect, useState } from "preact/hooks";
import { Checked } from "./Checked";
import { type Row, unsafe } from "./csv";
import { shown } from "./digits";
import { Languages } from "./Languages";
import { told } from "./language";
import { Measurements } from "./Measurements";
import {
  again,
  audited,
  checkPieces,
  done,
  failed,
  folder,
  type Opened,
  opened,
  progress,
  type TableName,
} from "./opened";
import { ofChosen, ofDropped, ofZip } from "./pieces";
import type { Part } from "./readme";
import { Grid, Section } from "./Section";
import { say } from "./say";
import { type Check, check, ofChain, ofFolder, ofHeights } from "./verdict";

export function Page() {
  const found = opened.value;
  if (found === null) {
    return (
      <p class="opened opened__wait">
        {failed.value === null ? say("opened-reading") : say("opened-unreadable")}
      </p>
    );
  }
  const [survey] = found.rows("survey");
  return (
    <main class="opened">
      <header class="opened__head">
        <Languages />
        <h1 class="opened__title">{unsafe(survey?.["name"] ?? "")}</h1>
        <p class="opened__quiet">
          {[unsafe(survey?.["site"] ?? ""), unsafe(survey?.["description"] ?? "")].filter(Boolean).join(". ")}
        </p>
        {found.about.only !== null && (
          <p class="opened__only" data-only>
            {say("opened-only", { only: found.about.only })}
          </p>
        )}
        <p class="opened__quiet">{say("opened-made-with", { version: found.about.made_with })}</p>
        <Doubt />
        <nav class="opened__links">
          <a href="report.pdf">{say("opened-report")}</a>
          <a href="#figures">{say("opened-figures")}</a>
          <a href="#tables">{say("opened-tables")}</a>
          <a href="#measurements">{say("opened-measurements")}</a>
          <a href="#checks">{say("opened-checks")}</a>
          <a href="#sizes">{say("opened-sizes")}</a>
        </nav>
      </header>
      <Conclusion parts={found.conclusion} />
      <Figures found={found} />
      <Tables found={found} />
      <Measurements found={found} />
      <div id="checks">
        <Checks />
      </div>
      <Sizes found={found} />
    </main>
  );
}

/** What is wrong is said before anything else. */
function Doubt() {
  if (!checksSoFar().some((one) => one.state === "wrong")) return null;
  return (
    <p class="opened__wrong" role="alert">
      {say("opened-is-wrong")} <a href="#checks">{say("opened-checks")}</a>
    </p>
  );
}

/** What came out, as the package's README says it. */
function Conclusion({ parts }: { parts: readonly Part[] }) {
  return (
    <>
      {parts.map(({ heading, items }) => (
        <Section key={heading} name={heading} data-conclusion>
          <ul class="opened__found">
            {items.map((item) => (
              <li key={item}>{item}</li>
            ))}
          </ul>
        </Section>
      ))}
    </>
  );
}

function checksSoFar(): Check[] {
  const known = audited.value;
  const files = folder.value;
  return [
    ...(again.value.size > 0 || done.value ? [ofHeights(again.value)] : []),
    ...(known === null ? [] : ofChain(known)),
    ...(files === null || files === "checking" ? [] : [ofFolder(files)]),
    ...(failed.value === null ? [] : [check("failed", false, say("opened-failed", { words: failed.value }))]),
  ];
}

function Checks() {
  return (
    <Checked
      checks={checksSoFar()}
      ended={done.value}
      verdicts={{ wrong: say("opened-is-wrong"), fine: say("opened-is-fine"), open: say("opened-checking") }}
      underWay={
        !done.value && (
          <progress class="opened__progress" value={progress.value} aria-label={say("opened-checking")} />
        )
      }
    >
      <FolderChoice />
      <details class="opened__about">
        <summary>{say("opened-what-title")}</summary>
        <p>{say("opened-what-here")}</p>
        <p>{say("opened-what-folder")}</p>
        <p>{say("opened-what-verify")}</p>
        <p>{say("opened-what-page")}</p>
      </details>
    </Checked>
  );
}

function FolderChoice() {
  const known = audited.value;
  const usable = known === "absent" || (known !== null && known.chain.seal !== null);
  useEffect(() => (usable ? dropsTaken() : undefined), [usable]);
  if (!usable) return null;
  const busy = folder.value === "checking";
  const choice = (kind: "folder" | "zip") => ({
    type: "file" as const,
    "data-choice": kind,
    disabled: busy,
    onClick: afresh,
  });
  return (
    <div class="opened__choices">
      <p>{busy ? say("opened-folder-checking") : say("opened-folder-choose")}</p>
      <label class="opened__choice">
        <span>{say("opened-folder-folder")}</span>
        <input
          {...choice("folder")}
          multiple
          ref={(input) => input?.setAttribute("webkitdirectory", "")}
          onChange={(event) => {
            const chosen = [...(event.currentTarget.files ?? [])];
            return checkPieces(async () => ofChosen(chosen));
          }}
        />
      </label>
      <label class="opened__choice">
        <span>{say("opened-folder-zip")}</span>
        <input
          {...choice("zip")}
          accept=".zip"
          onChange={(event) => {
            const [zip] = event.currentTarget.files ?? [];
            return zip && checkPieces(() => ofZip(zip));
          }}
        />
      </label>
    </div>
  );
}

/** The same file or folder may be chosen once more. */
function afresh(event: { currentTarget: HTMLInputElement }): void {
  event.currentTarget.value = "";
}

/** What is dropped anywhere on the page is checked, and not opened in its place. Returns what ends it. */
function dropsTaken(): () => void {
  const ends = new AbortController();
  const drop = (event: DragEvent) => {
    event.preventDefault();
    const { dataTransfer } = event;
    if (dataTransfer) void checkPieces(() => ofDropped(dataTransfer));
  };
  addEventListener("dragover", (event) => event.preventDefault(), { signal: ends.signal });
  addEventListener("drop", drop, { signal: ends.signal });
  return () => ends.abort();
}

/** The figures that the conclusion rests on come first. */
const FIRST = ["driver_eye-ecdf", "taillight-ecdf", "crest-k"];

function placeOf(path: string): number {
  const place = FIRST.findIndex((name) => path.endsWith(`/${name}.svg`));
  return place < 0 ? FIRST.length : place;
}

function Figures({ found }: { found: Opened }) {
  const figures = [...found.about.figures].sort((a, b) => placeOf(a.path) - placeOf(b.path));
  return (
    <Section id="figures" name={say("opened-figures")}>
      {figures.length === 0 && <p class="opened__quiet">{say("opened-figures-none")}</p>}
      <div class="opened__figures">
        {figures.map(({ path, title, wide }) => (
          <figure key={path} class={wide ? "opened__sheet opened__sheet--wide" : "opened__sheet"}>
            <img class="opened__figure" src={path} alt="" loading="lazy" />
            <figcaption>
              <a href={path}>{title}</a>
            </figcaption>
          </figure>
        ))}
      </div>
    </Section>
  );
}

function Tables({ found }: { found: Opened }) {
  const others = found.about.tables.filter((one) => !["measurements", "budget", "crops"].includes(one.name));
  return (
    <Section id="tables" name={say("opened-tables")}>
      <p class="opened__quiet">{say("opened-tables-lead")}</p>
      {found.about.left_out.length > 0 && (
        <p>{say("opened-left-out", { named: found.about.left_out.join(", ") })}</p>
      )}
      {others.map((one) => (
        <Table key={one.path} {...one} rows={found.rows} />
      ))}
    </Section>
  );
}

const MOST_ROWS = 200;

/** Cells with names and notes, some of which the program brought: these are said in the reader's language, as is what has a code. */
const WORDS: Readonly<Record<string, readonly string[]>> = {
  insets: ["note"],
  same_rule: ["standard", "class"],
  shares: ["standard", "source"],
};

interface TableProps {
  path: string;
  name: TableName;
  columns: Readonly<Record<string, string>>;
  rows: (name: string) => readonly Row[];
}

function Table({ path, name: table, columns, rows }: TableProps) {
  const [isOpen, setOpen] = useState(false);
  const all = isOpen ? rows(table) : [];
  const names = Object.keys(columns);
  return (
    <details class="opened__table" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        <a href={path}>{path}</a> {say("opened-table", { table })}
      </summary>
      {isOpen && all.length === 0 && <p class="opened__quiet">{say("opened-table-empty")}</p>}
      {all.length > MOST_ROWS && (
        <p class="opened__quiet">{say("opened-table-cut", { shown: MOST_ROWS, count: all.length })}</p>
      )}
      {all.length > 0 && (
        <Grid heads={names.map((name) => ({ name, title: told(columns[name] ?? "") }))}>
          {all.slice(0, MOST_ROWS).map((row) => (
            <tr key={names.map((name) => row[name]).join()}>
              {names.map((name) => (
                <td key={name} title={row[name]}>
                  {WORDS[table]?.includes(name) || `${name}_code` in columns
                    ? told(shown(path, name, row))
                    : shown(path, name, row)}
                </td>
              ))}
            </tr>
          ))}
        </Grid>
      )}
    </details>
  );
}

function Sizes({ found }: { found: Opened }) {
  const { folders } = found.about;
  const files = folders.reduce((sum, one) => sum + one.files, 0);
  const bytes = folders.reduce((sum, one) => sum + one.bytes, 0);
  return (
    <Section id="sizes" name={say("opened-sizes")}>
      <p>{say("opened-sizes-total", { files, mb: bytes / 1e6 })}</p>
      <ul class="opened__sizes">
        {folders.map((one) => (
          <li key={one.folder}>
            {one.folder === ""
              ? say("opened-size-top", { files: one.files, mb: one.bytes / 1e6 })
              : say("opened-size", { folder: one.folder, files: one.files, mb: one.bytes / 1e6 })}
          </li>
        ))}
      </ul>
    </Section>
  );
}
