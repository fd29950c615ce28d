/** A study of surveys of this installation: what is joined, what came out of it, and its package and report. */
import { useEffect, useState } from "preact/hooks";
import { Button, Empty, FormDialog, JobProgress, Loaded, Notice, PageHead, Problem } from "../../components";
import { asked, navigate } from "../../core/address";
import { api } from "../../core/api";
import { isOver, useJobAction } from "../../core/jobs";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { formatMoment } from "../../core/times";
import { toast } from "../../core/toasts";
import type { Study, StudyPage, StudyResult } from "../../core/types";
import { Beside } from "./Beside";
import { Figures } from "./Figures";
import { Joined } from "./Joined";
import { Members } from "./Members";
import { StudyDialog } from "./StudyDialog";
import "./study.css";

export default function StudyScreen() {
  const id = asked("id");
  useEffect(() => {
    if (id === null) navigate("/studies", { replace: true }); // where one is chosen
  }, [id]);
  return id === null ? null : <Chosen key={id} id={id} />;
}

function Chosen({ id }: { id: number }) {
  const page = useAsked("GET /studies/{study_id}", { study_id: id });
  return (
    <div class="page page--alone page--wide study">
      <Loaded of={page} what={say("study-loading")} />
      {page.data && <Page page={page.data} reload={page.reload} />}
    </div>
  );
}

/** What runs of a study, and how it is asked for. */
function useComputing({ study, job: newest }: StudyPage, reload: () => Promise<void>) {
  const work = useJobAction({
    known: newest && !isOver(newest) ? newest.id : null,
    over: (ended) => {
      if (ended.state === "done") toast(say("study-computed"));
      return reload();
    },
  });
  const compute = () =>
    work.start(() => api.write("POST /studies/{study_id}/computings", { study_id: study.id }));
  return {
    ...work,
    compute,
    failed: !work.underWay && newest?.state === "failed" ? sentenceOf(newest.error) : null,
  };
}

function Page({ page, reload }: { page: StudyPage; reload: () => Promise<void> }) {
  const { study, result } = page;
  const { job: running, underWay, problem, failed, compute, cancel } = useComputing(page, reload);
  const [editing, setEditing] = useState(false);
  const [removing, setRemoving] = useState(false);
  const edit = may("operator") ? () => setEditing(true) : undefined;
  return (
    <>
      <Head page={page} running={underWay} compute={() => void compute()} />
      {study.simulated && <Notice kind="warning">{say("study-simulated-note")}</Notice>}
      {running && <JobProgress panel job={running} onCancel={cancel} />}
      {failed && <Notice kind="problem">{failed}</Notice>}
      <Problem error={problem} />
      {result && !underWay && isOld(result) && <Notice kind="warning">{oldWords(result)}</Notice>}
      {!result && !underWay && <NotComputed page={page} edit={edit} />}
      {result && <Figures found={result.found} />}
      {result && <Beside studyId={study.id} />}
      <Joined study={study} result={result} edit={edit} remove={edit && (() => setRemoving(true))} />
      <Members studyId={study.id} />
      {result && <Made result={result} />}
      {removing && <Removing study={study} close={() => setRemoving(false)} />}
      {editing && (
        <StudyDialog
          study={study}
          close={() => setEditing(false)}
          saved={() => {
            setEditing(false);
            void reload();
          }}
        />
      )}
    </>
  );
}

function Head({ page, running, compute }: { page: StudyPage; running: boolean; compute: () => void }) {
  const { study, result } = page;
  const fresh = result !== null && !isOld(result);
  return (
    <PageHead
      label={
        <>
          {study.name} {study.simulated && <span class="badge">{say("study-simulated")}</span>}
        </>
      }
      lead={study.description && study.description}
    >
      <div class="row row--wrap">
        {result && (
          <>
            <Button says="study-report" icon="download" href={result.report_url} download />
            <Button says="study-package" icon="package" href={result.package_url} download />
          </>
        )}
        {may("operator") && study.surveys.length > 0 && (
          <Button
            says={result ? "study-compute-again" : "study-compute"}
            kind={fresh ? "plain" : "primary"}
            busy={running}
            onClick={compute}
          />
        )}
      </div>
    </PageHead>
  );
}

function Removing({ study, close }: { study: Study; close: () => void }) {
  const remove = async () => {
    await api.write("DELETE /studies/{study_id}", { study_id: study.id, version: study.version });
    navigate("/studies");
  };
  return (
    <FormDialog says="study-remove" action={say("study-remove-now")} onClose={close} submit={remove}>
      <p>{say("study-remove-words", { name: study.name })}</p>
    </FormDialog>
  );
}

function Made({ result }: { result: StudyResult }) {
  return (
    <p class="muted small anywhere">
      {say("study-made", {
        moment: formatMoment(result.created_at),
        person: result.created_by?.name ?? say("study-made-by-system"),
        version: result.code_version,
        hash: result.sha256,
      })}
    </p>
  );
}

function isOld(result: StudyResult): boolean {
  return result.study_changed || result.surveys_changed.length > 0;
}

function oldWords(result: StudyResult): string {
  if (result.study_changed) return say("study-old-study");
  return say("study-old-surveys", { surveys: result.surveys_changed.join(", ") });
}

function NotComputed({ page, edit }: { page: StudyPage; edit: (() => void) | undefined }) {
  const none = page.study.surveys.length === 0;
  return (
    <Empty
      panel
      says={none ? "study-empty-title" : "study-not-computed-title"}
      why={none ? "study-empty" : "study-not-computed"}
      actions={
        none && edit ? (
          <Button says="study-add-surveys" kind="primary" icon="add" onClick={edit} />
        ) : undefined
      }
    />
  );
}
