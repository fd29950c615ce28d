import { useEffect, useState } from "preact/hooks";
import { Empty, Loading, Notice } from "../components";
import type { Match } from "../core/places";
import { loadedScreen, loadScreen } from "./screens";

/** Loads a screen's code when it is first shown. */
export function Screen({ here }: { here: Match }) {
  const { place, surveyId } = here;
  const [, redraw] = useState(0);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    setFailed(false);
    if (loadedScreen(place.name)) return;
    let stale = false;
    loadScreen(place.name).then(
      () => !stale && redraw((n) => n + 1),
      (error) => {
        console.error(error);
        if (!stale) setFailed(true);
      },
    );
    return () => {
      stale = true;
    };
  }, [place.name]);
  const Shown = loadedScreen(place.name);
  if (Shown) return <Shown key={surveyId} surveyId={surveyId} />;
  if (failed) {
    return (
      <div class="page">
        <Notice kind="problem">
          This page could not be loaded, perhaps because a newer version was installed; reload it.
        </Notice>
      </div>
    );
  }
  return <Loading what={place.title.toLowerCase()} />;
}

export function NotFound() {
  return (
    <Empty title="There is nothing at this address" actions={<a href="/">Go to the surveys</a>}>
      <p>The link may be old, or the survey may have been removed.</p>
    </Empty>
  );
}
