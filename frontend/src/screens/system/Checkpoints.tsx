/** What the installation signed: where its audit chains ended, to be kept in another place. */
import { Button, DataTable, Empty, Facts, Loading, Panel, Problem } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { AnswerOf } from "../../core/routes";
import { formatMoment } from "../../core/times";
import { formatCount } from "../../core/units";
import "./checkpoints.css";

type Listed = AnswerOf<"GET /audit/checkpoints">;

export function Checkpoints() {
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
      <div class="panel__body checkpoints">
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
            <code class="checkpoints__key">{listed.key}</code>
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
      scroll="checkpoints__list"
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
