import { useEffect, useState } from "preact/hooks";
import {
  Button,
  Check,
  choices,
  DataTable,
  Empty,
  IconButton,
  JobProgress,
  Loaded,
  Notice,
  OptionalField,
  PageHead,
  Panel,
  Problem,
} from "../../components";
import { nameOfLanguage } from "../../components/LanguageChoice";
import { linkTo, Said } from "../../components/Said";
import { api } from "../../core/api";
import { isOver, useJobAction } from "../../core/jobs";
import { apart, say, sentencesOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked } from "../../core/resource";
import { survey } from "../../core/survey";
import { formatMoment } from "../../core/times";
import { toast } from "../../core/toasts";
import type { ExportPackage } from "../../core/types";
import { formatBytes } from "../../core/units";
import { LIGHTING_WORDS } from "../../core/words";
import { Outdated } from "../../parts/again/Outdated";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { clockHour, type Filmed, FilmedFields, isOverMidnight } from "../../parts/filming/FilmedFields";
import { ClassChoice, classWords } from "../../parts/vehicles/ClassChoice";
import "./export.css";

type Wanted = ExportPackage["selection"];
const ALL: Wanted = {
  lighting: null,
  class_sets: [],
  categories: [],
  filmed_from: null,
  filmed_to: null,
  hour_from: null,
  hour_to: null,
};

/** What a package holds, as the table says it. */
const CONTENTS = [
  { files: ["report.pdf"], what: "export-contents-report" },
  { files: ["measurements.csv"], what: "export-contents-measurements" },
  { files: ["exclusions.csv"], what: "export-contents-exclusions" },
  { files: ["statistics", "figures"], what: "export-contents-statistics" },
  { files: ["crops"], what: "export-contents-crops" },
  { files: ["revisions.csv", "budget.csv"], what: "export-contents-revisions" },
  { files: ["clicks/pose-N.csv"], what: "export-contents-clicks" },
  { files: ["vehicles.csv"], what: "export-contents-vehicles" },
  { files: ["recordings.csv", "frames.csv"], what: "export-contents-recordings" },
  { files: ["poses", "calibrations"], what: "export-contents-poses" },
  { files: ["classes.csv", "selection.csv"], what: "export-contents-classes" },
  { files: ["insets.csv", "wheel_pairs.csv"], what: "export-contents-insets" },
  { files: ["reviews.csv", "repeats.csv"], what: "export-contents-reviews" },
  { files: ["audit.csv"], what: "export-contents-audit" },
  { files: ["datapackage.json"], what: "export-contents-datapackage" },
] as const;

/** One button writes the package that a standards body needs; every package made stays listed with its hash. */
export default function ExportScreen({ surveyId }: ScreenProps) {
  const packages = useAsked("GET /surveys/{survey_id}/exports", { survey_id: surveyId });
  const [crops, setCrops] = useState(true);
  const [wanted, setWanted] = useState<Wanted>(ALL);
  const { job, busy, underWay, problem, start, follow, cancel } = useJobAction({
    stopped: say("export-failed"),
    over: (ended) => {
      if (ended.state === "done") toast(say("export-ready"));
      return packages.reload();
    },
  });
  useRunning(Number(surveyId), follow);
  const build = () =>
    start(() =>
      api.write("POST /surveys/{survey_id}/exports", { survey_id: surveyId }, { body: { ...wanted, crops } }),
    );
  const counts = survey.value?.counts;
  const review = survey.value?.steps.find((step) => step.key === "review");
  return (
    <div class="page">
      <PageHead says="page-export" lead={say("export-lead")}>
        <div class="row row--wrap">
          <Check says="export-crops" checked={crops} disabled={underWay} onInput={setCrops} />
          <Button
            says="export-build"
            kind="primary"
            icon="package"
            busy={busy || underWay}
            onClick={() => void build()}
          />
        </div>
      </PageHead>
      <OutOfDateNotice surveyId={Number(surveyId)} computed={packages.reload} />
      <Choosing wanted={wanted} onChange={setWanted} />
      {counts && review && counts.to_review + counts.rejected > 0 && (
        <Notice kind="warning">
          {sentencesOf(review.summary)}{" "}
          <Said what="export-open-note" parts={linkTo(`/surveys/${surveyId}/review`)} />
        </Notice>
      )}
      {job && <JobProgress panel job={job} onCancel={cancel} />}
      <Problem error={problem} again={() => void build()} />
      <Panel says="export-packages">
        <Loaded of={packages} what={say("export-loading")} />
        {packages.data?.length === 0 && <Empty says="export-none-title" why="export-none" />}
        {packages.data && packages.data.length > 0 && <Packages list={packages.data} />}
      </Panel>
      {packages.data?.[0] && <Checking newest={packages.data[0]} />}
      <Panel says="export-contents">
        <table class="table">
          <tbody>
            {CONTENTS.map(({ files, what }) => (
              <tr key={what}>
                <td class="nowrap">
                  <code>{files.join(", ")}</code>
                </td>
                <td class="muted">{say(what)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </Panel>
    </div>
  );
}

function Choosing({ wanted, onChange }: { wanted: Wanted; onChange(wanted: Wanted): void }) {
  return (
    <section class="panel panel__body" aria-label={say("export-of-title")}>
      <div class="row row--wrap row--end row--far export__of">
        <OptionalField
          says="export-of-lighting"
          value={wanted.lighting}
          none={say("statistics-filter-any")}
          options={choices(LIGHTING_WORDS)}
          onInput={(lighting) => onChange({ ...wanted, lighting })}
        />
        <ClassChoice
          classSets={wanted.class_sets}
          categories={wanted.categories}
          onClassSets={(chosen) => onChange({ ...wanted, class_sets: chosen as Wanted["class_sets"] })}
          onCategories={(chosen) => onChange({ ...wanted, categories: chosen as Wanted["categories"] })}
        />
        <FilmedFields value={wanted} onChange={(change) => onChange({ ...wanted, ...change })} />
        <p class="field__hint">{say("export-of-help")}</p>
      </div>
    </section>
  );
}

function wantedWords({ lighting, class_sets, categories, ...filmed }: Wanted): string {
  const words = [
    lighting && LIGHTING_WORDS[lighting],
    classWords(class_sets, categories),
    ...filmedWords(filmed),
  ];
  return apart(words.filter((one): one is string => Boolean(one)));
}

/** On which days and at which hours. */
function filmedWords(filmed: Filmed): (string | null | false)[] {
  const { filmed_from: first, filmed_to: last, hour_from, hour_to } = filmed;
  const limited = hour_from !== null || hour_to !== null;
  const hours = { begins: clockHour(hour_from ?? 0), ends: clockHour(hour_to ?? 24) };
  const days = daysWord(first, last);
  if (isOverMidnight(filmed) && days)
    return [say("export-of-nights", { days, first: first ?? "", last: last ?? "", ...hours })];
  return [
    first && say("export-of-filmed-from", { day: first }),
    last && say("export-of-filmed-to", { day: last }),
    limited && say("export-of-hours", hours),
  ];
}

function daysWord(first: string | null, last: string | null): "one" | "several" | "since" | "until" | null {
  if (first && last) return first === last ? "one" : "several";
  if (first) return "since";
  return last ? "until" : null;
}

/** A package that is being built when the page is opened is followed as if it had been started here. */
function useRunning(surveyId: number, found: (jobId: number) => void) {
  useEffect(() => {
    const stop = new AbortController();
    api
      .ask("GET /jobs", { survey_id: surveyId }, { signal: stop.signal })
      .then((jobs) => {
        const running = jobs.find((job) => job.kind === "export" && !isOver(job));
        if (running) found(running.id);
      })
      .catch(() => undefined); // the list of packages tells what is wrong
    return () => stop.abort();
  }, [surveyId]);
}

async function copy(text: string, said: string) {
  await navigator.clipboard.writeText(text);
  toast(said);
}

function Packages({ list }: { list: ExportPackage[] }) {
  return (
    <DataTable
      label={say("export-packages")}
      class="table--hover table--dense"
      rows={list}
      keyOf={(entry) => entry.id}
      columns={({ col, num, actions }) => [
        col(say("export-made"), (entry) => (
          <>
            {formatMoment(entry.created_at)}
            <div class="muted">{entry.created_by?.name}</div>
            <Outdated since={entry.since} />
          </>
        )),
        col(say("export-of"), (entry) => wantedWords(entry.selection) || say("export-of-all")),
        col(say("export-language"), (entry) => nameOfLanguage(entry.language), "nowrap"),
        num(say("export-size"), (entry) => formatBytes(entry.size_bytes), "nowrap"),
        actions(say("export-download-column"), (entry) => (
          <Button says="export-download" small icon="download" href={entry.url} download />
        )),
        col(say("export-sha256"), (entry) => <Hash text={entry.sha256} which="sha256" />, "nowrap"),
        col(
          say("export-audit-head"),
          (entry) => <Hash text={entry.audit_head} which="audit-head" />,
          "nowrap",
        ),
      ]}
    />
  );
}

function Hash({ text, which }: { text: string; which: "sha256" | "audit-head" }) {
  return (
    <>
      <code title={text}>{text.slice(0, 8)}…</code>
      <IconButton
        icon="copy"
        label={say(`export-${which}-copy`)}
        onClick={() => void copy(text, say(`export-${which}-copied`))}
      />
    </>
  );
}

/** How the one who receives a package checks it, ready to be copied. */
function Checking({ newest }: { newest: ExportPackage }) {
  const command = `sightline verify ${newest.filename} --key ${newest.signing_key.slice(0, 32)}`;
  return (
    <Panel says="export-checking">
      <div class="panel__body stack stack--tight">
        <p>{say("export-checking-help")}</p>
        <p class="export__command">
          <code>{command}</code>
          <IconButton
            icon="copy"
            label={say("export-command-copy")}
            onClick={() => void copy(command, say("export-command-copied"))}
          />
        </p>
      </div>
    </Panel>
  );
}
