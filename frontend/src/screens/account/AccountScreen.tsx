import { useState } from "preact/hooks";
import { Button, Notice, Problem, TextField } from "../../components";
import { api } from "../../core/api";
import { me } from "../../core/session";
import { toast } from "../../core/toasts";
import { ROLE_NAMES } from "../../core/types";
import "./account.css";

const LEAST = 10;

/** Who you are, and your password. */
export default function AccountScreen() {
  const person = me.value?.person;
  if (!person) return null;
  return (
    <div class="page page--alone account">
      <header class="page__head">
        <h1>Account</h1>
      </header>
      <section class="panel panel__body">
        <dl class="facts">
          <dt>Name</dt>
          <dd>{person.name}</dd>
          <dt>E-mail</dt>
          <dd>{person.email}</dd>
          <dt>Role</dt>
          <dd>{ROLE_NAMES[person.role]}</dd>
        </dl>
      </section>
      <PasswordForm hasPassword={person.has_password} />
    </div>
  );
}

function PasswordForm({ hasPassword }: { hasPassword: boolean }) {
  const [current, setCurrent] = useState("");
  const [next, setNext] = useState("");
  const [again, setAgain] = useState("");
  const [tried, setTried] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const short = next.length < LEAST;
  const differs = next !== again;
  const submit = async (event: Event) => {
    event.preventDefault();
    setTried(true);
    if (short || differs) return;
    setBusy(true);
    setProblem(null);
    try {
      me.value = await api.write(
        "PUT /session/password",
        {},
        { body: { current: hasPassword ? current : null, new: next } },
      );
      toast("Your password is set.");
      setCurrent("");
      setNext("");
      setAgain("");
      setTried(false);
    } catch (error) {
      setProblem(error);
    }
    setBusy(false);
  };
  return (
    <section class="panel">
      <header class="panel__head">
        <h2>{hasPassword ? "Change the password" : "Choose a password"}</h2>
      </header>
      <form class="panel__body stack" onSubmit={submit} noValidate>
        {!hasPassword && !tried && (
          <Notice>You have no password yet; without one you need a new link for each sign-in.</Notice>
        )}
        <input type="email" autoComplete="username" value={me.value?.person.email} readOnly hidden />
        {hasPassword && (
          <TextField
            label="Present password"
            type="password"
            value={current}
            onInput={setCurrent}
            autoComplete="current-password"
          />
        )}
        <TextField
          label="New password"
          type="password"
          value={next}
          onInput={setNext}
          autoComplete="new-password"
          hint={`At least ${LEAST} characters; a few words in a row are easy to keep in mind.`}
          problem={
            tried && short ? `That has ${next.length} characters; at least ${LEAST} are needed.` : null
          }
        />
        <TextField
          label="The same again"
          type="password"
          value={again}
          onInput={setAgain}
          autoComplete="new-password"
          problem={
            tried && !short && differs ? "The two are not the same; type the new password twice." : null
          }
        />
        <Problem error={problem} />
        <div>
          <Button kind="primary" type="submit" busy={busy}>
            Set the password
          </Button>
        </div>
      </form>
    </section>
  );
}
