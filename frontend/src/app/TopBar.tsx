import { Fragment } from "preact";
import { Button, choices, LanguageChoice, Mark, Menu, Select } from "../components";
import { current, surveyHere } from "../core/address";
import { hint } from "../core/commands";
import { held } from "../core/form";
import { say, wordsOf } from "../core/messages";
import { outbox } from "../core/outbox";
import { addressOf, guideAddress, type PlaceName, titleOf } from "../core/places";
import { saveState } from "../core/save";
import { me, signOut } from "../core/session";
import { survey } from "../core/survey";
import { themeChoice } from "../core/theme";
import { formatClock } from "../core/times";
import { toastProblem } from "../core/toasts";
import { topTools } from "../core/topbar";
import { beginTour } from "../core/tour";
import { ROLE_NAMES } from "../core/types";
import { lengthUnit } from "../core/units";
import { groupsOf, holds } from "../core/work";
import { keysShown } from "./KeysDialog.state";

export function TopBar() {
  const { name, guide } = current.value?.place ?? { name: "surveys", guide: "first-survey" };
  return (
    <header class="row topbar">
      <Pages />
      <Crumbs />
      <SaveWord />
      {topTools.value && <div class="row row--near">{topTools.value}</div>}
      <span class="topbar__rule" aria-hidden="true" />
      <Button says="page-guide" kind="quiet" beside={name !== "guide"} href={guideAddress(guide)} />
      <Button
        kind="quiet"
        label={say("app-keys") + hint("help")}
        onClick={() => {
          keysShown.value = true;
        }}
        class="btn--icon"
      >
        ?
      </Button>
      <PersonMenu />
    </header>
  );
}

/** Pages that the bar names already. */
const LISTED: readonly PlaceName[] = ["surveys", "studies", "catalogue"];
const ADMIN: readonly PlaceName[] = ["people", "jobs", "system", "audit"];

/** Where everything lies that is not one survey's; few pixels leave it a menu. */
function Pages() {
  const place = current.value?.place.name;
  const admin = me.value?.person.role === "admin";
  const pages = [
    { name: "surveys", href: "/" },
    { name: "studies", href: "/studies" },
    { name: "catalogue", href: "/catalogue" },
  ] as const;
  const items = (names: readonly { name: PlaceName; href: string }[]) =>
    names.map(({ name, href }) => (
      <a key={name} class="row menu__item" href={href} aria-current={name === place ? "page" : undefined}>
        {titleOf(name)}
      </a>
    ));
  const hidden: readonly PlaceName[] = admin ? [] : ["people", "system"];
  const behind = items(
    ADMIN.filter((name) => !hidden.includes(name)).map((name) => ({ name, href: `/${name}` })),
  );
  return (
    <nav class="topbar__pages" aria-label={say("app-pages")}>
      <a class="topbar__mark" href="/" aria-label={say("app-name")}>
        <Mark />
        <span class="topbar__name">{say("app-name")}</span>
      </a>
      <div class="topbar__wide">
        {pages.map(({ name, href }) => (
          <a key={name} href={href} aria-current={name === place ? "page" : undefined}>
            {titleOf(name)}
          </a>
        ))}
        <Menu
          left
          class="topbar__more"
          label={say("app-admin")}
          button={
            <>
              {say("app-admin")} <Chevron />
            </>
          }
        >
          {behind}
        </Menu>
      </div>
      <div class="topbar__narrow">
        <Menu left class="topbar__more" label={say("app-pages")} button={<Chevron />}>
          {items(pages)}
          <div class="menu__sep" />
          {behind}
        </Menu>
      </div>
    </nav>
  );
}

function Crumbs() {
  const here = current.value;
  const surveyId = surveyHere.value;
  const inSurvey = surveyId > 0;
  return (
    <nav class="row grow crumbs" aria-label={say("app-where")}>
      <ol class="row row--near">
        {inSurvey && (
          <li class="row row--near">
            <a class="clip" href={`/surveys/${surveyId}`}>
              {survey.value?.name ?? say("app-survey")}
            </a>
          </li>
        )}
        {here && !LISTED.includes(here.place.name) && (
          <li class="row row--near">
            {inSurvey && (
              <div class={here.place.layout === "full" ? undefined : "crumbs__menu"}>
                <WorkMenu surveyId={surveyId} name={here.place.name} title={titleOf(here.place.name)} />
              </div>
            )}
            {!(inSurvey && here.place.layout === "full") && (
              <span aria-current="page" class={inSurvey ? "crumbs__page" : undefined}>
                {titleOf(here.place.name)}
              </span>
            )}
          </li>
        )}
      </ol>
    </nav>
  );
}

/** Where the rail has no room, the order of work hides in the last crumb. */
function WorkMenu({ surveyId, name, title }: { surveyId: number; name: PlaceName; title: string }) {
  return (
    <Menu
      left
      label={say("app-other-step", { page: title })}
      button={
        <>
          <strong>{title}</strong>
          <Chevron />
        </>
      }
    >
      {groupsOf(survey.value, name).map((group, n) => (
        <Fragment key={group.key}>
          {n > 0 && <div class="menu__sep" />}
          {group.entries.map((entry) => (
            <a
              key={entry.name}
              class="row menu__item"
              href={addressOf(entry.name, surveyId)}
              aria-current={holds(entry, name) ? "page" : undefined}
            >
              {titleOf(entry.name)}
            </a>
          ))}
        </Fragment>
      ))}
    </Menu>
  );
}

export function SaveWord() {
  const { pending, waiting, savedAt, failed } = saveState.value;
  const { queued, resting } = outbox.counts.value;
  const word =
    waiting > 0
      ? say("save-waiting", { count: waiting + queued + resting })
      : pending + queued > 0
        ? say("save-pending")
        : failed
          ? say("save-failed")
          : resting > 0
            ? say("save-waiting", { count: resting })
            : savedAt
              ? say("save-done", { time: formatClock(savedAt) })
              : "";
  return (
    <span class="muted small nowrap" role="status" data-testid="save-state">
      {word}
    </span>
  );
}

function PersonMenu() {
  const person = me.value?.person;
  if (!person) return null;
  const initials = person.name
    .split(/\s+/)
    .map((part) => part[0] ?? "")
    .join("")
    .slice(0, 2)
    .toUpperCase();
  return (
    <Menu
      class="topbar__person"
      label={say("menu-person", { person: person.name })}
      button={<span class="avatar">{initials}</span>}
    >
      <div class="menu__head">
        <strong class="clip">{person.name}</strong>
        <span class="muted small">
          {say("menu-role", { role: ROLE_NAMES[person.role], version: me.value?.version ?? "" })}
        </span>
      </div>
      <div class="menu__sep" />
      <a class="row menu__item" href="/account">
        {titleOf("account")}
      </a>
      <div class="menu__sep" />
      <label class="menu__choice">
        {say("menu-theme")}
        <Select options={choices(wordsOf("menu-theme-", "system", "light", "dark"))} {...held(themeChoice)} />
      </label>
      <label class="menu__choice">
        {say("menu-lengths")}
        <Select options={choices(wordsOf("menu-lengths-", "m", "ft"))} {...held(lengthUnit)} />
      </label>
      <LanguageChoice class="menu__choice" />
      <div class="menu__sep" />
      <button type="button" class="row menu__item" onClick={() => beginTour().catch(toastProblem)}>
        {say("tour-title")}
      </button>
      <button type="button" class="row menu__item" onClick={() => signOut().catch(toastProblem)}>
        {say("menu-sign-out")}
      </button>
    </Menu>
  );
}

function Chevron() {
  return (
    <svg width="10" height="10" viewBox="0 0 10 10" fill="none" aria-hidden="true">
      <path d="M2 3.5l3 3 3-3" stroke="currentColor" stroke-width="1.5" />
    </svg>
  );
}
