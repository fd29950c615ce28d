import { Button, Menu } from "../components";
import { keysShown } from "../components/KeysDialog.state";
import { hint } from "../keys";
import { current } from "../router";
import { saveState } from "../state/save";
import { may, me, signOut } from "../state/session";
import { survey } from "../state/survey";
import { type ThemeChoice, theme, themeChoice } from "../state/theme";
import { toastProblem } from "../state/toasts";
import { topTools } from "../state/topbar";
import { formatClock } from "../times";
import { ROLE_NAMES } from "../types";
import { type LengthUnit, lengthUnit } from "../units";
import { WORK } from "./work";

export function TopBar() {
  return (
    <header class="topbar">
      <Crumbs />
      <SaveWord />
      {topTools.value && <div class="topbar__tools">{topTools.value}</div>}
      <span class="topbar__rule" aria-hidden="true" />
      <Button
        kind="quiet"
        label={`Keys${hint("help")}`}
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

function Crumbs() {
  const here = current.value;
  const inSurvey = here !== null && here.surveyId > 0;
  return (
    <nav class="crumbs" aria-label="Where you are">
      <a class="topbar__mark" href="/">
        <Mark />
        Sightline
      </a>
      <ol>
        {inSurvey && (
          <li>
            <a class="clip" href={`/surveys/${here.surveyId}`}>
              {survey.value?.name ?? "Survey"}
            </a>
          </li>
        )}
        {here && here.route.name !== "surveys" && (
          <li>
            {inSurvey && here.route.layout === "full" ? (
              <WorkMenu surveyId={here.surveyId} name={here.route.name} title={here.route.title} />
            ) : (
              <span aria-current="page">{here.route.title}</span>
            )}
          </li>
        )}
      </ol>
    </nav>
  );
}

/** On the full-window screens the order of work hides in the last crumb. */
function WorkMenu({ surveyId, name, title }: { surveyId: number; name: string; title: string }) {
  return (
    <Menu
      left
      label={`${title}: go to another step`}
      button={
        <>
          <strong>{title}</strong>
          <Chevron />
        </>
      }
    >
      {WORK.map((entry) => (
        <a
          key={entry.name}
          class="menu__item"
          href={`/surveys/${surveyId}${entry.path}`}
          aria-current={entry.name === name ? "page" : undefined}
        >
          {entry.title}
        </a>
      ))}
    </Menu>
  );
}

function SaveWord() {
  const { pending, waiting, savedAt, failed } = saveState.value;
  const word =
    waiting > 0
      ? `${waiting} not yet saved`
      : pending > 0
        ? "saving…"
        : failed
          ? "last change not saved"
          : savedAt
            ? `saved ${formatClock(savedAt)}`
            : "";
  return (
    <span class="topbar__save" role="status" data-testid="save-state">
      {word}
    </span>
  );
}

const THEMES: { value: ThemeChoice; label: string }[] = [
  { value: "system", label: "System" },
  { value: "light", label: "Light" },
  { value: "dark", label: "Dark" },
];

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
      label={`${person.name}: account and settings`}
      button={<span class="avatar">{initials}</span>}
    >
      <div class="menu__head">
        <strong class="clip">{person.name}</strong>
        <span class="muted small">
          {ROLE_NAMES[person.role]} · Sightline {me.value?.version}
        </span>
      </div>
      <div class="menu__sep" />
      <a class="menu__item" href="/account">
        Account
      </a>
      {may("admin") && (
        <a class="menu__item" href="/people">
          People
        </a>
      )}
      <a class="menu__item" href="/audit">
        Audit trail
      </a>
      <div class="menu__sep" />
      <Choice
        label="Theme"
        value={themeChoice.value}
        options={THEMES}
        set={(v) => {
          themeChoice.value = v;
        }}
      />
      <Choice<LengthUnit>
        label="Lengths"
        value={lengthUnit.value}
        options={[
          { value: "m", label: "Metres" },
          { value: "ft", label: "Feet" },
        ]}
        set={(v) => {
          lengthUnit.value = v;
        }}
      />
      <div class="menu__sep" />
      <button type="button" class="menu__item" onClick={() => signOut().catch(toastProblem)}>
        Sign out
      </button>
    </Menu>
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  value: T;
  options: { value: T; label: string }[];
  set: (value: T) => void;
}

function Choice<T extends string>({ label, value, options, set }: ChoiceProps<T>) {
  return (
    <label class="menu__choice">
      {label}
      <select class="input" value={value} onChange={(event) => set(event.currentTarget.value as T)}>
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The mark: a road, a post, and the line of sight that meets its top. */
export function Mark({ size = 24 }: { size?: number }) {
  const ink = theme.value === "dark" ? "#ecece6" : "#1a1b18";
  return (
    <svg width={size} height={size} viewBox="0 0 24 24" fill="none" aria-hidden="true" stroke-linecap="round">
      <path d="M2 19.5h20" stroke={ink} stroke-width="2" />
      <path d="M16.5 19V11.5" stroke={ink} stroke-width="2" />
      <path d="M2.5 5.5l11.6 4.6" stroke={ink} stroke-width="1.6" stroke-dasharray="0.1 3.2" />
      <circle cx="16.5" cy="9.8" r="3" fill="var(--accent)" stroke={ink} stroke-width="1.6" />
    </svg>
  );
}

function Chevron() {
  return (
    <svg width="10" height="10" viewBox="0 0 10 10" fill="none" aria-hidden="true">
      <path d="M2 3.5l3 3 3-3" stroke="currentColor" stroke-width="1.5" />
    </svg>
  );
}
