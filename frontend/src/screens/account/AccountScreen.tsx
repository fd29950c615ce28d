import { useState } from "preact/hooks";
import { Button, Facts, LanguageChoice, Notice, PageHead, Panel, Problem, TextField } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { me } from "../../core/session";
import { toast } from "../../core/toasts";
import { ROLE_NAMES } from "../../core/types";
import "./account.css";
import { sent, useForm } from "../../core/form";
import { Tokens } from "./Tokens";

const LEAST = 10;
const EMPTY = { current: "", next: "", again: "" };

export default function AccountScreen() {
  const person = me.value?.person;
  if (!person) return null;
  return (
    <div class="page page--alone account">
      <PageHead says="page-account" />
      <section class="panel panel__body">
        <Facts
          of={[
            [say("account-name"), person.name],
            [say("account-email"), person.email],
            [say("account-role"), ROLE_NAMES[person.role]],
          ]}
        />
      </section>
      <section class="panel panel__body">
        <LanguageChoice class="stack stack--dense field" />
      </section>
      <PasswordForm hasPassword={person.has_password} />
      <Tokens />
    </div>
  );
}

function PasswordForm({ hasPassword }: { hasPassword: boolean }) {
  const form = useForm(EMPTY);
  const { current, next, again } = form.values;
  const [tried, setTried] = useState(false);
  const { busy, problem, run } = useAction();
  const short = next.length < LEAST;
  const differs = next !== again;
  const submit = async () => {
    setTried(true);
    if (short || differs) return;
    await run(async () => {
      me.value = await api.write(
        "PUT /session/password",
        {},
        { body: { current: hasPassword ? current : null, new: next } },
      );
      toast(say("account-password-is-set"));
      form.change(EMPTY);
      setTried(false);
    });
  };
  return (
    <Panel says={hasPassword ? "account-password-change" : "account-password-choose"}>
      <form class="panel__body stack" onSubmit={sent(submit)} noValidate>
        {!hasPassword && !tried && <Notice>{say("account-no-password")}</Notice>}
        <input type="email" autoComplete="username" value={me.value?.person.email} readOnly hidden />
        {hasPassword && (
          <TextField
            says="account-password-present"
            type="password"
            {...form.field("current")}
            autoComplete="current-password"
          />
        )}
        <TextField
          says="account-password-new"
          type="password"
          {...form.field("next")}
          autoComplete="new-password"
          hint={say("account-password-hint", { least: LEAST })}
          problem={
            tried && short ? say("account-password-short", { count: next.length, least: LEAST }) : null
          }
        />
        <TextField
          says="account-password-again"
          type="password"
          {...form.field("again")}
          autoComplete="new-password"
          problem={tried && !short && differs ? say("account-password-differs") : null}
        />
        <Problem error={problem} />
        <div>
          <Button says="account-password-set" kind="primary" type="submit" busy={busy} />
        </div>
      </form>
    </Panel>
  );
}
