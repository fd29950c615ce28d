/** Where the person is: the address bar as signals. Links are plain `<a href>`; a click on one is taken here. */
import { computed, signal } from "@preact/signals";
import { match } from "./places";

const here = signal(location.pathname + location.search);

export const pathname = computed(() => here.value.split("?")[0] ?? "/");
export const query = computed(() => new URLSearchParams(here.value.split("?")[1] ?? ""));
export const current = computed(() => match(pathname.value));

/** The survey that the page is about: that of its path, or the one alone that a page of results is asked for; else 0. */
export const surveyHere = computed(() => {
  const here = current.value;
  if (!here || here.surveyId > 0) return here?.surveyId ?? 0;
  const asked = [...query.value.getAll("survey"), ...query.value.getAll("survey_id")];
  return asked.length === 1 && /^[1-9]\d{0,15}$/.test(asked[0] ?? "") ? Number(asked[0]) : 0;
});

/** Goes to a path of this app; `replace` leaves no step to go back to. */
export function navigate(to: string, options: { replace?: boolean } = {}): void {
  if (to === location.pathname + location.search) return;
  history[options.replace ? "replaceState" : "pushState"](null, "", to);
  const samePage = to.split("?")[0] === pathname.value;
  here.value = location.pathname + location.search;
  if (!samePage) document.getElementById("main")?.scrollTo(0, 0);
}

/** The number that the address gives for a thing; null where it names none, and NaN where what it says is no number. */
export function asked(name: string): number | null {
  const text = new URLSearchParams(location.search).get(name);
  return text === null ? null : /^\d+$/.test(text) ? Number(text) : Number.NaN;
}

type QueryChanges = Readonly<Record<string, string | number | readonly string[] | null | undefined>>;

/** An address with some values changed: a list stands for several of a name; null, nothing and an empty list remove it. */
export function changed(query: URLSearchParams, changes: QueryChanges): URLSearchParams {
  const next = new URLSearchParams(query);
  for (const [name, value] of Object.entries(changes)) {
    if (typeof value === "number" || (typeof value === "string" && value)) next.set(name, String(value));
    else {
      next.delete(name);
      for (const one of value || []) next.append(name, one);
    }
  }
  return next;
}

/** Changes query parameters in place, for deep links. */
export function setQuery(changes: QueryChanges): void {
  const text = changed(new URLSearchParams(location.search), changes).toString();
  navigate(location.pathname + (text ? `?${text}` : ""), { replace: true });
}

window.addEventListener("popstate", () => {
  here.value = location.pathname + location.search;
});

/** True for a click that should stay a click: a new tab, a download, another site, the API. */
export function isOurs(anchor: HTMLAnchorElement, event: MouseEvent): boolean {
  if (
    event.defaultPrevented ||
    event.button !== 0 ||
    event.metaKey ||
    event.ctrlKey ||
    event.shiftKey ||
    event.altKey
  )
    return false;
  if (anchor.target || anchor.hasAttribute("download") || anchor.origin !== location.origin) return false;
  if (anchor.hash && anchor.pathname === location.pathname) return false;
  return match(anchor.pathname) !== null;
}

document.addEventListener("click", (event) => {
  const anchor = event.target instanceof Element ? event.target.closest("a") : null;
  if (!anchor || !isOurs(anchor, event)) return;
  event.preventDefault();
  navigate(anchor.pathname + anchor.search);
});
