import { useState } from "preact/hooks";
import { ask, Button, DataTable, Empty, Loaded, Panel, Problem, ShowOnce } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatAgo, formatDay } from "../../core/times";
import type { ApiToken, MadeToken } from "../../core/types";
import { MakeToken } from "./MakeToken";
import { SCOPE_NAMES } from "./scopes";

export function Tokens() {
  const tokens = useAsked("GET /session/tokens");
  const [making, setMaking] = useState(false);
  const [made, setMade] = useState<MadeToken | null>(null);
  const { problem, run } = useAction(tokens.reload);
  const revoke = async (token: ApiToken) => {
    const yes = await ask({
      title: say("account-token-revoke-title", { name: token.name }),
      body: say("account-token-revoke-body"),
      action: say("account-token-revoke"),
    });
    if (yes) await run(() => api.write("DELETE /session/tokens/{token_id}", { token_id: token.id }));
  };
  return (
    <Panel
      says="account-tokens"
      aside={
        !!tokens.data?.length && (
          <Button says="account-token-make" icon="add" onClick={() => setMaking(true)} />
        )
      }
    >
      <Problem error={problem} />
      <Loaded of={tokens} what={say("account-tokens-loading")} />
      {tokens.data?.length === 0 && (
        <Empty
          says="account-tokens-none"
          why="account-tokens-help"
          actions={<Button says="account-token-make" icon="add" onClick={() => setMaking(true)} />}
        />
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
    </Panel>
  );
}

interface TableProps {
  tokens: readonly ApiToken[];
  revoke: (token: ApiToken) => Promise<void>;
}

function TokenTable({ tokens, revoke }: TableProps) {
  return (
    <DataTable
      label={say("account-tokens")}
      class="table--middle"
      rows={tokens}
      keyOf={(token) => token.id}
      columns={({ col, actions }) => [
        col(say("account-token-name"), (token) => token.name),
        col(say("account-token-scopes"), (token) =>
          token.scopes.map((scope) => SCOPE_NAMES[scope]).join(", "),
        ),
        col(
          say("account-token-ends"),
          (token) => (ended(token) ? say("account-token-ended") : formatDay(token.expires_at)),
          "nowrap",
        ),
        col(
          say("account-token-used"),
          (token) => (token.last_used_at ? formatAgo(token.last_used_at) : say("account-token-never")),
          "nowrap",
        ),
        actions(
          say("people-actions"),
          (token) => <Button says="account-token-revoke" small onClick={() => void revoke(token)} />,
          "num",
        ),
      ]}
    />
  );
}

function ended(token: ApiToken): boolean {
  return new Date(token.expires_at).getTime() <= Date.now();
}
