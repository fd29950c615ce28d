import { useState } from "preact/hooks";
import { api } from "../../api";
import {
  ask,
  Button,
  Dialog,
  Loading,
  Notice,
  Problem,
  SelectField,
  StateMark,
  TextField,
} from "../../components";
import { useResource } from "../../state/resource";
import { may, me } from "../../state/session";
import { toast } from "../../state/toasts";
import { formatAgo } from "../../times";
import type { Person, Role } from "../../types";
import "./people.css";

const ROLES: { value: Role; label: string; does: string }[] = [
  { value: "viewer", label: "Viewer", does: "sees everything, exports packages" },
  { value: "operator", label: "Operator", does: "brings in recordings, calibrates, measures" },
  { value: "reviewer", label: "Reviewer", does: "what an operator does, and reviews the work of others" },
  { value: "admin", label: "Administrator", does: "everything, and people" },
];

interface Invitation {
  name: string;
  link: string;
}

/** Accounts and roles, for administrators. */
export default function PeopleScreen() {
  const people = useResource(
    (signal) => (may("admin") ? api.get<Person[]>("/people", { signal }) : Promise.resolve([])),
    [],
  );
  const [adding, setAdding] = useState(false);
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const [problem, setProblem] = useState<unknown>(null);
  if (!may("admin")) {
    return (
      <div class="page page--alone">
        <Notice>Only an administrator can see and change accounts; ask one if you need another role.</Notice>
      </div>
    );
  }
  const run = async (work: () => Promise<unknown>) => {
    setProblem(null);
    try {
      await work();
    } catch (error) {
      setProblem(error);
    }
    await people.reload();
  };
  const put = (person: Person, part: Partial<Person>) =>
    run(() => {
      const { name, role, active } = { ...person, ...part };
      return api.put(`/people/${person.id}`, { name, role, active });
    });
  const newLink = (person: Person) =>
    run(async () => {
      const { link } = await api.post<{ link: string }>(`/people/${person.id}/link`);
      setInvitation({ name: person.name, link });
    });
  const switchOff = async (person: Person) => {
    const yes = await ask({
      title: `Switch off ${person.name}?`,
      body: "They are signed out and cannot sign in again; what they measured and reviewed stays under their name.",
      action: "Switch off",
    });
    if (yes) await put(person, { active: false });
  };
  return (
    <div class="page page--alone">
      <header class="page__head">
        <div>
          <h1>People</h1>
          <p class="page__lead">Who may do what. Nobody reviews their own work, whatever their role.</p>
        </div>
        <Button kind="primary" icon="add" onClick={() => setAdding(true)}>
          Add a person
        </Button>
      </header>
      <Problem error={problem} />
      <Problem error={people.error} again={people.reload} />
      {!people.data && people.loading && <Loading what="people" />}
      {people.data && (
        <div class="panel table-scroll">
          <table class="table people">
            <thead>
              <tr>
                <th>name</th>
                <th>e-mail</th>
                <th>role</th>
                <th>state</th>
                <th>last seen</th>
                <th>
                  <span class="visually-hidden">actions</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {people.data.map((person) => (
                <PersonRow
                  key={person.id}
                  person={person}
                  put={put}
                  newLink={newLink}
                  switchOff={switchOff}
                />
              ))}
            </tbody>
          </table>
        </div>
      )}
      <dl class="facts people__roles">
        {ROLES.map((role) => (
          <>
            <dt>{role.label}</dt>
            <dd>{role.does}</dd>
          </>
        ))}
      </dl>
      {adding && (
        <AddPerson
          close={() => setAdding(false)}
          added={(made) => {
            setAdding(false);
            setInvitation(made);
            void people.reload();
          }}
        />
      )}
      {invitation && <ShowLink invitation={invitation} close={() => setInvitation(null)} />}
    </div>
  );
}

interface RowProps {
  person: Person;
  put: (person: Person, part: Partial<Person>) => Promise<void>;
  newLink: (person: Person) => Promise<void>;
  switchOff: (person: Person) => Promise<void>;
}

function PersonRow({ person, put, newLink, switchOff }: RowProps) {
  const isMe = me.value?.person.id === person.id;
  return (
    <tr>
      <td>
        <strong>{person.name}</strong>
        {isMe && <span class="muted"> (you)</span>}
      </td>
      <td>{person.email}</td>
      <td class="people__role">
        <SelectField
          hideLabel
          label={`Role of ${person.name}`}
          value={person.role}
          options={ROLES}
          onChange={(role) => void put(person, { role })}
        />
      </td>
      <td>
        <StateMark
          state={person.active ? "active" : "inactive"}
          word={person.active ? (person.has_password ? "active" : "no password yet") : "switched off"}
        />
      </td>
      <td class="muted nowrap" title={person.last_seen_at ?? undefined}>
        {person.last_seen_at ? formatAgo(person.last_seen_at) : "never"}
      </td>
      <td class="num">
        {person.active && (
          <Button small kind="quiet" onClick={() => void newLink(person)}>
            New link
          </Button>
        )}
        {person.active ? (
          <Button small kind="quiet" disabled={isMe} onClick={() => void switchOff(person)}>
            Switch off
          </Button>
        ) : (
          <Button small kind="quiet" onClick={() => void put(person, { active: true })}>
            Switch on
          </Button>
        )}
      </td>
    </tr>
  );
}

function AddPerson({ close, added }: { close: () => void; added: (made: Invitation) => void }) {
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

function ShowLink({ invitation, close }: { invitation: Invitation; close: () => void }) {
  const link = new URL(invitation.link, location.origin).href;
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link);
      toast("The link is on the clipboard.");
    } catch {
      document.querySelector<HTMLInputElement>("#sign-in-link")?.select();
    }
  };
  return (
    <Dialog
      title={`Sign-in link for ${invitation.name}`}
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Done</Button>
          <Button kind="primary" icon="copy" onClick={() => void copy()}>
            Copy the link
          </Button>
        </>
      }
    >
      <div class="stack">
        <p>Pass this on to {invitation.name}. It works once, for seven days, and is shown only now.</p>
        <input
          id="sign-in-link"
          class="input"
          readOnly
          value={link}
          aria-label="Sign-in link"
          onFocus={(event) => event.currentTarget.select()}
        />
      </div>
    </Dialog>
  );
}
