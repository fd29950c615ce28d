/** The second click beside the first: before it, nothing is told; after it, how far apart they are. */
import { Button, Icon, StateMark } from "../../components";
import { me } from "../../core/session";
import type { Comparison, ReviewItem } from "../../core/types";
import { formatLength, formatSmall } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import type { ReviewModel } from "./model";

/** What may be known of a measurement that is to be clicked again: vehicle, target and frame. */
export function BlindPanel({ model, item }: { model: ReviewModel; item: ReviewItem }) {
  const m = item.measurement;
  return (
    <aside class="review__side" aria-label="Measurement" key={m.id} data-testid="blind-panel">
      <header class="vehicle__head">
        <h2>
          {String(item.vehicle.number).padStart(2, "0")} {TARGET_WORDS[m.target]}
        </h2>
        <StateMark state={m.review.verdict} />
      </header>
      <div class="review__body">
        <h3>Click it again first</h3>
        <p>
          {model.blind.contact.value
            ? "Now the target. Esc takes the contact back."
            : "Click the tyre's contact, then the target. The points and the height are shown afterwards, beside yours."}
        </p>
        <p class="small muted">
          Two clicks that do not know of each other tell how well people click. The queue's second list says
          how many measurements are clicked so.
        </p>
      </div>
      <footer class="review__verdict">
        <span data-testid="blind-show">
          <Button busy={model.blind.busy.value} onClick={() => model.reveal(m.id)}>
            Show without clicking
          </Button>
        </span>
      </footer>
    </aside>
  );
}

export function Comparisons({ model }: { model: ReviewModel }) {
  const found = model.comparisons.value ?? [];
  if (found.length === 0) return null;
  return (
    <section class="review__again" aria-label="Clicked again" data-testid="comparisons">
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
        <strong>{own ? "You" : (repeat.created_by?.name ?? "Somebody")}</strong> clicked it again:{" "}
        <span class="nowrap">{formatLength(repeat.height_m)}</span>
      </p>
      <p class="row small">
        <Icon name={one.agrees === null ? "info" : one.agrees ? "check" : "warning"} size={14} />
        <span class="grow">{comparisonWords(one)}</span>
        {own && (
          <Button small kind="quiet" onClick={() => void model.takeBack(repeat)}>
            Take it back
          </Button>
        )}
      </p>
    </div>
  );
}

/** "agree: 3 mm apart, expected within 9 mm"; the server says whether they do. */
function comparisonWords(one: Comparison): string {
  if (one.difference_m === null || one.expected_m === null) return one.reason ?? "not compared";
  const apart = formatSmall(Math.abs(one.difference_m));
  const expected = `expected within ${formatSmall(one.expected_m)}`;
  return one.agrees ? `agree: ${apart} apart, ${expected}` : `differ by ${apart}, ${expected}`;
}
