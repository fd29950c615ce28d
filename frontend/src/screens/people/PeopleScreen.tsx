import { useState } from "preact/hooks";
import {
  ask,
  Button,
  DataTable,
  Facts,
  Loaded,
  Notice,
  PageHead,
  Problem,
  SelectField,
  StateMark,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may, me } from "../../core/session";
import { formatAgo } from "../../core/times";
import { type Person, ROLE_NAMES, type Role } from "../../core/types";
import { STATE_WORDS } from "../../core/words";
import { AddPerson } from "../../parts/people/AddPerson";
import "./people.css";
import { DOES, roleOptions, roles } from "../../parts/people/roles";
import { type Invitation, ShowLink } from "../../parts/people/ShowLink";

export default function PeopleScreen() {
  const people = useAsked(may("admin") ? "GET /people" : null);
  const [adding, setAdding] = useState(false);
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const { problem, run } = useAction(people.reload);
  if (!may("admin")) {
    return (
      <div class="page page--alone">
        <Notice>{say("people-only-admin")}</Notice>
      </div>
    );
  }
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
        <div class="panel">
          <DataTable
            label={say("page-people")}
            class="table--middle"
            rows={people.data}
            keyOf={(person) => person.id}
            columns={({ col, actions }) => [
              col(say("people-name"), (person) => (
                <>
                  <strong>{person.name}</strong>
                  {isMe(person) && <span class="muted"> {say("people-you")}</span>}
                  <div class="muted anywhere">{person.email}</div>
                </>
              )),
              col(
                say("people-role"),
                (person) => (
                  <SelectField
                    hideLabel
                    label={say("people-role-of", { person: person.name })}
                    value={person.role}
                    options={roleOptions()}
                    onInput={(role) => void changeRole(person, role)}
                  />
                ),
                "people__role",
              ),
              col(say("people-state"), (person) => <StateOf person={person} />),
              {
                ...col(say("people-last-seen"), ({ last_seen_at }) => (
                  <span class="muted" title={last_seen_at ?? undefined}>
                    {last_seen_at ? formatAgo(last_seen_at) : say("people-never")}
                  </span>
                )),
                class: "nowrap",
              },
              actions(
                say("people-actions"),
                (person) => (
                  <>
                    {person.active && (
                      <Button
                        says="people-new-link"
                        small
                        kind="quiet"
                        onClick={() => void newLink(person)}
                      />
                    )}
                    <Button
                      says={person.active ? "people-switch-off" : "people-switch-on"}
                      small
                      kind="quiet"
                      disabled={person.active && isMe(person)}
                      onClick={() => void (person.active ? switchOff(person) : put(person, { active: true }))}
                    />
                  </>
                ),
                "num",
              ),
            ]}
          />
        </div>
      )}
      <Facts class="small" of={roles().map((role) => [ROLE_NAMES[role], DOES[role]])} />
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

function isMe({ id }: Person): boolean {
  return me.value?.person.id === id;
}

function StateOf({ person }: { person: Person }) {
  const state = person.active ? "active" : "inactive";
  const word = person.active && !person.has_password ? say("people-no-password") : STATE_WORDS[state];
  return <StateMark state={state} word={word} />;
}
