import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import { AskDialog, Loading, Problem } from "./components";
import { keysShown } from "./components/KeysDialog.state";
import { Toasts } from "./components/Toasts";
import { useKeys } from "./keys";
import { current, navigate } from "./router";
import { Offline } from "./shell/Offline";
import { Rail } from "./shell/Rail";
import { NotFound, Screen } from "./shell/Screen";
import { TopBar } from "./shell/TopBar";
import { loadSession, me, sessionProblem } from "./state/session";
import { loadSurvey, survey, surveyProblem } from "./state/survey";

export function App() {
  useEffect(() => {
    void loadSession();
  }, []);
  useKeys({
    help: () => {
      keysShown.value = true;
    },
  });
  return (
    <>
      <Body />
      <AskDialog />
      {keysShown.value && <Keys />}
      <Toasts />
    </>
  );
}

function Body() {
  const here = current.value;
  const person = me.value;
  const surveyId = here?.surveyId ?? 0;
  useEffect(() => {
    const place = here?.route.title ?? "Not found";
    const name = surveyId && survey.value ? ` – ${survey.value.name}` : "";
    document.title = `${place}${name} – Sightline`;
  }, [here?.route.name, survey.value?.name]);
  useEffect(() => {
    if (person && surveyId) void loadSurvey(surveyId);
  }, [person?.person.id, surveyId, here?.route.name]);
  useEffect(() => {
    if (person === null && here?.route.name !== "sign-in") {
      const back = location.pathname + location.search;
      navigate(back === "/" ? "/sign-in" : `/sign-in?next=${encodeURIComponent(back)}`, { replace: true });
    }
  }, [person, here?.route.name]);

  if (here?.route.layout === "bare") return <Screen here={here} />;
  if (sessionProblem.value) {
    return (
      <div class="page page--alone">
        <Problem error={sessionProblem.value} again={() => void loadSession()} />
      </div>
    );
  }
  if (!person) {
    return (
      <>
        <Offline />
        <Loading what="Sightline" />
      </>
    );
  }
  const full = here?.route.layout === "full";
  return (
    <div class="shell">
      <a class="skip btn" href="#main">
        Skip to the page
      </a>
      <TopBar />
      <Offline />
      <main id="main" class={`main${full ? " main--full" : ""}`} tabIndex={-1}>
        {here === null ? (
          <NotFound />
        ) : surveyId && surveyProblem.value ? (
          <SurveyProblem id={surveyId} />
        ) : (
          <Laid />
        )}
      </main>
    </div>
  );
}

function Laid() {
  const here = current.value;
  if (!here) return null;
  if (here.route.layout !== "bench") return <Screen here={here} />;
  return (
    <div class="bench">
      <Rail surveyId={here.surveyId} name={here.route.name} />
      <Screen here={here} />
    </div>
  );
}

function SurveyProblem({ id }: { id: number }) {
  return (
    <div class="page">
      <Problem error={surveyProblem.value} again={() => void loadSurvey(id)} />
      <p>
        <a href="/">Go to the surveys</a>
      </p>
    </div>
  );
}

/** The key map's code comes when it is first asked for. */
function Keys() {
  const [Shown, setShown] = useState<ComponentType | null>(null);
  useEffect(() => {
    void import("./components/KeysDialog").then((module) => setShown(() => module.default));
  }, []);
  return Shown && <Shown />;
}
