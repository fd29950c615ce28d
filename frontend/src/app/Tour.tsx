import { useEffect, useRef } from "preact/hooks";
import { Button } from "../components";
import { say } from "../core/messages";
import { titleOf } from "../core/places";
import { endTour, stepTour, TOUR, tour } from "../core/tour";
import "./tour.css";

/** Beside the page that it speaks of: what the page is for, and on to the next. The page itself can be used meanwhile. */
export default function Tour() {
  const at = tour.value;
  const words = useRef<HTMLHeadingElement>(null);
  const name = at && TOUR[at.step];
  // after the page's own heading has had the focus: whoever takes the tour stays in it, and it is read out
  useEffect(() => {
    words.current?.focus({ preventScroll: true });
  }, [at?.step]);
  if (!at || !name) return null;
  const last = at.step === TOUR.length - 1;
  return (
    <aside
      class="tour"
      aria-labelledby="tour-head"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        endTour();
      }}
    >
      <h2 id="tour-head" class="tour__head" tabIndex={-1} ref={words} aria-describedby="tour-words">
        {say("tour-step", { step: at.step + 1, of: TOUR.length, page: titleOf(name) })}
      </h2>
      <p id="tour-words">{say(`tour-${name}`)}</p>
      <div class="row tour__foot">
        {!last && <Button says="tour-skip" kind="quiet" small onClick={endTour} />}
        <span class="grow" />
        {at.step > 0 && <Button says="tour-back" small onClick={() => stepTour(-1)} />}
        <Button
          says={last ? "tour-end" : "tour-next"}
          kind="primary"
          small
          onClick={() => (last ? endTour() : stepTour(1))}
        />
      </div>
    </aside>
  );
}
