/** The queue: which measurements, in which state, and which of them are one's own. */
import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { Button, StateMark } from "../../components";
import { may } from "../../core/session";
import { survey } from "../../core/survey";
import type { ReviewItem } from "../../core/types";
import { formatHeight } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import type { ReviewModel, Shown } from "./model";

const STATES: readonly { value: Shown; label: string }[] = [
  { value: "to_review", label: "To review" },
  { value: "rejected", label: "Rejected" },
  { value: "accepted", label: "Accepted" },
  { value: "fixed", label: "Fixed" },
  { value: "all", label: "All" },
];

export function Queue({ model }: { model: ReviewModel }) {
  const items = model.items.value ?? [];
  const counts = survey.value?.counts;
  const box = useRef<HTMLUListElement>(null);
  useSignalEffect(() => {
    const id = model.currentId.value;
    requestAnimationFrame(() =>
      box.current?.querySelector(`[data-measurement="${id}"]`)?.scrollIntoView({ block: "nearest" }),
    );
  });
  return (
    <nav class="passes" aria-label="Queue">
      <header class="passes__head">
        <h2>
          Review <span class="muted small">{counts ? `${counts.to_review} to review` : ""}</span>
        </h2>
        <div class="review__choose">
          <select
            class="input"
            aria-label="Show"
            value={model.shown.value}
            onChange={(event) => void model.show(event.currentTarget.value as Shown)}
          >
            {STATES.map((one) => (
              <option key={one.value} value={one.value}>
                {one.label}
              </option>
            ))}
          </select>
          {may("reviewer") && (
            <select
              class="input"
              aria-label="Click blind"
              title="Which measurements you click again before you see them"
              data-testid="blind-plan"
              value={model.oneIn.value}
              onChange={(event) => model.plan(Number(event.currentTarget.value))}
            >
              {plansWith(model.oneIn.value).map((oneIn) => (
                <option key={oneIn} value={oneIn}>
                  {planWords(oneIn)}
                </option>
              ))}
            </select>
          )}
        </div>
        {counts && (
          <p class="small muted" data-testid="review-counts">
            {counts.accepted} accepted, {counts.rejected} rejected of {counts.measurements}
          </p>
        )}
      </header>
      <ul class="passes__list" ref={box}>
        {items.map((item) => (
          <Row key={item.measurement.id} model={model} item={item} />
        ))}
        {model.more.value && (
          <li>
            <Button small kind="quiet" onClick={() => void model.loadMore()}>
              Show more
            </Button>
          </li>
        )}
      </ul>
    </nav>
  );
}

const PLANS = [1, 2, 5, 10, 20, 0];

function plansWith(oneIn: number): readonly number[] {
  return PLANS.includes(oneIn) ? PLANS : [oneIn, ...PLANS];
}

function planWords(oneIn: number): string {
  if (oneIn === 0) return "none blind";
  return oneIn === 1 ? "all blind" : `1 in ${oneIn} blind`;
}

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
        <strong class="pass__number">{String(item.vehicle.number).padStart(2, "0")}</strong>
        <span>{TARGET_WORDS[m.target]}</span>
        {item.mine ? (
          <span class="badge">mine</span>
        ) : (
          m.review.verdict !== "to_review" && <StateMark state={m.review.verdict} hideWord />
        )}
        <span class="pass__name">
          {model.isHidden(item)
            ? "click it again"
            : m.status === "ok"
              ? formatHeight(m.height_m, m.U95_height_m)
              : "not measurable"}
        </span>
      </button>
    </li>
  );
}
