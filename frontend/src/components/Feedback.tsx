/** What a screen says while it loads, when it is empty, when something is wrong, and how far work has come. */
import type { ComponentChildren } from "preact";
import { ApiError, explain } from "../core/api";
import { jobName } from "../core/jobs";
import { type PlainKey, type Said, say, sentenceOf } from "../core/messages";
import type { Resource } from "../core/resource";
import type { Job } from "../core/types";
import { Button } from "./Button";
import { Icon } from "./Icon";
import { type Named, nameOf } from "./named";

export function Loading({ what }: { what: string }) {
  return (
    <div class="row row--far muted loading" role="status">
      <span class="spinner" aria-hidden="true" />
      {say("loading", { what })}
    </div>
  );
}

type EmptyProps = Named & {
  why?: PlainKey;
  /** It stands for a whole panel. */
  panel?: boolean;
  children?: ComponentChildren;
  actions?: ComponentChildren;
};

/** Nothing here yet: says so, and what to do. */
export function Empty({ why, panel, children, actions, ...name }: EmptyProps) {
  const empty = (
    <div class="stack stack--near empty">
      <h2>{nameOf(name)}</h2>
      {(why || children) && (
        <div class="stack stack--tight">
          {why && <p>{say(why)}</p>}
          {children}
        </div>
      )}
      {actions && <div class="row row--wrap">{actions}</div>}
    </div>
  );
  return panel ? <div class="panel">{empty}</div> : empty;
}

interface NoticeProps {
  kind?: "info" | "warning" | "problem";
  title?: string;
  children?: ComponentChildren;
  actions?: ComponentChildren;
}

export function Notice({ kind = "info", title, children, actions }: NoticeProps) {
  const icon = kind === "info" ? "info" : kind === "warning" ? "warning" : "stop";
  return (
    <div class={`notice notice--${kind}`} role={kind === "problem" ? "alert" : undefined}>
      <span class="notice__icon">
        <Icon name={icon} />
      </span>
      <div class="notice__body">
        {title && <p class="notice__title">{title}</p>}
        {children && <div>{children}</div>}
      </div>
      {actions}
    </div>
  );
}

/** What the server says of a thing, each sentence by itself. */
export function Notices({ of, kind }: Pick<NoticeProps, "kind"> & { of: readonly Said[] | undefined }) {
  return of?.map(sentenceOf).map((one) => (
    <Notice key={one} kind={kind}>
      {one}
    </Notice>
  ));
}

/** What was asked for cannot be: asking once more gives the same answer. */
function isRefusal(error: unknown): boolean {
  return error instanceof ApiError && [400, 404, 422].includes(error.status);
}

export function Problem({ error, again }: { error: unknown; again?: () => void }) {
  if (!error) return null;
  return (
    <Notice
      kind="problem"
      actions={
        again && !isRefusal(error) && <Button says="action-try-again" small icon="retry" onClick={again} />
      }
    >
      {explain(error)}
    </Notice>
  );
}

/** What is read from the server, until it is here: that it is being loaded, or why it cannot be. */
export function Loaded({
  of,
  what,
}: {
  of: Pick<Resource<unknown>, "data" | "error" | "loading" | "reload">;
  what: string;
}) {
  return (
    <>
      <Problem error={of.error} again={of.reload} />
      {!of.data && of.loading && <Loading what={what} />}
    </>
  );
}

interface ProgressProps {
  value: number;
  label: string;
  /** Right of the bar's words: "41 %" unless given. */
  figure?: ComponentChildren;
  /** Work that rests: paused, queued. */
  still?: boolean;
}

export function Progress({ value, label, figure, still }: ProgressProps) {
  const share = value > 0 ? Math.min(1, value) : 0;
  // all of it is said of nothing less
  const percent = share < 1 ? Math.min(99, Math.round(100 * share)) : 100;
  return (
    <div class={`stack stack--dense progress${still ? " progress--still" : ""}`}>
      <div class="progress__words">
        <span>{label}</span>
        <span class="nowrap">{figure ?? say("percent", { percent })}</span>
      </div>
      <div
        class="progress__track"
        role="progressbar"
        aria-label={label}
        aria-valuenow={percent}
        aria-valuemin={0}
        aria-valuemax={100}
      >
        {share > 0 && <div class="progress__bar" style={{ width: `${100 * share}%` }} />}
      </div>
    </div>
  );
}

interface JobProgressProps {
  job: Job;
  onCancel?: () => void;
  /** It stands for a whole panel. */
  panel?: boolean;
  /** Where nothing else says what is being done: with the job's name before its words. */
  named?: boolean;
}

export function JobProgress({ job, onCancel, panel, named }: JobProgressProps) {
  const name = jobName(job.kind);
  const message = sentenceOf(job.message);
  const words = message ?? (job.state === "queued" ? say("job-queued") : name);
  const label = named && words !== name ? say("job-named", { job: name, words }) : words;
  const row = (
    <div class="row">
      <div class="grow">
        <Progress value={job.progress} label={label} still={job.state === "queued"} />
      </div>
      {onCancel && job.cancellable && <Button says="action-cancel" small onClick={onCancel} />}
    </div>
  );
  return panel ? <div class="panel panel__body">{row}</div> : row;
}
