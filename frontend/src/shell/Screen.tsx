import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import { Empty, Loading, Notice } from "../components";
import type { Match, Route, ScreenProps } from "../router";

const loaded = new Map<string, ComponentType<ScreenProps>>();

/** Loads a screen's code when it is first shown. */
export function Screen({ here }: { here: Match }) {
  const { route, surveyId } = here;
  const [, redraw] = useState(0);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    setFailed(false);
    if (loaded.has(route.name)) return;
    let stale = false;
    loadScreen(route).then(
      () => !stale && redraw((n) => n + 1),
      (error) => {
        console.error(error);
        if (!stale) setFailed(true);
      },
    );
    return () => {
      stale = true;
    };
  }, [route.name]);
  const Shown = loaded.get(route.name);
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
  return <Loading what={route.title.toLowerCase()} />;
}

async function loadScreen(route: Route): Promise<void> {
  loaded.set(route.name, (await route.load()).default);
}

export function NotFound() {
  return (
    <Empty title="There is nothing at this address" actions={<a href="/">Go to the surveys</a>}>
      <p>The link may be old, or the survey may have been removed.</p>
    </Empty>
  );
}
