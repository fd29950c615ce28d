import { Check, IconButton, named, OptionalField, Panel, Problem } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";

/** Who sees a study: its members, everybody where it is open, and administrators. */
export function Members({ studyId }: { studyId: number }) {
  const here = { study_id: studyId };
  const found = useAsked("GET /studies/{study_id}/members", here);
  const { problem, run } = useAction();
  const change = (sent: Promise<NonNullable<typeof found.data>>) =>
    run(async () => {
      found.set(await sent);
    });
  if (!found.data) return <Problem error={found.error} again={found.reload} />;
  const { members, others, open_to_all } = found.data;
  const openToAll = (open: boolean) =>
    api.write("PUT /studies/{study_id}/open-to-all", here, { body: { open_to_all: open } });
  const person = (id: number) => ({ ...here, person_id: id });
  return (
    <Panel says="study-members" class="stat-noprint" data-testid="study-members">
      <div class="panel__body stack stack--tight">
        <Check
          says="study-members-open"
          checked={open_to_all}
          disabled={!may("operator")}
          onInput={(on) => void change(openToAll(on))}
        />
        <ul class="row row--wrap row--far">
          {members.map((one) => (
            <li key={one.id} class="row row--near">
              {one.name}
              {may("operator") && (
                <IconButton
                  icon="close"
                  label={say("study-members-remove", { name: one.name })}
                  onClick={() =>
                    void change(api.write("DELETE /studies/{study_id}/members/{person_id}", person(one.id)))
                  }
                />
              )}
            </li>
          ))}
        </ul>
        {may("operator") && (
          <OptionalField
            says="study-members-add"
            value={null}
            none={say(others.length > 0 ? "study-members-choose" : "study-members-nobody")}
            options={named(others)}
            onInput={(id) =>
              id && void change(api.write("PUT /studies/{study_id}/members/{person_id}", person(Number(id))))
            }
          />
        )}
        <Problem error={problem} />
        <p class="field__hint">{say("study-members-note")}</p>
      </div>
    </Panel>
  );
}
