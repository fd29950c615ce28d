import { useState } from "preact/hooks";
import {
  ask,
  Button,
  Facts,
  Loaded,
  Notice,
  PageHead,
  Problem,
  SelectField,
  StateMark,
  Table,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { may, me } from "../../core/session";
import { formatAgo } from "../../core/times";
import { type Person, ROLE_NAMES, type Role } from "../../core/types";
import { STATE_WORDS } from "../../core/words";
import { AddPerson } from "../../parts/people/AddPerson";
import "./people.css";
import { DOES, roleOptions, roles } from "../../parts/people/roles";
import { type Invitation, ShowLink } from "../../parts/people/ShowLink";

/** Accounts and roles, for administrators. */
export default function PeopleScreen() {
  const people = useResource(
    (signal) => (may("admin") ? api.ask("GET /people", {}, { signal }) : Promise.resolve([])),
    [],
  );
  const [adding, setAdding] = useState(false);
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const { problem, run: attempt } = useAction();
  if (!may("admin")) {
    return (
      <div class="page page--alone">
        <Notice>{say("people-only-admin")}</Notice>
      </div>
    );
  }
  const run = async (work: () => Promise<unknown>) => {
    await attempt(work);
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
  const changeRole = async (person: Person, role: Role) => {
    const yes = await ask({
      title: say("people-role-title", { person: person.name, role: ROLE_NAMES[role] }),
      body: say("people-role-body", { person: person.name, does: DOES[role] }),
      action: say("people-role-change"),
    });
    // the list shows the role that stands, also where it was chosen and not confirmed
    await (yes ? put(person, { role }) : people.reload());
  };
  const switchOff = async (person: Person) => {
    const yes = await ask({
      title: say("people-switch-off-title", { person: person.name }),
      body: say("people-switch-off-body"),
      action: say("people-switch-off"),
    });
    if (yes) await put(person, { active: false });
  };
  return (
    <div class="page page--alone">
      <PageHead says="page-people" lead={say("people-lead")}>
        <Button says="people-add" kind="primary" icon="add" onClick={() => setAdding(true)} />
      </PageHead>
      <Problem error={problem} />
      <Loaded of={people} what={say("people-loading")} />
      {people.data && (
        <div class="panel table-scroll">
          <Table
            class="people"
            heads={[
              say("people-name"),
              say("people-email"),
              say("people-role"),
              say("people-state"),
              say("people-last-seen"),
              <span class="visually-hidden">{say("people-actions")}</span>,
            ]}
          >
            {people.data.map((person) => (
              <PersonRow
                key={person.id}
                person={person}
                put={put}
                newLink={newLink}
                switchOff={switchOff}
                changeRole={changeRole}
              />
            ))}
          </Table>
        </div>
      )}
      <Facts class="people__roles" of={roles().map((role) => [ROLE_NAMES[role], DOES[role]])} />
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
  changeRole: (person: Person, role: Role) => Promise<void>;
}

function PersonRow({ person, put, newLink, switchOff, changeRole }: RowProps) {
  const isMe = me.value?.person.id === person.id;
  const state = person.active ? "active" : "inactive";
  return (
    <tr>
      <td>
        <strong>{person.name}</strong>
        {isMe && <span class="muted"> {say("people-you")}</span>}
      </td>
      <td class="people__mail">{person.email}</td>
      <td class="people__role">
        <SelectField
          hideLabel
          label={say("people-role-of", { person: person.name })}
          value={person.role}
          options={roleOptions()}
          onInput={(role) => void changeRole(person, role)}
        />
      </td>
      <td>
        <StateMark
          state={state}
          word={person.active && !person.has_password ? say("people-no-password") : STATE_WORDS[state]}
        />
      </td>
      <td class="muted nowrap" title={person.last_seen_at ?? undefined}>
        {person.last_seen_at ? formatAgo(person.last_seen_at) : say("people-never")}
      </td>
      <td class="num">
        {person.active && (
          <Button says="people-new-link" small kind="quiet" onClick={() => void newLink(person)} />
        )}
        {person.active ? (
          <Button
            says="people-switch-off"
            small
            kind="quiet"
            disabled={isMe}
            onClick={() => void switchOff(person)}
          />
        ) : (
          <Button
            says="people-switch-on"
            small
            kind="quiet"
            onClick={() => void put(person, { active: true })}
          />
        )}
      </td>
    </tr>
  );
}
