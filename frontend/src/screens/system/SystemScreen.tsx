/** How the installation is doing, for administrators: the same figures that Prometheus reads. */
import { Facts, Loaded, PageHead, Panel } from "../../components";
import { say } from "../../core/messages";
import { useAsked, useEvery } from "../../core/resource";
import { formatMoment } from "../../core/times";
import { formatBytes, formatCount } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
import { Checkpoints } from "./Checkpoints";
import { Licences } from "./Licences";

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
