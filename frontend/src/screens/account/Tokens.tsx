import { useState } from "preact/hooks";
import { ask, Button, Empty, Loading, Problem, ShowOnce, TableScroll } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { formatAgo, formatDay } from "../../core/times";
import type { ApiToken, MadeToken } from "../../core/types";
import { MakeToken } from "./MakeToken";
import { SCOPE_NAMES } from "./scopes";

/** Tokens with which programs speak for the person: made, seen and revoked here. */
export function Tokens() {
  const tokens = useResource((signal) => api.ask("GET /session/tokens", {}, { signal }), []);
  const [making, setMaking] = useState(false);
  const [made, setMade] = useState<MadeToken | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  const revoke = async (token: ApiToken) => {
    const yes = await ask({
      title: say("account-token-revoke-title", { name: token.name }),
      body: say("account-token-revoke-body"),
      action: say("account-token-revoke"),
    });
    if (!yes) return;
    setProblem(null);
    try {
      await api.write("DELETE /session/tokens/{token_id}", { token_id: token.id });
    } catch (error) {
      setProblem(error);
    }
    await tokens.reload();
  };
  return (
    <section class="panel">
      <header class="panel__head">
        <h2>{say("account-tokens")}</h2>
        {!!tokens.data?.length && (
          <Button icon="add" onClick={() => setMaking(true)}>
            {say("account-token-make")}
          </Button>
        )}
      </header>
      <Problem error={problem} />
      <Problem error={tokens.error} again={tokens.reload} />
      {!tokens.data && tokens.loading && <Loading what={say("account-tokens-loading")} />}
      {tokens.data?.length === 0 && (
        <Empty
          title={say("account-tokens-none")}
          actions={
            <Button icon="add" onClick={() => setMaking(true)}>
              {say("account-token-make")}
            </Button>
          }
        >
          <p>{say("account-tokens-help")}</p>
        </Empty>
      )}
      {!!tokens.data?.length && <TokenTable tokens={tokens.data} revoke={revoke} />}
      {making && (
        <MakeToken
          close={() => setMaking(false)}
          made={(token) => {
            setMaking(false);
            setMade(token);
            void tokens.reload();
          }}
        />
      )}
      {made && (
        <ShowOnce
          title={say("account-token-title", { name: made.token.name })}
          help={say("account-token-once")}
          label={say("account-token")}
          copied={say("account-token-copied")}
          text={made.text}
          close={() => setMade(null)}
        />
      )}
    </section>
  );
}

interface TableProps {
  tokens: readonly ApiToken[];
  revoke: (token: ApiToken) => Promise<void>;
}

function TokenTable({ tokens, revoke }: TableProps) {
  return (
    <TableScroll label={say("account-tokens")}>
      <table class="table tokens">
        <thead>
          <tr>
            <th>{say("account-token-name")}</th>
            <th>{say("account-token-scopes")}</th>
            <th>{say("account-token-ends")}</th>
            <th>{say("account-token-used")}</th>
            <th>
              <span class="visually-hidden">{say("people-actions")}</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {tokens.map((token) => (
            <tr key={token.id}>
              <td>{token.name}</td>
              <td>{token.scopes.map((scope) => SCOPE_NAMES[scope]).join(", ")}</td>
              <td class="nowrap">
                {ended(token) ? say("account-token-ended") : formatDay(token.expires_at)}
              </td>
              <td class="nowrap">
                {token.last_used_at ? formatAgo(token.last_used_at) : say("account-token-never")}
              </td>
              <td class="tokens__revoke">
                <Button small onClick={() => void revoke(token)}>
                  {say("account-token-revoke")}
                </Button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

function ended(token: ApiToken): boolean {
  return new Date(token.expires_at).getTime() <= Date.now();
}
