import { useState } from "preact/hooks";
import { api } from "../../api";
import { Button, Dialog, Problem, SelectField, TextField } from "../../components";
import type { Person, Role } from "../../types";
import { ROLES } from "./roles";
import type { Invitation } from "./ShowLink";

export function AddPerson({ close, added }: { close: () => void; added: (made: Invitation) => void }) {
  const [name, setName] = useState("");
  const [email, setEmail] = useState("");
  const [role, setRole] = useState<Role>("operator");
  const [tried, setTried] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState(false);
  const emailWrong = !/^\S+@\S+$/.test(email.trim());
  const submit = async (event: Event) => {
    event.preventDefault();
    setTried(true);
    if (!name.trim() || emailWrong) return;
    setBusy(true);
    setProblem(null);
    try {
      const made = await api.post<{ person: Person; link: string }>("/people", {
        name: name.trim(),
        email: email.trim(),
        role,
      });
      added({ name: made.person.name, link: made.link });
    } catch (error) {
      setProblem(error);
      setBusy(false);
    }
  };
  return (
    <Dialog
      title="Add a person"
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          <Button
            kind="primary"
            busy={busy}
            onClick={() => document.querySelector<HTMLFormElement>("#add-person")?.requestSubmit()}
          >
            Add
          </Button>
        </>
      }
    >
      <form id="add-person" class="stack" onSubmit={submit} noValidate>
        <TextField
          label="Name"
          value={name}
          onInput={setName}
          problem={
            tried && !name.trim() ? "Give the person's name as it should appear beside their work." : null
          }
        />
        <TextField
          label="E-mail"
          type="email"
          value={email}
          onInput={setEmail}
          hint="They sign in with it. Sightline sends no mail: you pass on the link that comes next."
          problem={tried && emailWrong ? "Give an e-mail address, for example ada@example.org." : null}
        />
        <SelectField
          label="Role"
          value={role}
          options={ROLES}
          onChange={setRole}
          hint={ROLES.find((r) => r.value === role)?.does}
        />
        <Problem error={problem} />
        <button type="submit" hidden />
      </form>
    </Dialog>
  );
}
