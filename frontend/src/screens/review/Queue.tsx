/** The queue: which measurements, in which state, and which of them are one's own. */
import { Button, choices, Select, StateMark } from "../../components";
import { useRowsIn } from "../../components/oneTabStop";
import { PageTabs } from "../../components/PageTabs";
import { Said } from "../../components/Said";
import { say, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import { reviewTabs } from "../../core/tabs";
import type { ReviewItem } from "../../core/types";
import { heightWords, TARGET_WORDS, vehicleName } from "../../core/words";
import type { ReviewModel } from "./model";
import type { Shown } from "./queue";

const SHOWN_WORDS: Readonly<Record<Shown, string>> = wordsOf("review-state-");

export function Queue({ model }: { model: ReviewModel }) {
  const items = model.queue.items.value ?? [];
  const work = model.queue.work.value;
  const ofScans = survey.value?.scans.heights ?? 0;
  const box = useRowsIn<HTMLUListElement>(".pass", "data-measurement", model.currentId);
  return (
    <nav class="passes" aria-label={say("review-queue")}>
      <PageTabs label={say("page-review")} tabs={reviewTabs(model.surveyId, "review")} />
      <header class="passes__head">
        <h2>
          {work ? (
            <Said
              what="review-queue-title"
              values={{ count: work.to_review }}
              parts={{ muted: (text) => <span class="muted small">{text}</span> }}
            />
          ) : (
            say("page-review")
          )}
        </h2>
        <div class="stack stack--dense review__choose">
          <Select
            aria-label={say("review-show")}
            value={model.queue.shown.value}
            options={choices(SHOWN_WORDS)}
            onInput={(shown) => void model.show(shown)}
          />
        </div>
        <Plan model={model} />
        <LotLine model={model} />
        {work && (
          <p class="small muted" data-testid="review-counts">
            {say("review-counts", { accepted: work.accepted, rejected: work.rejected, count: work.heights })}{" "}
            {ofScans > 0 && `${say("review-counts-of-scans", { count: ofScans })} `}
            {work.own > 0 && say("review-own-waiting", { count: work.own })}
          </p>
        )}
      </header>
      <ul class="passes__list" ref={box}>
        {items.map((item) => (
          <Row key={item.measurement.id} model={model} item={item} />
        ))}
        {model.queue.more.value && (
          <li>
            <Button says="review-queue-more" small kind="quiet" onClick={() => void model.queue.loadMore()} />
          </li>
        )}
      </ul>
    </nav>
  );
}

export function lotAddress(surveyId: number, lot: number): string {
  return `/surveys/${surveyId}/lots?lot=${lot}`;
}

/** While the sample of one lot is judged, how to come back to the lot or to all; else how much waits for its lot's sample. */
function LotLine({ model }: { model: ReviewModel }) {
  const held = model.queue.work.value?.in_lots ?? 0;
  if (model.queue.lot !== null) {
    const number = model.queue.items.value?.[0]?.judged.lot?.number;
    const toLot = lotAddress(model.surveyId, model.queue.lot);
    return (
      <>
        {model.queue.lotJudged.value && (
          <div class="stack stack--dense below review__judged">
            <p class="small" data-testid="review-lot-judged">
              {say("lots-sample-done")}
            </p>
            <Button says="lots-decide" small kind="primary" href={toLot} />
          </div>
        )}
        <p class="small row" data-testid="review-lot">
          <a class="grow" href={toLot}>
            {number ? say("lots-sample-of", { number: String(number) }) : say("page-lots")}
          </a>
          <Button says="lots-show-all" small kind="quiet" onClick={() => void model.leaveLot()} />
        </p>
      </>
    );
  }
  if (held === 0) return null;
  return (
    <p class="small muted">
      <a href={`/surveys/${model.surveyId}/lots`}>{say("lots-held", { count: held })}</a>
    </p>
  );
}

/** Who is clicked blind is the survey's plan: told to everybody, chosen by an administrator. */
function Plan({ model }: { model: ReviewModel }) {
  const plan = model.queue.plan.value;
  if (!plan) return null;
  const oneIn = plan.blind_one_in;
  if (!may("manager")) {
    return (
      <p class="small muted" data-testid="blind-plan">
        {say("review-plan", { one_in: oneIn })}
      </p>
    );
  }
  return (
    <label class="review__plan small" title={say("review-plan-choose")}>
      {say("review-plan-name")}
      <Select
        aria-label={say("review-plan-choose")}
        data-testid="blind-plan"
        value={oneIn}
        options={(PLANS.includes(oneIn) ? PLANS : [oneIn, ...PLANS]).map((one_in) => ({
          value: one_in,
          label: say("review-plan-choice", { one_in }),
        }))}
        onInput={(one_in) => void model.choosePlan(one_in)}
      />
    </label>
  );
}

const PLANS = [1, 2, 5, 10, 20, 0];

function Row({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  return (
    <li>
      <button
        type="button"
        class="pass review__row"
        data-testid={`review-${m.id}`}
        data-measurement={m.id}
        aria-current={model.currentId.value === m.id ? "true" : undefined}
        onClick={() => {
          model.open(item);
          model.stage.focus();
        }}
      >
        <strong class="pass__number">{vehicleName(item.vehicle.number)}</strong>
        <span>{TARGET_WORDS[m.target]}</span>
        {item.vehicle.scan_name !== null && (
          <span class="badge" title={item.vehicle.scan_name}>
            {say("review-line")}
          </span>
        )}
        {item.mine ? (
          <span class="badge">{say("review-mine")}</span>
        ) : (
          m.review.verdict !== "to_review" && <StateMark state={m.review.verdict} hideWord />
        )}
        {item.judged.lot && (
          <span class="badge" title={say("lots-sample-of", { number: String(item.judged.lot.number) })}>
            {say("lots-badge", { number: String(item.judged.lot.number) })}
          </span>
        )}
        <span class="pass__name clip">
          {model.isHidden(item) ? say("review-blind-click") : heightWords(m)}
        </span>
      </button>
    </li>
  );
}
