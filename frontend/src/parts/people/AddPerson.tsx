import { useState } from "preact/hooks";
import { FormDialog, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { Person, Role } from "../../core/types";
import { DOES, roleOptions } from "./roles";
import type { Invitation } from "./ShowLink";

export function AddPerson({
  close,
  added,
}: {
  close: () => void;
  added: (made: Invitation, person: Person) => void;
}) {
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
    added({ name: made.person.name, link: made.link }, made.person);
  };
  return (
    <FormDialog title={say("people-add")} action={say("people-add-action")} onClose={close} submit={submit}>
      <TextField
        label={say("people-add-name")}
        value={name}
        onInput={setName}
        problem={tried && !name.trim() ? say("people-add-name-problem") : null}
      />
      <TextField
        label={say("people-add-email")}
        type="email"
        value={email}
        onInput={setEmail}
        hint={say("people-add-email-hint")}
        problem={tried && emailWrong ? say("people-add-email-problem") : null}
      />
      <SelectField
        label={say("people-add-role")}
        value={role}
        options={roleOptions()}
        onChange={setRole}
        hint={DOES[role]}
      />
    </FormDialog>
  );
}
