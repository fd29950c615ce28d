/** The second click beside the first: before it, nothing is told; after it, how far apart they are. */
import { Button, Remark, StateMark } from "../../components";
import { Said } from "../../components/Said";
import { say, sentenceOf } from "../../core/messages";
import { me } from "../../core/session";
import type { Comparison, Measurement, ReviewItem } from "../../core/types";
import { formatLength, formatSmall } from "../../core/units";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { JudgeButton, Reject } from "../../parts/verdicts/Reject";
import type { ReviewModel } from "./model";

/** What may be known of a measurement that is to be clicked again: vehicle, target and frame. */
export function BlindPanel({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  return (
    <aside
      class="desk__side review__side"
      aria-label={say("review-measurement")}
      key={m.id}
      data-testid="blind-panel"
    >
      <ItemHead item={item} />
      <div class="stack stack--near review__body">
        <h3>{say("review-blind-title")}</h3>
        <p>{say(model.blind.contact.value ? "review-blind-target" : "review-blind-contact")}</p>
        <p class="small muted">{say("review-blind-why")}</p>
      </div>
      {model.rejection.begun.value ? (
        <Rejecting model={model} />
      ) : (
        <footer class="stack stack--tight review__verdict">
          <RejectButton model={model} />
        </footer>
      )}
    </aside>
  );
}

export function ItemHead({ item: { vehicle, measurement } }: { item: ReviewItem }) {
  return (
    <header class="row row--far vehicle__head">
      <h2>
        {vehicleName(vehicle.number)} {TARGET_WORDS[measurement.target]}
      </h2>
      <StateMark state={measurement.review.verdict} />
    </header>
  );
}

export function Rejecting({ model }: { model: ReviewModel }) {
  return (
    <footer class="stack stack--tight review__verdict">
      <Reject rejection={model.rejection} busy={model.busy.value} />
    </footer>
  );
}

export function RejectButton({ model }: { model: ReviewModel }) {
  return (
    <JudgeButton
      of="reviewReject"
      testId="review-reject"
      icon="close"
      disabled={!model.mayReject}
      onClick={() => model.startReject()}
    />
  );
}

export function Comparisons({ model }: { model: ReviewModel }) {
  const found = model.repeats.comparisons.value ?? [];
  if (found.length === 0) return null;
  return (
    <section
      class="stack stack--tight review__again"
      aria-label={say("review-again")}
      data-testid="comparisons"
    >
      {found.map((one) => (
        <Row key={one.repeat.id} model={model} one={one} />
      ))}
    </section>
  );
}

function Row({ model, one }: { model: ReviewModel; one: Comparison }) {
  const { repeat } = one;
  const own = repeat.created_by?.id === me.value?.person.id;
  return (
    <div class="review__again-row">
      <p>
        <Who repeat={repeat} own={own} />
      </p>
      <Remark
        icon={one.agrees === null ? "info" : one.agrees ? "check" : "warning"}
        action={
          own && (
            <Button
              says="review-again-take-back"
              small
              kind="quiet"
              onClick={() => void model.takeBack(repeat)}
            />
          )
        }
      >
        {comparisonWords(one)}
      </Remark>
    </div>
  );
}

function Who({ repeat, own }: { repeat: Measurement; own: boolean }) {
  const height = formatLength(repeat.height_m);
  const person = repeat.created_by?.name;
  const parts = { height: (text: string) => <span class="nowrap">{text}</span> };
  if (own) return <Said what="review-again-you" values={{ height }} parts={parts} />;
  if (!person) return <Said what="review-again-somebody" values={{ height }} parts={parts} />;
  return <Said what="review-again-person" values={{ person, height }} parts={parts} />;
}

/** "agree: 3 mm apart, expected within 9 mm"; the server says whether they do. */
function comparisonWords(one: Comparison): string {
  if (one.difference_m === null || one.expected_m === null)
    return sentenceOf(one.reason) ?? say("review-again-not-compared");
  const apart = formatSmall(Math.abs(one.difference_m));
  const expected = formatSmall(one.expected_m);
  return say(one.agrees ? "review-again-agree" : "review-again-differ", { apart, expected });
}
