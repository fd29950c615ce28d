import { useState } from "preact/hooks";
import { FormDialog, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import type { MadeToken } from "../../core/types";
import { SCOPE_HINTS, SCOPE_NAMES, SCOPES, type Scope } from "./scopes";

const DAYS = ["7", "30", "90", "366"] as const;
type Days = (typeof DAYS)[number];

export function MakeToken({ close, made }: { close: () => void; made: (token: MadeToken) => void }) {
  const form = useForm({ name: "", days: "90" as Days });
  const { name, days } = form.values;
  const [scopes, setScopes] = useState<readonly Scope[]>(["read"]);
  const [tried, setTried] = useState(false);
  const submit = async () => {
    setTried(true);
    if (!name.trim() || scopes.length === 0) return;
    const body = { name: name.trim(), scopes: [...scopes], days: Number(days) };
    made(await api.write("POST /session/tokens", {}, { body }));
  };
  const choose = (scope: Scope, yes: boolean) =>
    setScopes(yes ? [...scopes, scope] : scopes.filter((one) => one !== scope));
  return (
    <FormDialog
      says="account-token-make"
      action={say("account-token-make-action")}
      onClose={close}
      submit={submit}
    >
      <TextField
        says="account-token-name-field"
        {...form.field("name")}
        hint={say("account-token-name-hint")}
        problem={tried && !name.trim() ? say("account-token-name-problem") : null}
      />
      <fieldset class="stack stack--dense field">
        <legend class="field__label">{say("account-token-scopes-field")}</legend>
        {SCOPES.map((scope) => (
          <label key={scope} class="row row--base tokens__scope">
            <input
              type="checkbox"
              checked={scopes.includes(scope)}
              onChange={(event) => choose(scope, event.currentTarget.checked)}
            />
            <span>
              {SCOPE_NAMES[scope]}
              <span class="field__hint">{SCOPE_HINTS[scope]}</span>
            </span>
          </label>
        ))}
        {tried && scopes.length === 0 && <p class="field__problem">{say("account-token-scopes-problem")}</p>}
      </fieldset>
      <SelectField
        says="account-token-days"
        {...form.field("days")}
        options={DAYS.map((value) => ({
          value,
          label: say("account-token-days-count", { days: Number(value) }),
        }))}
      />
    </FormDialog>
  );
}
