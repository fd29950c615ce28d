import { useState } from "preact/hooks";
import { Button, LanguageChoice, Notice, PageHead, Panel, Problem, TextField } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { me } from "../../core/session";
import { toast } from "../../core/toasts";
import { ROLE_NAMES } from "../../core/types";
import "./account.css";
import { Tokens } from "./Tokens";

const LEAST = 10;

/** Who you are, your password, and the tokens of your programs. */
export default function AccountScreen() {
  const person = me.value?.person;
  if (!person) return null;
  return (
    <div class="page page--alone account">
      <PageHead title={say("page-account")} />
      <section class="panel panel__body">
        <dl class="facts">
          <dt>{say("account-name")}</dt>
          <dd>{person.name}</dd>
          <dt>{say("account-email")}</dt>
          <dd>{person.email}</dd>
          <dt>{say("account-role")}</dt>
          <dd>{ROLE_NAMES[person.role]}</dd>
        </dl>
      </section>
      <section class="panel panel__body">
        <LanguageChoice class="field" />
      </section>
      <PasswordForm hasPassword={person.has_password} />
      <Tokens />
    </div>
  );
}

function PasswordForm({ hasPassword }: { hasPassword: boolean }) {
  const [current, setCurrent] = useState("");
  const [next, setNext] = useState("");
  const [again, setAgain] = useState("");
  const [tried, setTried] = useState(false);
  const { busy, problem, run } = useAction();
  const short = next.length < LEAST;
  const differs = next !== again;
  const submit = async (event: Event) => {
    event.preventDefault();
    setTried(true);
    if (short || differs) return;
    await run(async () => {
      me.value = await api.write(
        "PUT /session/password",
        {},
        { body: { current: hasPassword ? current : null, new: next } },
      );
      toast(say("account-password-is-set"));
      setCurrent("");
      setNext("");
      setAgain("");
      setTried(false);
    });
  };
  return (
    <Panel title={say(hasPassword ? "account-password-change" : "account-password-choose")}>
      <form class="panel__body stack" onSubmit={submit} noValidate>
        {!hasPassword && !tried && <Notice>{say("account-no-password")}</Notice>}
        <input type="email" autoComplete="username" value={me.value?.person.email} readOnly hidden />
        {hasPassword && (
          <TextField
            label={say("account-password-present")}
            type="password"
            value={current}
            onInput={setCurrent}
            autoComplete="current-password"
          />
        )}
        <TextField
          label={say("account-password-new")}
          type="password"
          value={next}
          onInput={setNext}
          autoComplete="new-password"
          hint={say("account-password-hint", { least: LEAST })}
          problem={
            tried && short ? say("account-password-short", { count: next.length, least: LEAST }) : null
          }
        />
        <TextField
          label={say("account-password-again")}
          type="password"
          value={again}
          onInput={setAgain}
          autoComplete="new-password"
          problem={tried && !short && differs ? say("account-password-differs") : null}
        />
        <Problem error={problem} />
        <div>
          <Button kind="primary" type="submit" busy={busy}>
            {say("account-password-set")}
          </Button>
        </div>
      </form>
    </Panel>
  );
}
