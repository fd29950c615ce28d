/** The first administrator came by a link and was called by no name: asked once, on the first page, and nothing waits for it. */

import { useState } from "preact/hooks";
import { Button, Problem, TextField } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { sent } from "../../core/form";
import { say } from "../../core/messages";
import { me } from "../../core/session";

export function OwnName() {
  const [name, setName] = useState("");
  const { problem, run } = useAction();
  if (!me.value?.needs_name) return null;
  const submit = async () => {
    if (!name.trim()) return;
    await run(async () => {
      me.value = await api.write("PUT /session/name", {}, { body: { name: name.trim() } });
    });
  };
  return (
    <form class="panel panel__body stack stack--tight" onSubmit={sent(submit)} data-testid="own-name">
      <h2>{say("own-name-title")}</h2>
      <p class="muted small">{say("own-name-why")}</p>
      <div class="row">
        <TextField hideLabel says="own-name" value={name} onInput={setName} autoComplete="name" />
        <Button says="action-save" type="submit" disabled={!name.trim()} />
      </div>
      <Problem error={problem} />
    </form>
  );
}
