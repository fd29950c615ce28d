/** How many vehicles of each kind are measured, of those that the survey wants. */
import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { Progress } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { Quota, SampleProgress } from "../../core/types";
import { CLASS_SET_WORDS, LIGHTING_WORDS } from "../../core/words";

/** The sample of a survey as it stands; read again whenever `of` gives another value. */
export function useSample(surveyId: number, of: () => unknown = () => null) {
  const found = useAsked("GET /surveys/{survey_id}/sample", { survey_id: surveyId });
  const before = useRef<unknown>(undefined);
  useSignalEffect(() => {
    const now = of();
    if (before.current !== undefined && before.current !== now) void found.reload();
    before.current = now;
  });
  return found;
}

export function SampleQuotas({ quotas }: { quotas: SampleProgress["quotas"] }) {
  if (quotas.length === 0) return null;
  return (
    <ul class="stack stack--tight" aria-label={say("sample-quotas")} data-testid="quotas">
      {quotas.map((one) => (
        <li key={quotaWords(one)}>
          <Progress
            still
            value={one.measured / one.wanted}
            label={quotaWords(one)}
            figure={say("sample-quota", { measured: one.measured, wanted: one.wanted })}
          />
        </li>
      ))}
    </ul>
  );
}

export function quotaWords({ lighting, class_set }: Pick<Quota, "lighting" | "class_set">): string {
  const of = class_set ? CLASS_SET_WORDS[class_set] : say("sample-any-class");
  return `${LIGHTING_WORDS[lighting]}, ${of}`;
}
