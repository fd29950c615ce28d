/** Accept or reject a motion; a second person's work, as for heights. */
import { useState } from "preact/hooks";
import { Button, Notice, TextField } from "../../components";
import { hint } from "../../core/commands";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import type { ScanMotion } from "../../core/types";
import type { ScanModel } from "./model";

const REASONS = wordsOf({
  boundary: "scan-reason-boundary",
  notOne: "scan-reason-not-one",
  match: "scan-reason-match",
});

export function Verdict({ model, m }: { model: ScanModel; m: ScanMotion }) {
  if (m.status !== "ok" || !may("reviewer")) return null;
  if (m.mine) return <Notice>{say("scan-verdict-mine")}</Notice>;
  const { judging } = model;
  if (judging.rejecting.value) return <Reject model={model} />;
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
      <Button
        says="scan-verdict-accept"
        kind="primary"
        icon="check"
        busy={model.busy.value}
        title={say("scan-verdict-accept") + hint("reviewAccept")}
        onClick={() => void judging.review("accepted")}
      />
      <Button
        says="scan-verdict-reject-why"
        title={say("scan-verdict-reject") + hint("reviewReject")}
        onClick={() => judging.reject()}
      />
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

function Reject({ model: { judging } }: { model: ScanModel }) {
  const [reason, setReason] = useState<string>("");
  const leave = (): void => {
    judging.rejecting.value = false;
  };
  const send = (event: Event): void => {
    event.preventDefault();
    if (reason.trim() === "") return;
    void judging.review("rejected", reason.trim());
    leave();
  };
  return (
    <form class="stack stack--tight" onSubmit={send}>
      <div class="row row--wrap">
        {Object.values(REASONS).map((one) => (
          <Button key={one} small pressed={reason === one} onClick={() => setReason(one)}>
            {one}
          </Button>
        ))}
      </div>
      <TextField says="scan-verdict-reason" value={reason} onInput={setReason} />
      <div class="row">
        <Button says="scan-verdict-reject" type="submit" kind="primary" disabled={reason.trim() === ""} />
        <Button says="scan-verdict-leave" onClick={leave} />
      </div>
    </form>
  );
}
