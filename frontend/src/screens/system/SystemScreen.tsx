/** How the installation is doing, for administrators: the same figures that Prometheus reads. */
import type { ComponentChildren } from "preact";
import { Loaded, PageHead, Panel } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useEvery, useResource } from "../../core/resource";
import { formatMoment } from "../../core/times";
import { formatBytes, formatCount } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
import { Checkpoints } from "./Checkpoints";
import { Licences } from "./Licences";

const STATES = ["queued", "running", "failed", "cancelled", "done"] as const;
const EVERY_MS = 5000;

export default function SystemScreen() {
  const found = useResource((signal) => api.ask("GET /system", {}, { signal }), [], { keep: true });
  useEvery(EVERY_MS, found.reload);
  const state = found.data;
  return (
    <div class="page page--alone">
      <PageHead title={say("page-system")} lead={say("system-lead")} />
      <Loaded of={found} what={say("system-loading")} />
      {state && (
        <>
          <Panel title={say("system-program")}>
            <div class="panel__body">
              <dl class="facts" data-testid="system-facts">
                <Fact term={say("system-version")}>{state.version}</Fact>
                <Fact term={say("system-database")}>
                  {say("system-database-of", {
                    kind: state.database === "sqlite" ? "sqlite" : "other",
                    count: state.database_connections,
                  })}
                </Fact>
                <Fact term={say("system-media")}>{state.media}</Fact>
                <Fact term={say("system-free")}>{formatBytes(state.free_bytes)}</Fact>
                <Fact term={say("system-memory")}>
                  {state.memory_bytes === null ? say("system-unknown") : formatBytes(state.memory_bytes)}
                </Fact>
                <Fact term={say("system-decoder")}>
                  {state.decoder === null
                    ? say("system-decoder-none")
                    : say("system-decoder-runs", { process: String(state.decoder) })}
                </Fact>
                <Fact term={say("system-waiting")}>
                  {say("system-waiting-of", {
                    reading: state.readers_waiting,
                    writing: state.writers_waiting,
                  })}
                </Fact>
                {state.clock_set_back && (
                  <Fact term={say("system-clock")}>
                    {say("system-clock-back", {
                      seconds: state.clock_set_back.by_s,
                      when: formatMoment(state.clock_set_back.noticed_at),
                    })}
                  </Fact>
                )}
              </dl>
            </div>
          </Panel>
          <Panel title={say("system-jobs")}>
            <div class="panel__body">
              <dl class="facts">
                {STATES.map((one) => (
                  <Fact key={one} term={STATE_WORDS[one]}>
                    <a href={`/jobs?state=${one}`}>{formatCount(state.jobs[one] ?? 0)}</a>
                  </Fact>
                ))}
              </dl>
            </div>
          </Panel>
          <Checkpoints />
          <Licences />
        </>
      )}
    </div>
  );
}

function Fact({ term, children }: { term: string; children: ComponentChildren }) {
  return (
    <>
      <dt>{term}</dt>
      <dd>{children}</dd>
    </>
  );
}
