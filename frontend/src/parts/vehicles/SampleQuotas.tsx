/** How many vehicles of each kind are measured, of those that the survey wants. */
import { Progress } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import type { Quota, SampleProgress } from "../../core/types";
import { CLASS_SET_WORDS, LIGHTING_WORDS } from "../../core/words";

/** The sample of a survey as it stands; read again whenever `of` is another. Nothing is asked before it is known. */
export function useSample(surveyId: number, of: string | null = "") {
  const route = of === null ? null : "GET /surveys/{survey_id}/sample";
  return useAsked(route, { survey_id: surveyId }, { keep: true, also: [of] });
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
