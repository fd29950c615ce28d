import { useState } from "preact/hooks";
import { Loaded, Notice, named, OptionalField, Panel, Problem } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { Differences } from "../../parts/figures/Differences";
import { Section } from "./Section";

export function Beside({ studyId }: { studyId: number }) {
  const studies = useAsked("GET /studies");
  const [other, setOther] = useState<string | null>(null);
  const others = (studies.data ?? []).filter((one) => one.id !== studyId && one.computed_at !== null);
  return (
    <Panel says="study-beside" class={other === null ? "stat-noprint" : undefined} data-testid="study-beside">
      <div class="panel__body stack stack--tight">
        <Problem error={studies.error} again={studies.reload} />
        <OptionalField
          says="study-beside-with"
          value={other}
          none={say(others.length === 0 ? "study-beside-none" : "study-beside-choose")}
          options={named(others)}
          onInput={setOther}
        />
        {other !== null && <Compared key={other} studyId={studyId} otherId={Number(other)} />}
      </div>
    </Panel>
  );
}

function Compared({ studyId, otherId }: { studyId: number; otherId: number }) {
  const found = useAsked("GET /studies/{study_id}/beside/studies/{other_id}", {
    study_id: studyId,
    other_id: otherId,
  });
  if (found.error || !found.data) return <Loaded of={found} what={say("study-beside-loading")} />;
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
