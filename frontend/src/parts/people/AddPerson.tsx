import { useState } from "preact/hooks";
import { FormDialog, SelectField, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
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
  const form = useForm({ name: "", email: "", role: "operator" as Role });
  const { name, email, role } = form.values;
  const [tried, setTried] = useState(false);
  const emailWrong = !/^\S+@\S+$/.test(email.trim());
  const submit = async () => {
    setTried(true);
    if (!name.trim() || emailWrong) return;
    const body = { name: name.trim(), email: email.trim(), role };
    const made = await api.write("POST /people", {}, { body });
    added({ name: made.person.name, link: made.link }, made.person);
  };
  return (
    <FormDialog says="people-add" action={say("people-add-action")} onClose={close} submit={submit}>
      <TextField
        says="people-add-name"
        {...form.field("name")}
        problem={tried && !name.trim() ? say("people-add-name-problem") : null}
      />
      <TextField
        says="people-add-email"
        type="email"
        {...form.field("email")}
        hint={say("people-add-email-hint")}
        problem={tried && emailWrong ? say("people-add-email-problem") : null}
      />
      <SelectField says="people-add-role" {...form.field("role")} options={roleOptions()} hint={DOES[role]} />
    </FormDialog>
  );
}
