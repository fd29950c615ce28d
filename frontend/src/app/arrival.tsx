/** Coming to another page: its title is announced and its heading gets the focus, so that nobody is left where the link was. */
import { useEffect, useRef, useState } from "preact/hooks";
import { current } from "../core/address";
import { say } from "../core/messages";
import { titleOf } from "../core/places";

export function Arrival() {
  const here = current.value;
  const [title, setTitle] = useState("");
  const loading = useRef(true);
  useEffect(() => {
    // the browser itself announces a page that it loads
    if (loading.current) {
      loading.current = false;
      return;
    }
    setTitle(here ? titleOf(here.place.name) : say("app-not-found"));
    const main = document.getElementById("main");
    return main ? focusHeading(main) : undefined;
  }, [here?.place.name, here?.surveyId]);
  return (
    <p class="visually-hidden" role="status" data-testid="arrival">
      {title}
    </p>
  );
}

/** The page's heading may come later than the page: until then the focus waits on `main`, unless the person moves it. */
function focusHeading(main: HTMLElement): () => void {
  main.focus({ preventScroll: true });
  const watch = new MutationObserver(() => settle());
  const settle = (): void => {
    const heading = main.querySelector("h1");
    const waits = document.activeElement === main;
    if (heading && waits) {
      heading.tabIndex = -1;
      heading.focus({ preventScroll: true });
    }
    if (heading || !waits) watch.disconnect();
  };
  watch.observe(main, { childList: true, subtree: true });
  settle();
  return () => watch.disconnect();
}
