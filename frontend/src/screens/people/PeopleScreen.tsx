import { Fragment } from "preact";
import { useState } from "preact/hooks";
import { ask, Button, Loading, Notice, Problem, SelectField, StateMark } from "../../components";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { may, me } from "../../core/session";
import { formatAgo } from "../../core/times";
import type { Person } from "../../core/types";
import { AddPerson } from "./AddPerson";
import "./people.css";
import { ROLES } from "./roles";
import { type Invitation, ShowLink } from "./ShowLink";

/** Accounts and roles, for administrators. */
export default function PeopleScreen() {
  const people = useResource(
    (signal) => (may("admin") ? api.ask("GET /people", {}, { signal }) : Promise.resolve([])),
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
      return api.write("PUT /people/{person_id}", { person_id: person.id }, { body: { name, role, active } });
    });
  const newLink = (person: Person) =>
    run(async () => {
      const { link } = await api.write("POST /people/{person_id}/link", { person_id: person.id });
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
                <th>last sign-in</th>
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
          <Fragment key={role.value}>
            <dt>{role.label}</dt>
            <dd>{role.does}</dd>
          </Fragment>
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
      <td class="people__mail">{person.email}</td>
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
