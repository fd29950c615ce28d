/** Pages that share one entry of the rail: their names and addresses, in order. */
import { query } from "./address";
import { say } from "./messages";
import { type PlaceName, titleOf } from "./places";
import { survey } from "./survey";

export type PageTab = ReturnType<typeof reviewTabs>[number];

/** Review: the queue, lots, and the same heights clicked again. */
export function reviewTabs(surveyId: number, here: PlaceName) {
  const at = `/surveys/${surveyId}`;
  return [
    { href: `${at}/review`, word: say("review-queue-tab"), here: here === "review" },
    { href: `${at}/lots`, word: titleOf("lots"), here: here === "lots" },
    { href: `${at}/repeats/click`, word: titleOf("click-again"), here: here === "click-again" },
  ];
}

export const CHECKS = ["insets", "traffic", "adjust", "again"] as const;
export type Check = (typeof CHECKS)[number];

/** Checks: heights computed again are listed once they are asked for; notices lead there. */
export function checksTabs(surveyId: number, here: Check | "repeats"): PageTab[] {
  const at = `/surveys/${surveyId}`;
  const tabs: PageTab[] = [
    { href: `${at}/checks`, word: say("checks-insets"), here: here === "insets" },
    { href: `${at}/checks?tab=traffic`, word: say("checks-direction"), here: here === "traffic" },
    { href: `${at}/checks?tab=adjust`, word: say("adjust-tab"), here: here === "adjust" },
    { href: `${at}/repeats`, word: titleOf("repeats"), here: here === "repeats" },
  ];
  if (here === "again") tabs.push({ href: `${at}/checks?tab=again`, word: say("checks-again"), here: true });
  return tabs;
}

/** Results of the surveys that the address names; motion where one survey has line scans. */
export function resultsTabs(here: "heights" | "errors" | "sight-distance" | "scan-results"): PageTab[] {
  const inSurvey = survey.value !== null && here === "scan-results" ? [String(survey.value.id)] : null;
  const surveys = inSurvey ?? query.value.getAll("survey");
  const of = (kept: URLSearchParams) => (kept.size > 0 ? `?${kept}` : "");
  const bare = new URLSearchParams(surveys.map((id) => ["survey", id]));
  const filtered = here === "heights" || here === "errors" ? new URLSearchParams(query.value) : bare;
  const errors = new URLSearchParams(filtered);
  filtered.delete("tab");
  errors.set("tab", "errors");
  const tabs: PageTab[] = [
    { href: `/statistics${of(filtered)}`, word: say("results-heights"), here: here === "heights" },
    { href: `/statistics${of(errors)}`, word: say("results-errors"), here: here === "errors" },
    { href: `/sight-distance${of(bare)}`, word: titleOf("sight-distance"), here: here === "sight-distance" },
  ];
  const only = surveys.length === 1 ? Number(surveys[0]) : 0;
  const scanned = survey.value?.id === only && survey.value.scans.state !== "none";
  if (scanned || here === "scan-results")
    tabs.push({
      href: `/surveys/${only}/scans/results`,
      word: titleOf("scan-results"),
      here: here === "scan-results",
    });
  return tabs;
}
