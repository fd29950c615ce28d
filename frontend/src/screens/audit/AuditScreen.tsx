import { useState } from "preact/hooks";
import { Button, Empty, Loading, Notice, Problem, SelectField, TableScroll } from "../../components";
import { query, setQuery } from "../../core/address";
import { api, explain, fromAddress } from "../../core/api";
import { useResource } from "../../core/resource";
import { formatClock, formatDay } from "../../core/times";
import type { AuditCheck, AuditEvent } from "../../core/types";
import { formatCount } from "../../core/units";
import { changesOf } from "./changes";
import "./audit.css";

const PAGE = 100;
const ENTITIES = [
  "survey",
  "camera",
  "calibration_image",
  "calibration",
  "recording",
  "upload",
  "pose",
  "catalogue",
  "vehicle",
  "measurement",
  "review",
  "click_sigma",
  "standards",
  "export",
  "person",
  "sign_in_link",
  "job",
];

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
          <h1>Audit trail</h1>
          <p class="page__lead">
            One event per write, chained by hash: nothing here can be changed or removed without the chain
            showing it.
          </p>
        </div>
        <Verify />
      </header>
      <div class="audit__filters">
        <SelectField
          label="Survey"
          value={surveyId}
          options={[
            { value: "", label: "All" },
            ...(surveys.data ?? []).map((survey) => ({ value: String(survey.id), label: survey.name })),
          ]}
          onChange={(value) => setQuery({ survey_id: value || null })}
        />
        <SelectField
          label="What was changed"
          value={entity}
          options={[
            { value: "", label: "Everything" },
            ...ENTITIES.map((name) => ({ value: name, label: name.replaceAll("_", " ") })),
          ]}
          onChange={(value) => setQuery({ entity: value || null })}
        />
      </div>
      <Problem error={first.error} again={first.reload} />
      {!first.data && first.loading && <Loading what="the audit trail" />}
      {first.data && events.length === 0 && (
        <div class="panel">
          <Empty title="No events here">
            <p>
              {surveyId || entity
                ? "Nothing matches these filters; widen them."
                : "Nothing has been written yet."}
            </p>
          </Empty>
        </div>
      )}
      {events.length > 0 && (
        <TableScroll label="Audit events" class="panel">
          <table class="table audit">
            <thead>
              <tr>
                <th class="num">no.</th>
                <th>when</th>
                <th>who</th>
                <th>did</th>
                <th>changes</th>
                <th>hash</th>
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
            Show older events
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
      <td class="nowrap">{event.actor?.name ?? <span class="muted">the system</span>}</td>
      <td>
        {event.action.replaceAll("_", " ")}{" "}
        <span class="muted nowrap">{`${event.entity} ${event.entity_id}`.replaceAll("_", " ")}</span>
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
        <code class="muted" title={`${event.hash}, after ${event.previous_hash ?? "nothing"}`}>
          {event.hash.slice(0, 8)}
        </code>
      </td>
    </tr>
  );
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
        Check the chain
      </Button>
      {problem !== null && <Notice kind="problem">{explain(problem)}</Notice>}
      {check?.ok && (
        <Notice title="The chain is whole">
          {formatCount(check.checked)} events checked; the last hash is{" "}
          <code>{check.head_hash?.slice(0, 12)}</code>.
        </Notice>
      )}
      {check && !check.ok && (
        <Notice kind="problem" title="The chain is broken">
          {check.problem}
        </Notice>
      )}
    </div>
  );
}
