import { useState } from "preact/hooks";
import { FormDialog, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import type { Role } from "../../core/types";
import { ROLES } from "./roles";
import type { Invitation } from "./ShowLink";

export function AddPerson({ close, added }: { close: () => void; added: (made: Invitation) => void }) {
  const [name, setName] = useState("");
  const [email, setEmail] = useState("");
  const [role, setRole] = useState<Role>("operator");
  const [tried, setTried] = useState(false);
  const emailWrong = !/^\S+@\S+$/.test(email.trim());
  const submit = () => {
    setTried(true);
    return !name.trim() || emailWrong ? null : add();
  };
  const add = async () => {
    const made = await api.write(
      "POST /people",
      {},
      {
        body: {
          name: name.trim(),
          email: email.trim(),
          role,
        },
      },
    );
    added({ name: made.person.name, link: made.link });
  };
  return (
    <FormDialog title="Add a person" action="Add" onClose={close} submit={submit}>
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
    </FormDialog>
  );
}
