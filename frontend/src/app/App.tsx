import { useEffect } from "preact/hooks";
import { AskDialog, Loading, Problem } from "../components";
import { late } from "../components/late";
import { Toasts } from "../components/Toasts";
import { current, navigate, pathname, surveyHere } from "../core/address";
import { useCommands } from "../core/commands";
import { language, say } from "../core/messages";
import { addressCalled, titleOf } from "../core/places";
import { loadSession, me, sessionProblem } from "../core/session";
import { loadSurvey, survey, surveyProblem } from "../core/survey";
import { Arrival } from "./arrival";
import { keysShown } from "./KeysDialog.state";
import "./kinds";
import { tour } from "../core/tour";
import { Offline } from "./Offline";
import { Rail } from "./Rail";
import { NotFound, Screen } from "./Screen";
import { TopBar } from "./TopBar";
import { Unsaved } from "./Unsaved";

const KeysDialog = late(async () => (await import("./KeysDialog")).default);
const Tour = late(async () => (await import("./Tour")).default);

export function App() {
  useEffect(() => {
    void loadSession();
  }, []);
  useCommands([
    {
      id: "help",
      run: () => {
        keysShown.value = true;
      },
    },
  ]);
  return (
    <>
      <Body />
      <Arrival />
      <AskDialog />
      {keysShown.value && <KeysDialog />}
      {tour.value && me.value && <Tour />}
      <Toasts />
    </>
  );
}

function Body() {
  const here = current.value;
  const person = me.value;
  const surveyId = here?.surveyId ?? 0;
  const beside = surveyHere.value;
  useEffect(() => {
    const page = here ? titleOf(here.place.name) : say("app-not-found");
    const name = beside ? survey.value?.name : undefined;
    document.title = name ? say("app-title-in-survey", { page, survey: name }) : say("app-title", { page });
  }, [here?.place.name, survey.value?.name, language.value]);
  useEffect(() => {
    if (person && beside) void loadSurvey(beside);
  }, [person?.person.id, beside, here?.place.name]);
  useEffect(() => {
    if (person === null && here?.place.name !== "sign-in") {
      const back = location.pathname + location.search;
      navigate(back === "/" ? "/sign-in" : `/sign-in?next=${encodeURIComponent(back)}`, { replace: true });
    }
  }, [person, here?.place.name]);

  if (here?.place.layout === "bare") return <Screen here={here} />;
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
        <Loading what={say("app-name")} />
      </>
    );
  }
  const full = here?.place.layout === "full";
  return (
    <div class="shell">
      <a class="skip btn" href="#main">
        {say("app-skip")}
      </a>
      {full && (
        <button type="button" class="skip btn" onClick={toPicture}>
          {say("app-skip-picture")}
        </button>
      )}
      <TopBar />
      <div class="over">
        <Offline />
        <Unsaved />
      </div>
      <main id="main" class={`main${full ? " main--full" : ""}`} tabIndex={-1}>
        {here === null ? (
          <Called />
        ) : surveyId && surveyProblem.value ? (
          <SurveyProblem id={surveyId} />
        ) : (
          <Laid />
        )}
      </main>
    </div>
  );
}

/** The picture takes its keys itself; the lists before it need not be gone through. */
function toPicture(): void {
  document.querySelector<HTMLElement>("#main [role=application]")?.focus();
}

function Laid() {
  const here = current.value;
  if (!here) return null;
  const railed = here.place.layout === "bench" || (here.place.layout === "alone" && surveyHere.value > 0);
  if (!railed) return <Screen here={here} />;
  return (
    <div class="bench">
      <Rail surveyId={surveyHere.value} name={here.place.name} />
      <Screen here={here} />
    </div>
  );
}

/** Where an address is no page's: the page that it names, if there is one. */
function Called() {
  const to = addressCalled(pathname.value);
  useEffect(() => {
    if (!to) return;
    const asked = location.search.slice(1);
    navigate(asked ? `${to}${to.includes("?") ? "&" : "?"}${asked}` : to, { replace: true });
  }, [to]);
  return to ? null : <NotFound />;
}

function SurveyProblem({ id }: { id: number }) {
  return (
    <div class="page">
      <Problem error={surveyProblem.value} again={() => void loadSurvey(id)} />
      <p>
        <a href="/">{say("app-to-surveys")}</a>
      </p>
    </div>
  );
}
