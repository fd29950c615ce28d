import type { ComponentChildren } from "preact";
import { useEffect, useErrorBoundary, useState } from "preact/hooks";
import { Empty, Loading, Notice, Problem } from "../components";
import { say } from "../core/messages";
import { type Match, titleOf } from "../core/places";
import { loadedScreen, loadScreen } from "./screens";

export function Screen({ here }: { here: Match }) {
  const { place, surveyId } = here;
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    setFailed(false);
    if (loadedScreen(place.name)) return;
    let stale = false;
    loadScreen(place.name).catch((error) => {
      console.error(error);
      if (!stale) setFailed(true);
    });
    return () => {
      stale = true;
    };
  }, [place.name]);
  const Shown = loadedScreen(place.name);
  if (Shown) {
    return (
      <Guarded key={`${place.name} ${surveyId}`}>
        <Shown surveyId={surveyId} />
      </Guarded>
    );
  }
  if (failed) {
    return (
      <div class="page">
        <Notice kind="problem">{say("app-not-loaded")}</Notice>
      </div>
    );
  }
  return <Loading what={titleOf(place.name)} />;
}

/** What breaks in it says so in one sentence, and what is beside it goes on working. Without one around it, Preact would
 *  try to render it for ever: its effects have not run, and ask for it anew at each try. */
export function Guarded({ children }: { children: ComponentChildren }) {
  const [error, tryAgain] = useErrorBoundary();
  if (!error) return children;
  return (
    <div class="page">
      <Problem error={error} again={tryAgain} />
    </div>
  );
}

export function NotFound() {
  return (
    <Empty
      says="app-nothing-here-title"
      why="app-nothing-here"
      actions={<a href="/">{say("app-to-surveys")}</a>}
    />
  );
}
