/** How the installation is doing, for administrators: the same figures that Prometheus reads. */
import inPages from "virtual:licences";
import { useState } from "preact/hooks";
import { Button, DataTable, Empty, Facts, Loaded, Loading, PageHead, Panel, Problem } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked, useEvery } from "../../core/resource";
import type { AnswerOf } from "../../core/routes";
import { formatMoment } from "../../core/times";
import { formatBytes, formatCount } from "../../core/units";
import { STATE_WORDS } from "../../core/words";

const STATES = ["queued", "running", "failed", "cancelled", "done"] as const;
const EVERY_MS = 5000;

export default function SystemScreen() {
  const found = useAsked("GET /system", {}, { keep: true });
  useEvery(EVERY_MS, found.reload);
  const state = found.data;
  return (
    <div class="page page--alone">
      <PageHead says="page-system" lead={say("system-lead")} />
      <Loaded of={found} what={say("system-loading")} />
      {state && (
        <>
          <Panel says="system-program">
            <div class="panel__body">
              <Facts
                data-testid="system-facts"
                of={[
                  [say("system-version"), state.version],
                  [
                    say("system-answered"),
                    say("system-answered-by", { host: state.host, process: String(state.process) }),
                  ],
                  [
                    say("system-database"),
                    say("system-database-of", {
                      kind: state.database === "sqlite" ? "sqlite" : "other",
                      count: state.database_connections,
                    }),
                  ],
                  [say("system-media"), state.media],
                  [say("system-free"), formatBytes(state.free_bytes)],
                  [
                    say("system-memory"),
                    state.memory_bytes === null ? say("system-unknown") : formatBytes(state.memory_bytes),
                  ],
                  [
                    say("system-decoder"),
                    state.decoder === null
                      ? say("system-decoder-none")
                      : say("system-decoder-runs", { process: String(state.decoder) }),
                  ],
                  [
                    say("system-waiting"),
                    say("system-waiting-of", {
                      reading: state.readers_waiting,
                      writing: state.writers_waiting,
                    }),
                  ],
                  state.clock_set_back && [
                    say("system-clock"),
                    say("system-clock-back", {
                      seconds: state.clock_set_back.by_s,
                      when: formatMoment(state.clock_set_back.noticed_at),
                    }),
                  ],
                ]}
              />
            </div>
          </Panel>
          <Panel says="system-jobs">
            <div class="panel__body">
              <Facts
                of={STATES.map((one) => [
                  STATE_WORDS[one],
                  <a href={`/jobs?state=${one}`}>{formatCount(state.jobs[one] ?? 0)}</a>,
                ])}
              />
            </div>
          </Panel>
          <Checkpoints />
          <Licences />
        </>
      )}
    </div>
  );
}

type Listed = AnswerOf<"GET /audit/checkpoints">;

/** What the installation signed: where its audit chains ended, to be kept in another place. */
function Checkpoints() {
  const found = useAsked("GET /audit/checkpoints");
  const { busy, problem, run } = useAction();
  const sign = () =>
    run(async () => {
      await api.write("POST /audit/checkpoints");
      await found.reload();
    });
  return (
    <Panel
      says="system-checkpoints"
      aside={<Button says="system-checkpoints-sign" busy={busy} onClick={() => void sign()} />}
      data-testid="checkpoints"
    >
      <div class="panel__body stack stack--near">
        <p class="muted">{say("system-checkpoints-lead")}</p>
        <Problem error={problem ?? found.error} again={found.reload} />
        {!found.data && found.loading && <Loading what={say("system-checkpoints-loading")} />}
        {found.data?.key && <Key listed={found.data} />}
      </div>
      {found.data && <List listed={found.data} />}
    </Panel>
  );
}

function Key({ listed }: { listed: Listed }) {
  return (
    <Facts
      of={[
        [
          say("system-checkpoints-key"),
          <>
            <code class="anywhere">{listed.key}</code>
            {listed.keys_before > 0 && (
              <div class="small muted">
                {say("system-checkpoints-keys-before", { count: listed.keys_before })}
              </div>
            )}
          </>,
        ],
      ]}
    />
  );
}

function List({ listed }: { listed: Listed }) {
  if (listed.newest.length === 0) return <Empty says="system-checkpoints-none" />;
  return (
    <DataTable
      label={say("system-checkpoints")}
      scroll="tall"
      rows={listed.newest}
      keyOf={(one) => one.id}
      columns={({ col, num, actions }) => [
        { ...col(say("audit-when"), (one) => formatMoment(one.at), "nowrap"), cellTitle: (one) => one.at },
        col(
          say("audit-who"),
          (one) => one.by?.name ?? <span class="muted">{say("person-system")}</span>,
          "nowrap",
        ),
        num(say("system-checkpoints-chains"), (one) => formatCount(one.chains)),
        num(say("system-checkpoints-events"), (one) => formatCount(one.events)),
        col(say("system-checkpoints-root"), (one) => (
          <code class="muted" title={one.root}>
            {one.root.slice(0, 16)}
          </code>
        )),
        actions(
          say("table-actions"),
          (one) => (
            <Button
              says="system-checkpoints-download"
              small
              icon="download"
              href={`/api/audit/checkpoints/${one.id}/checkpoint.json`}
              download
              label={say("system-checkpoints-download-of", { when: formatMoment(one.at) })}
            />
          ),
          "nowrap",
        ),
      ]}
    />
  );
}

/** The libraries that the server runs on and that the pages are made of, with the licences that they state. */
function Licences() {
  const [open, setOpen] = useState(false);
  return (
    <Panel
      says="system-licences"
      aside={
        <Button
          says={open ? "system-licences-hide" : "system-licences-show"}
          onClick={() => setOpen(!open)}
        />
      }
    >
      {open && <Lists />}
    </Panel>
  );
}

function Lists() {
  const found = useAsked("GET /system/licences");
  return (
    <>
      <Loaded of={found} what={say("system-licences-loading")} />
      {found.data && <LicencesList title={say("system-licences-server")} libraries={found.data} />}
      <LicencesList title={say("system-licences-pages")} libraries={inPages} />
    </>
  );
}

function LicencesList({ title, libraries }: { title: string; libraries: typeof inPages }) {
  return (
    <DataTable
      label={title}
      rows={libraries}
      keyOf={(one) => `${one.name} ${one.version}`}
      columns={({ col }) => [
        col(title, (one) => one.name),
        col(say("system-licences-version"), (one) => one.version, "nowrap"),
        col(say("system-licences-licence"), (one) => one.licence ?? say("system-licences-none")),
      ]}
    />
  );
}
