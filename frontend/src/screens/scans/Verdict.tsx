/** Accept or reject a motion, or a height clicked in a strip; a second person's work, as for other heights. */
import { useState } from "preact/hooks";
import { Button, Notice, StateMark, TextField } from "../../components";
import { hint } from "../../core/commands";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import type { LineHeight, ScanMotion } from "../../core/types";
import { mayBeJudged } from "./heights";
import type { Verdict as Given } from "./kinds";
import type { ScanModel } from "./model";

const OF_MOTION = wordsOf({
  boundary: "scan-reason-boundary",
  notOne: "scan-reason-not-one",
  match: "scan-reason-match",
});
const OF_HEIGHT = wordsOf("review-reason-", "contact", "point", "wrong");
const OF_EYE = wordsOf("review-reason-", "side");

interface Judging {
  readonly model: ScanModel;
  /** What is judged, as `model.judging.rejecting` names it. */
  readonly what: "motion" | number;
  readonly review: LineHeight["review"];
  readonly reasons: readonly string[];
  /** The keys judge this one now. */
  readonly keys: boolean;
  give(verdict: Given["verdict"], reason?: string): void;
}

export function Verdict({ model, m }: { model: ScanModel; m: ScanMotion }) {
  if (m.status !== "ok" || !may("reviewer")) return null;
  if (m.mine) return <Notice>{say("scan-verdict-mine")}</Notice>;
  return (
    <Judge
      model={model}
      what="motion"
      review={m.review}
      reasons={Object.values(OF_MOTION)}
      keys={model.judging.judged.value === null}
      give={(verdict, reason) => void model.judging.review(verdict, reason)}
    />
  );
}

/** The state of a height's review; with the verdict where it is this one's turn, or where its details are open. */
export function HeightVerdict({ model, one, open }: { model: ScanModel; one: LineHeight; open: boolean }) {
  const turn = model.judging.judged.value?.id === one.id;
  const rejecting = model.judging.rejecting.value === one.id;
  if (!mayBeJudged(one) || !(turn || open || rejecting)) return <Standing one={one} open={open} />;
  return (
    <div class={turn ? "line-heights__verdict line-heights__verdict--turn" : "line-heights__verdict"}>
      <Judge
        model={model}
        what={one.id}
        review={one.review}
        reasons={Object.values(one.target === "driver_eye" ? { ...OF_HEIGHT, ...OF_EYE } : OF_HEIGHT)}
        keys={turn}
        give={(verdict, reason) => void model.judging.reviewHeight(one, verdict, reason)}
      />
    </div>
  );
}

function Standing({ one, open }: { one: LineHeight; open: boolean }) {
  const { review } = one;
  if (one.status !== "ok") return null;
  return (
    <div class="line-heights__verdict small">
      {(open && givenWords(review)) || <StateMark state={review.verdict} />}
      {open && one.mine && may("reviewer") && <span class="muted">{say("scan-height-verdict-mine")}</span>}
    </div>
  );
}

function Judge(judging: Judging) {
  const { model, what, review, keys, give } = judging;
  if (model.judging.rejecting.value === what) return <Reject {...judging} />;
  const given = givenWords(review);
  if (given) {
    return (
      <div class="row row--wrap">
        <span class="small grow">{given}</span>
        <Button small busy={model.busy.value} onClick={() => give("reopened")}>
          {say("scan-verdict-reopen")}
        </Button>
      </div>
    );
  }
  return (
    <div class="row row--wrap">
      <Button
        kind="primary"
        icon="check"
        small={what !== "motion"}
        busy={model.busy.value}
        title={say("scan-verdict-accept") + (keys ? hint("reviewAccept") : "")}
        onClick={() => give("accepted")}
      >
        {say("scan-verdict-accept")}
      </Button>
      <Button
        small={what !== "motion"}
        title={say("scan-verdict-reject") + (keys ? hint("reviewReject") : "")}
        onClick={() => {
          model.judging.rejecting.value = what;
        }}
      >
        {say("scan-verdict-reject-why")}
      </Button>
    </div>
  );
}

/** Who said what; null while it waits. */
function givenWords({ verdict, reason, reviewer }: LineHeight["review"]): string | null {
  if (verdict !== "accepted" && verdict !== "rejected") return null;
  const person = reviewer?.name ?? say("scan-by-somebody");
  if (!reason) return say("scan-verdict-given", { verdict, person });
  return say("scan-verdict-given-why", { verdict, person, reason });
}

function Reject({ model, reasons, give }: Judging) {
  const [reason, setReason] = useState<string>("");
  const send = (event: Event): void => {
    event.preventDefault();
    if (reason.trim() === "") return;
    give("rejected", reason.trim());
    model.judging.rejecting.value = null;
  };
  return (
    <form class="stack stack--tight" onSubmit={send}>
      <div class="row row--wrap">
        {reasons.map((one) => (
          <Button key={one} small pressed={reason === one} onClick={() => setReason(one)}>
            {one}
          </Button>
        ))}
      </div>
      <TextField label={say("scan-verdict-reason")} value={reason} onInput={setReason} />
      <div class="row">
        <Button type="submit" kind="primary" disabled={reason.trim() === ""}>
          {say("scan-verdict-reject")}
        </Button>
        <Button
          onClick={() => {
            model.judging.rejecting.value = null;
          }}
        >
          {say("scan-verdict-leave")}
        </Button>
      </div>
    </form>
  );
}
