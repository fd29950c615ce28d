/** Accept or reject a motion; a second person's work, as for heights. */
import { Button, Notice } from "../../components";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import type { ScanMotion } from "../../core/types";
import { JudgeButton, Reject } from "../../parts/verdicts/Reject";
import type { ScanModel } from "./model";

export function Verdict({ model, m }: { model: ScanModel; m: ScanMotion }) {
  if (m.status !== "ok" || !may("reviewer")) return null;
  if (m.mine) return <Notice>{say("scan-verdict-mine")}</Notice>;
  const { judging } = model;
  if (judging.rejection.begun.value) return <Reject rejection={judging.rejection} busy={model.busy.value} />;
  const given = givenWords(m.review);
  if (given) {
    return (
      <div class="row row--wrap">
        <span class="small grow">{given}</span>
        <Button
          says="scan-verdict-reopen"
          small
          busy={model.busy.value}
          onClick={() => void judging.review("reopened")}
        />
      </div>
    );
  }
  return (
    <div class="row row--wrap">
      <JudgeButton
        of="reviewAccept"
        testId="scan-accept"
        kind="primary"
        icon="check"
        disabled={model.busy.value}
        onClick={() => void judging.review("accepted")}
      />
      <JudgeButton of="reviewReject" testId="scan-reject" onClick={() => judging.reject()} />
    </div>
  );
}

/** Who said what; null while it waits. */
function givenWords({ verdict, reason, reviewer }: ScanMotion["review"]): string | null {
  if (verdict !== "accepted" && verdict !== "rejected") return null;
  const person = reviewer?.name ?? say("scan-by-somebody");
  if (!reason) return say("scan-verdict-given", { verdict, person });
  return say("scan-verdict-given-why", { verdict, person, reason });
}
