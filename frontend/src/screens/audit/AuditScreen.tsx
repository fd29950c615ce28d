import { useState } from "preact/hooks";
import { Button, Empty, Loading, Notice, Problem, SelectField, TableScroll } from "../../components";
import { Said } from "../../components/Said";
import { query, setQuery } from "../../core/address";
import { api, explain, fromAddress } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { formatClock, formatDay } from "../../core/times";
import type { AuditCheck, AuditEvent } from "../../core/types";
import { changesOf } from "./changes";
import { actionWords, ENTITY_WORDS, entityWords } from "./words";
import "./audit.css";

const PAGE = 100;

/** Who did what, when, from what to what; newest first. The chain of hashes can be checked here. */
export default function AuditScreen() {
  const surveyId = query.value.get("survey_id") ?? "";
  const entity = query.value.get("entity") ?? "";
  const [older, setOlder] = useState<AuditEvent[]>([]);
  const [atEnd, setAtEnd] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const surveys = useResource((signal) => api.ask("GET /surveys", {}, { signal }), []);
  const filter = {
    limit: PAGE,
    ...fromAddress<"GET /audit">({ survey_id: surveyId || undefined, entity: entity || undefined }),
  };
  const first = useResource(
    async (signal) => {
      const page = await api.ask("GET /audit", filter, { signal });
      setOlder([]);
      setAtEnd(page.length < PAGE);
      return page;
    },
    [surveyId, entity],
  );
  const events = [...(first.data ?? []), ...older];
  const more = async () => {
    const last = events.at(-1);
    if (!last) return;
    setBusy(true);
    setProblem(null);
    try {
      const page = await api.ask("GET /audit", { ...filter, before_id: last.id });
      setOlder([...older, ...page]);
      setAtEnd(page.length < PAGE);
    } catch (error) {
      setProblem(error);
    }
    setBusy(false);
  };
  return (
    <div class="page page--alone">
      <header class="page__head">
        <div>
          <h1>{say("audit-title")}</h1>
          <p class="page__lead">{say("audit-lead")}</p>
        </div>
        <Verify />
      </header>
      <div class="audit__filters">
        <SelectField
          label={say("audit-survey")}
          value={surveyId}
          options={[
            { value: "", label: say("audit-survey-all") },
            ...(surveys.data ?? []).map((survey) => ({ value: String(survey.id), label: survey.name })),
          ]}
          onChange={(value) => setQuery({ survey_id: value || null })}
        />
        <SelectField
          label={say("audit-what")}
          value={entity}
          options={[
            { value: "", label: say("audit-what-all") },
            ...Object.entries(ENTITY_WORDS).map(([value, label]) => ({ value, label })),
          ]}
          onChange={(value) => setQuery({ entity: value || null })}
        />
      </div>
      <Problem error={first.error} again={first.reload} />
      {!first.data && first.loading && <Loading what={say("audit-loading")} />}
      {first.data && events.length === 0 && (
        <div class="panel">
          <Empty title={say("audit-none-title")}>
            <p>{say(surveyId || entity ? "audit-none-filtered" : "audit-none")}</p>
          </Empty>
        </div>
      )}
      {events.length > 0 && (
        <TableScroll label={say("audit-events")} class="panel">
          <table class="table audit">
            <thead>
              <tr>
                <th class="num">{say("audit-number")}</th>
                <th>{say("audit-when")}</th>
                <th>{say("audit-who")}</th>
                <th>{say("audit-did")}</th>
                <th>{say("audit-changes")}</th>
                <th>{say("audit-hash")}</th>
              </tr>
            </thead>
            <tbody>
              {events.map((event) => (
                <EventRow key={event.id} event={event} />
              ))}
            </tbody>
          </table>
        </TableScroll>
      )}
      <Problem error={problem} again={() => void more()} />
      {events.length > 0 && !atEnd && (
        <div>
          <Button busy={busy} onClick={() => void more()}>
            {say("audit-older")}
          </Button>
        </div>
      )}
    </div>
  );
}

function EventRow({ event }: { event: AuditEvent }) {
  const changes = changesOf(event.before, event.after);
  const at = new Date(event.at);
  return (
    <tr>
      <td class="num muted">{event.id}</td>
      <td class="nowrap" title={event.at}>
        {formatDay(event.at)} <span class="muted">{formatClock(at)}</span>
      </td>
      <td class="nowrap">{event.actor?.name ?? <span class="muted">{say("person-system")}</span>}</td>
      <td>
        {actionWords(event)} <span class="muted nowrap">{entityWords(event)}</span>
      </td>
      <td class="audit__changes">
        {changes.length > 0 && (
          <details>
            <summary>
              <span class="clip">{changes.map((change) => change.name).join(", ")}</span>
            </summary>
            <dl>
              {changes.map((change) => (
                <div key={change.name}>
                  <dt>{change.name}</dt>
                  <dd>
                    {change.before !== null && (
                      <>
                        <del>{change.before}</del>{" "}
                      </>
                    )}
                    {change.after !== null && <ins>{change.after}</ins>}
                  </dd>
                </div>
              ))}
            </dl>
          </details>
        )}
      </td>
      <td>
        <code class="muted" title={hashWords(event)}>
          {event.hash.slice(0, 8)}
        </code>
      </td>
    </tr>
  );
}

function hashWords({ hash, previous_hash: previous }: AuditEvent): string {
  return previous ? say("audit-hash-after", { hash, previous }) : say("audit-hash-first", { hash });
}

function Verify() {
  const [check, setCheck] = useState<AuditCheck | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const run = async () => {
    setBusy(true);
    setProblem(null);
    try {
      setCheck(await api.ask("POST /audit/verify", {}, { retry: true }));
    } catch (error) {
      setProblem(error);
    }
    setBusy(false);
  };
  return (
    <div class="audit__verify">
      <Button busy={busy} onClick={() => void run()}>
        {say("audit-check")}
      </Button>
      {problem !== null && <Notice kind="problem">{explain(problem)}</Notice>}
      {check?.ok && (
        <Notice title={say("audit-whole-title")}>
          <Said
            what="audit-whole"
            values={{ count: check.checked, hash: check.head_hash?.slice(0, 12) ?? "–" }}
          />
        </Notice>
      )}
      {check && !check.ok && (
        <Notice kind="problem" title={say("audit-broken-title")}>
          {check.problem}
        </Notice>
      )}
    </div>
  );
}
