import { useState } from "preact/hooks";
import { Loading, Notice, Panel, Problem, SelectField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { Differences } from "./Differences";
import { Section } from "./Section";

/** This study less another one that the person chooses. */
export function Beside({ studyId }: { studyId: number }) {
  const studies = useResource((signal) => api.ask("GET /studies", {}, { signal }), []);
  const [other, setOther] = useState<number | null>(null);
  const others = (studies.data ?? []).filter((one) => one.id !== studyId && one.computed_at !== null);
  return (
    <Panel
      title={say("study-beside")}
      class={other === null ? "stat-noprint" : undefined}
      data-testid="study-beside"
    >
      <div class="panel__body stack stack--tight">
        <Problem error={studies.error} again={studies.reload} />
        <SelectField
          label={say("study-beside-with")}
          value={other === null ? "" : String(other)}
          options={[
            { value: "", label: say(others.length === 0 ? "study-beside-none" : "study-beside-choose") },
            ...others.map((one) => ({ value: String(one.id), label: one.name })),
          ]}
          onChange={(value) => setOther(value === "" ? null : Number(value))}
        />
        {other !== null && <Compared key={other} studyId={studyId} otherId={other} />}
      </div>
    </Panel>
  );
}

function Compared({ studyId, otherId }: { studyId: number; otherId: number }) {
  const found = useResource(
    (signal) =>
      api.ask(
        "GET /studies/{study_id}/beside/studies/{other_id}",
        { study_id: studyId, other_id: otherId },
        { signal },
      ),
    [studyId, otherId],
  );
  if (found.error) return <Problem error={found.error} again={found.reload} />;
  if (!found.data) return <Loading what={say("study-beside-loading")} />;
  const { first, second, shared_surveys: shared, differences } = found.data;
  return (
    <>
      {shared.length > 0 && (
        <Notice kind="warning">{say("study-beside-shared", { surveys: shared.join(", ") })}</Notice>
      )}
      <Section
        id="study-differences"
        title={say("study-beside-title", { first, second })}
        note={say("study-beside-note")}
      >
        <Differences rows={differences} />
      </Section>
    </>
  );
}
