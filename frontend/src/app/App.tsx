import { useEffect, useRef, useState } from "preact/hooks";
import { AskDialog, Icon, type IconName, Loading, Problem, StateMark } from "../components";
import { late } from "../components/late";
import { Toasts } from "../components/Toasts";
import { current, navigate, pathname, surveyHere } from "../core/address";
import { useCommands } from "../core/commands";
import { language, say } from "../core/messages";
import { addressCalled, addressOf, type PlaceName, titleOf } from "../core/places";
import { loadSession, me, sessionProblem } from "../core/session";
import { loadSurvey, survey, surveyProblem } from "../core/survey";
import { type EntryName, groupsOf, holds, stepState } from "../core/work";
import { keysShown } from "./KeysDialog.state";
import "./kinds";
import { tour } from "../core/tour";
import { Offline } from "./Offline";
import { Guarded, NotFound, Screen } from "./Screen";
import { TopBar } from "./TopBar";
import { Unsaved } from "./Unsaved";

const KeysDialog = late(async () => (await import("./KeysDialog")).default);
const Tour = late(async () => (await import("./Tour")).default);

export function App() {
  return (
    <Guarded>
      <Whole />
    </Guarded>
  );
}

function Whole() {
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

/** Coming to another page: its title is announced and its heading gets the focus, so that nobody is left where the link was. */
function Arrival() {
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

const ICONS: Record<EntryName, IconName> = {
  survey: "overview",
  planning: "search",
  camera: "camera",
  recordings: "film",
  pose: "road",
  measure: "ruler",
  scans: "scan",
  review: "review",
  checks: "check",
  statistics: "chart",
  export: "package",
  history: "audit",
  settings: "settings",
};

/** The pages of a survey beside the quiet screens, in groups: each step of the work with its state. */
function Rail({ surveyId, name }: { surveyId: number; name: PlaceName }) {
  return (
    <nav class="rail" aria-label={say("app-work")}>
      {groupsOf(survey.value, name).map((group) => (
        <section key={group.key} class={`rail__${group.key}`}>
          {group.key !== "overview" && group.key !== "aside" && (
            <h2 class="rail__group">{say(`rail-${group.key}`)}</h2>
          )}
          <ul>
            {group.entries.map((entry) => {
              const state = stepState(survey.value, entry.step);
              return (
                <li key={entry.name}>
                  <a
                    class="rail__item"
                    href={addressOf(entry.name, surveyId)}
                    aria-current={holds(entry, name) ? "page" : undefined}
                  >
                    <Icon name={ICONS[entry.name]} />
                    <span class="grow">{titleOf(entry.name)}</span>
                    {state && <StateMark state={state} hideWord />}
                  </a>
                </li>
              );
            })}
          </ul>
        </section>
      ))}
    </nav>
  );
}
