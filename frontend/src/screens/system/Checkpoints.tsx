/** What the installation signed: where its audit chains ended, to be kept in another place. */
import { useState } from "preact/hooks";
import { Button, Empty, Loading, Problem, TableScroll } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import type { AnswerOf } from "../../core/routes";
import { formatMoment } from "../../core/times";
import { formatCount } from "../../core/units";
import "./checkpoints.css";

type Listed = AnswerOf<"GET /audit/checkpoints">;

export function Checkpoints() {
  const found = useResource((signal) => api.ask("GET /audit/checkpoints", {}, { signal }), []);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const sign = async () => {
    setBusy(true);
    setProblem(null);
    try {
      await api.write("POST /audit/checkpoints");
      await found.reload();
    } catch (error) {
      setProblem(error);
    }
    setBusy(false);
  };
  return (
    <section class="panel" data-testid="checkpoints">
      <header class="panel__head">
        <h2>{say("system-checkpoints")}</h2>
        <Button busy={busy} onClick={() => void sign()}>
          {say("system-checkpoints-sign")}
        </Button>
      </header>
      <div class="panel__body checkpoints">
        <p class="muted">{say("system-checkpoints-lead")}</p>
        <Problem error={problem ?? found.error} again={found.reload} />
        {!found.data && found.loading && <Loading what={say("system-checkpoints-loading")} />}
        {found.data?.key && <Key listed={found.data} />}
      </div>
      {found.data && <List listed={found.data} />}
    </section>
  );
}

function Key({ listed }: { listed: Listed }) {
  return (
    <dl class="facts">
      <dt>{say("system-checkpoints-key")}</dt>
      <dd>
        <code class="checkpoints__key">{listed.key}</code>
        {listed.keys_before > 0 && (
          <div class="small muted">
            {say("system-checkpoints-keys-before", { count: listed.keys_before })}
          </div>
        )}
      </dd>
    </dl>
  );
}

function List({ listed }: { listed: Listed }) {
  if (listed.newest.length === 0) return <Empty title={say("system-checkpoints-none")} />;
  return (
    <TableScroll label={say("system-checkpoints")} class="checkpoints__list">
      <table class="table">
        <thead>
          <tr>
            <th>{say("audit-when")}</th>
            <th>{say("audit-who")}</th>
            <th class="num">{say("system-checkpoints-chains")}</th>
            <th class="num">{say("system-checkpoints-events")}</th>
            <th>{say("system-checkpoints-root")}</th>
            <th>
              <span class="visually-hidden">{say("table-actions")}</span>
            </th>
          </tr>
        </thead>
        <tbody>
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
                  small
                  icon="download"
                  href={`/api/audit/checkpoints/${one.id}/checkpoint.json`}
                  download
                  label={say("system-checkpoints-download-of", { when: formatMoment(one.at) })}
                >
                  {say("system-checkpoints-download")}
                </Button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}
