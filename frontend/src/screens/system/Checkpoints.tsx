/** What the installation signed: where its audit chains ended, to be kept in another place. */
import { Button, Empty, Facts, Loading, num, Panel, Problem, Table } from "../../components";
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
  if (listed.newest.length === 0) return <Empty title={say("system-checkpoints-none")} />;
  return (
    <Table
      label={say("system-checkpoints")}
      scroll="checkpoints__list"
      heads={[
        say("audit-when"),
        say("audit-who"),
        num(say("system-checkpoints-chains")),
        num(say("system-checkpoints-events")),
        say("system-checkpoints-root"),
        <span class="visually-hidden">{say("table-actions")}</span>,
      ]}
    >
      {listed.newest.map((one) => (
        <tr key={one.id}>
          <td class="nowrap" title={one.at}>
            {formatMoment(one.at)}
          </td>
          <td class="nowrap">{one.by?.name ?? <span class="muted">{say("person-system")}</span>}</td>
          <td class="num">{formatCount(one.chains)}</td>
          <td class="num">{formatCount(one.events)}</td>
          <td>
            <code class="muted" title={one.root}>
              {one.root.slice(0, 16)}
            </code>
          </td>
          <td class="nowrap">
            <Button
              says="system-checkpoints-download"
              small
              icon="download"
              href={`/api/audit/checkpoints/${one.id}/checkpoint.json`}
              download
              label={say("system-checkpoints-download-of", { when: formatMoment(one.at) })}
            />
          </td>
        </tr>
      ))}
    </Table>
  );
}
