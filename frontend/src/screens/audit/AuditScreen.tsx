import { useState } from "preact/hooks";
import {
  Button,
  choices,
  DataTable,
  DateField,
  Empty,
  Loaded,
  Notice,
  named,
  OptionalField,
  PageHead,
  Problem,
} from "../../components";
import { CommitField } from "../../components/CommitField";
import { Said } from "../../components/Said";
import { useAction } from "../../core/action";
import { query, setQuery, surveyHere } from "../../core/address";
import { api, explain, fromAddress } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { useAsked, useResource } from "../../core/resource";
import { me } from "../../core/session";
import { formatClock, formatDay } from "../../core/times";
import type { AuditCheck, AuditEvent, NamedEvent } from "../../core/types";
import { changesOf } from "./changes";
import { actionWords, ENTITY_WORDS, pageOf, rowWords, subjectWords } from "./words";
import "./audit.css";

const PAGE = 100;

/** Who did what, when, from what to what; newest first. Administrators can check the chain of hashes here. */
export default function AuditScreen({ surveyId }: ScreenProps) {
  const filters = filtersOf(surveyId);
  const [older, setOlder] = useState<NamedEvent[]>([]);
  const [atEnd, setAtEnd] = useState(false);
  const { busy, problem, run } = useAction();
  const filter = { limit: PAGE, ...fromAddress<"GET /audit/events">(filters) };
  const first = useResource(
    async (signal) => {
      const page = await api.ask("GET /audit/events", filter, { signal });
      setOlder([]);
      setAtEnd(page.length < PAGE);
      return page;
    },
    [surveyId, query.value.toString()],
  );
  const events = [...(first.data ?? []), ...older];
  const more = async () => {
    const last = events.at(-1);
    if (!last) return;
    await run(async () => {
      const page = await api.ask("GET /audit/events", { ...filter, before_id: last.event.id });
      setOlder([...older, ...page]);
      setAtEnd(page.length < PAGE);
    });
  };
  return (
    <div class={surveyId ? "page" : "page page--alone"}>
      <PageHead
        says={surveyId ? "page-history" : "page-audit"}
        lead={say("audit-lead")}
        more={<p class="small muted">{say("audit-numbers")}</p>}
      >
        {me.value?.person.role === "admin" && <Verify />}
      </PageHead>
      <Filters surveyId={surveyId} />
      <Loaded of={first} what={say("audit-loading")} />
      {first.data && events.length === 0 && (
        <Empty
          panel
          says="audit-none-title"
          why={Object.keys(filters).length > 0 ? "audit-none-filtered" : "audit-none"}
        />
      )}
      {events.length > 0 && (
        <DataTable
          label={say("audit-events")}
          scroll="panel"
          class="audit"
          rows={events}
          keyOf={({ event }) => event.id}
          columns={({ col, num }) => [
            num(say("audit-number"), ({ event }) => event.number, "muted"),
            {
              ...col(say("audit-when"), ({ event: { at } }) => (
                <>
                  <span class="nowrap">{formatDay(at)}</span>{" "}
                  <span class="muted">{formatClock(new Date(at))}</span>
                </>
              )),
              cellTitle: ({ event }) => event.at,
            },
            col(
              say("audit-who"),
              ({ event }) => event.actor?.name ?? <span class="muted">{say("person-system")}</span>,
            ),
            col(say("audit-did"), (one) => <Did named={one} />, "audit__did"),
            col(say("audit-changes"), ({ event }) => <Changes event={event} />, "audit__changes"),
            col(say("audit-hash"), ({ event }) => (
              <code class="muted" title={hashWords(event)}>
                {event.hash.slice(0, 8)}
              </code>
            )),
          ]}
        />
      )}
      <Problem error={problem} again={() => void more()} />
      {events.length > 0 && !atEnd && (
        <div>
          <Button says="audit-older" busy={busy} onClick={() => void more()} />
        </div>
      )}
    </div>
  );
}

const FILTERS = ["survey_id", "entity", "person_id", "day", "vehicle"] as const;

function filtersOf(surveyId: number): Record<string, string> {
  const chosen = FILTERS.map((name) => [name, query.value.get(name) ?? ""] as const);
  const asked = Object.fromEntries(chosen.filter(([, value]) => value !== ""));
  return surveyId ? { ...asked, survey_id: String(surveyId) } : asked;
}

function Filters({ surveyId }: ScreenProps) {
  const surveys = useAsked("GET /surveys");
  const people = useAsked("GET /audit/people");
  const at = (name: (typeof FILTERS)[number]): string => query.value.get(name) ?? "";
  const filter = (name: (typeof FILTERS)[number]) => ({
    value: at(name) || null,
    onInput: (value: string | null) => setQuery({ [name]: value }),
  });
  return (
    <div class="grid grid--fill" style={{ "--least": "160px" }}>
      {!surveyId && (
        <OptionalField
          says="audit-survey"
          none={say("audit-survey-all")}
          options={named(surveys.data ?? [])}
          {...filter("survey_id")}
        />
      )}
      <OptionalField
        says="audit-what"
        none={say("audit-what-all")}
        options={choices<string>(ENTITY_WORDS)}
        {...filter("entity")}
      />
      <OptionalField
        says="audit-person"
        none={say("audit-person-all")}
        options={named(people.data ?? [])}
        {...filter("person_id")}
      />
      <DateField says="audit-day" value={at("day")} onChange={(day) => setQuery({ day })} />
      <CommitField
        says="audit-vehicle"
        numeric
        value={at("vehicle")}
        check={(text) => (/^\d{0,9}$/.test(text) ? null : say("audit-vehicle-problem"))}
        onCommit={(text) => setQuery({ vehicle: Number(text) > 0 ? Number(text) : null })}
      />
    </div>
  );
}

function Did({ named }: { named: NamedEvent }) {
  const { event, subject } = named;
  const page = pageOf(named);
  const words = subjectWords(named);
  return (
    <>
      {actionWords(event)}{" "}
      <span title={rowWords(event)}>{page ? <a href={page}>{words}</a> : <strong>{words}</strong>}</span>
      {surveyHere.value === 0 && subject.survey && <div class="small muted">{subject.survey}</div>}
    </>
  );
}

function Changes({ event }: { event: AuditEvent }) {
  const changes = changesOf(event.before, event.after);
  if (changes.length === 0) return null;
  const names = changes.map((change) => change.name).join(", ");
  return (
    <details>
      <summary>
        <span class="clip" translate={false} title={names}>
          {names}
        </span>
      </summary>
      <dl>
        {changes.map((change) => (
          <div key={change.name}>
            <dt translate={false}>{change.name}</dt>
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
  );
}

/** Whether one survey was chosen: then its name need not stand in each row. */
function hashWords({ hash, previous_hash: previous }: AuditEvent): string {
  return previous ? say("audit-hash-after", { hash, previous }) : say("audit-hash-first", { hash });
}

function Verify() {
  const [check, setCheck] = useState<AuditCheck | null>(null);
  const { busy, problem, run: attempt } = useAction();
  const run = () =>
    attempt(async () => {
      setCheck(await api.ask("POST /audit/verify", {}, { retry: true }));
    });
  return (
    <div class="stack stack--tight audit__verify">
      <Button says="audit-check" busy={busy} onClick={() => void run()} />
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
          {sentenceOf(check.problem)}
        </Notice>
      )}
    </div>
  );
}
