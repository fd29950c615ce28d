/** Accept or reject a motion; a second person's work, as for heights. */
import { useState } from "preact/hooks";
import { Button, Notice, TextField } from "../../components";
import { hint } from "../../core/commands";
import { may } from "../../core/session";
import type { ScanMotion } from "../../core/types";
import type { ScanModel } from "./model";

const REASONS = [
  "A boundary is not where the vehicle begins or ends.",
  "It is not one vehicle.",
  "The strips do not match.",
] as const;

export function Verdict({ model, m }: { model: ScanModel; m: ScanMotion }) {
  if (m.status !== "ok" || !may("reviewer")) return null;
  if (m.mine) return <Notice>You placed these boundaries, so somebody else reviews them.</Notice>;
  if (model.rejecting.value) return <Reject model={model} />;
  const verdict = m.review.verdict;
  if (verdict === "accepted" || verdict === "rejected") {
    return (
      <div class="row row--wrap">
        <span class="small grow">
          {verdict === "accepted" ? "Accepted" : "Rejected"} by {m.review.reviewer?.name ?? "somebody"}
          {m.review.reason && `: ${m.review.reason}`}
        </span>
        <Button small busy={model.busy.value} onClick={() => void model.review("reopened")}>
          Reopen
        </Button>
      </div>
    );
  }
  return (
    <div class="row row--wrap">
      <Button
        kind="primary"
        icon="check"
        busy={model.busy.value}
        title={`Accept${hint("reviewAccept")}`}
        onClick={() => void model.review("accepted")}
      >
        Accept
      </Button>
      <Button
        title={`Reject${hint("reviewReject")}`}
        onClick={() => {
          model.rejecting.value = true;
        }}
      >
        Reject…
      </Button>
    </div>
  );
}

function Reject({ model }: { model: ScanModel }) {
  const [reason, setReason] = useState<string>("");
  const send = (event: Event): void => {
    event.preventDefault();
    if (reason.trim() === "") return;
    void model.review("rejected", reason.trim());
    model.rejecting.value = false;
  };
  return (
    <form class="stack stack--tight" onSubmit={send}>
      <div class="row row--wrap">
        {REASONS.map((one) => (
          <Button key={one} small pressed={reason === one} onClick={() => setReason(one)}>
            {one}
          </Button>
        ))}
      </div>
      <TextField label="Why it is rejected" value={reason} onInput={setReason} />
      <div class="row">
        <Button type="submit" kind="primary" disabled={reason.trim() === ""}>
          Reject
        </Button>
        <Button
          onClick={() => {
            model.rejecting.value = false;
          }}
        >
          Leave it
        </Button>
      </div>
    </form>
  );
}
