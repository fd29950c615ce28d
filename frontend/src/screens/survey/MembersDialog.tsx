/** Who belongs to the survey and as what; a manager changes it, everybody who sees the survey reads it. */
import { useState } from "preact/hooks";
import {
  ask,
  Button,
  Check,
  DataTable,
  Dialog,
  Loaded,
  named,
  OptionalField,
  Problem,
  SelectField,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may, me } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import {
  type Candidate,
  type Member,
  type Members,
  type Person,
  SURVEY_ROLE_NAMES,
  type SurveyRole,
} from "../../core/types";
import { AddPerson } from "../../parts/people/AddPerson";
import { type Invitation, ShowLink } from "../../parts/people/ShowLink";

const DOES: Readonly<Record<SurveyRole, string>> = wordsOf("members-does-");
/** Asked when it is drawn: a room's words may come after its code. */
const roles = () => Object.keys(DOES) as SurveyRole[];

const roleOptions = () => roles().map((value) => ({ value, label: SURVEY_ROLE_NAMES[value] }));

export function MembersDialog({ surveyId, close }: { surveyId: number; close: () => void }) {
  const manages = may("manager");
  const found = useAsked("GET /surveys/{survey_id}/members", { survey_id: surveyId });
  const others = useAsked(manages ? "GET /surveys/{survey_id}/members/others" : null, {
    survey_id: surveyId,
  });
  const { problem, run: attempt } = useAction();
  const [inviting, setInviting] = useState(false);
  const [invitation, setInvitation] = useState<Invitation | null>(null);
  const run = async (work: () => Promise<Members>) => {
    await attempt(async () => {
      await work();
      await refreshSurvey();
    });
    await Promise.all([found.reload(), others.reload()]);
  };
  const put = (person_id: number, role: SurveyRole) =>
    run(() =>
      api.write(
        "PUT /surveys/{survey_id}/members/{person_id}",
        { survey_id: surveyId, person_id },
        { body: { role } },
      ),
    );
  const remove = async ({ person_id, name }: Member) => {
    const mine = me.value?.person.id === person_id && me.value.person.role !== "admin";
    const yes = await ask({
      title: say("members-remove-title", { person: name }),
      body: mine ? say("members-remove-yourself") : say("members-remove-body", { person: name }),
      action: say("members-remove"),
    });
    if (!yes) return;
    await run(() =>
      api.write("DELETE /surveys/{survey_id}/members/{person_id}", { survey_id: surveyId, person_id }),
    );
  };
  const open = (open_to_all: boolean) =>
    run(() =>
      api.write("PUT /surveys/{survey_id}/open-to-all", { survey_id: surveyId }, { body: { open_to_all } }),
    );
  /** Who is new to Sightline is a member at once: an invitation alone shows them no survey. */
  const invited = async (made: Invitation, person: Person) => {
    setInviting(false);
    await put(person.id, person.role === "admin" ? "manager" : person.role);
    setInvitation(made);
  };
  const data = found.data;
  if (inviting)
    return (
      <AddPerson close={() => setInviting(false)} added={(made, person) => void invited(made, person)} />
    );
  if (invitation) return <ShowLink invitation={invitation} close={() => setInvitation(null)} />;
  return (
    <Dialog wide title={say("members-title")} onClose={close}>
      <Problem error={problem} />
      <Loaded of={found} what={say("members-loading")} />
      {data && (
        <div class="stack">
          <p class="field__hint">{say(data.open_to_all ? "members-lead-open" : "members-lead")}</p>
          <Check
            says="members-open-to-all"
            checked={data.open_to_all}
            disabled={!manages}
            onInput={(on) => void open(on)}
          />
          {data.members.length === 0 ? (
            <p class="muted">{say("members-none")}</p>
          ) : (
            <MemberTable members={data.members} manages={manages} put={put} remove={remove} />
          )}
          {manages && others.data && <AddMember others={others.data} add={put} />}
          {me.value?.person.role === "admin" && (
            <div>
              <Button says="members-invite" small onClick={() => setInviting(true)} />
            </div>
          )}
        </div>
      )}
    </Dialog>
  );
}

interface TableProps {
  members: readonly Member[];
  manages: boolean;
  put(personId: number, role: SurveyRole): Promise<void>;
  remove(member: Member): Promise<void>;
}

function MemberTable({ members, manages, put, remove }: TableProps) {
  return (
    <DataTable
      label={say("members-title")}
      rows={members}
      keyOf={(one) => one.person_id}
      columns={({ col, actions }) => [
        col(say("members-name"), (one) => (
          <>
            <strong>{one.name}</strong>
            {!one.active && <span class="muted"> {say("members-inactive")}</span>}
          </>
        )),
        col(say("members-role"), (one) => (
          <>
            {manages ? (
              <SelectField
                hideLabel
                label={say("members-role-of", { person: one.name })}
                value={one.role}
                options={roleOptions()}
                onInput={(role) => void put(one.person_id, role)}
              />
            ) : (
              SURVEY_ROLE_NAMES[one.role]
            )}
            {one.account_role === "admin" && <p class="field__hint">{say("members-admin")}</p>}
          </>
        )),
        actions(
          say("members-remove"),
          (one) =>
            manages && <Button says="members-remove" small kind="quiet" onClick={() => void remove(one)} />,
          "num",
        ),
      ]}
    />
  );
}

interface AddProps {
  others: readonly Candidate[];
  add(personId: number, role: SurveyRole): Promise<void>;
}

export function AddMember({ others, add }: AddProps) {
  const [person, setPerson] = useState<string | null>(null);
  const [role, setRole] = useState<SurveyRole>("operator");
  if (others.length === 0) return <p class="muted">{say("members-everybody")}</p>;
  const accountRole = others.find((one) => String(one.id) === person)?.account_role;
  /** What they are elsewhere is what they most likely are here: no reviewer becomes an operator unawares. */
  const choose = (id: string | null) => {
    setPerson(id);
    const chosen = others.find((one) => String(one.id) === id)?.account_role;
    if (chosen) setRole(chosen === "admin" ? "manager" : chosen);
  };
  const submit = async () => {
    await add(Number(person), role);
    setPerson(null);
  };
  return (
    <div class="members__add">
      <OptionalField
        says="members-add-person"
        value={person}
        none={say("members-choose")}
        options={named(others)}
        onInput={choose}
      />
      <SelectField
        says="members-add-role"
        value={role}
        options={roleOptions()}
        hint={accountRole === "admin" ? say("members-admin") : DOES[role]}
        onInput={setRole}
      />
      <Button says="members-add" disabled={person === null} onClick={() => void submit()} />
    </div>
  );
}
