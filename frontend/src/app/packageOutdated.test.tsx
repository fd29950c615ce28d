/** A package that lacks heights says so: at the step of the overview, and in its row of the list. */
import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../testing/server";
import { me } from "../core/session";
import { survey } from "../core/survey";
import type { Survey } from "../core/types";
import ExportScreen from "../screens/export/ExportScreen";
import SurveyScreen from "../screens/survey/SurveyScreen";

const NOTHING = { heights: 0, reviews: 0, other: 0 };
const SEVEN = { heights: 7, reviews: 0, other: 0 };
const box = document.createElement("div");
let server: FakeServer;

const said = (): (string | undefined)[] =>
  [...box.querySelectorAll('[data-testid="package-outdated"]')].map((one) => one.textContent?.trim());

function open(since: Survey["since_package"]): void {
  survey.value = {
    id: 5,
    name: "Rouen south",
    place: {},
    traffic: {},
    asked: { daytime: [], low_light: [] },
    counts: { vehicles: 1 },
    sampling: { method: "every", step: 1, quotas: [] },
    steps: [
      {
        key: "results",
        state: since ? "begun" : "waiting",
        summary: [{ code: "overview-packages", values: { count: 1 } }],
      },
    ],
    scans: { state: "none", summary: [], scans: 0 },
    since_package: since,
  } as unknown as Survey;
}

beforeEach(() => {
  server = new FakeServer("viewer");
  const none = { heights: 0, in_line_scans: 0, waiting: 0, other_program: 0, causes: {}, measurements: {} };
  server.on("GET", /\/computings$/, () => ({ out_of_date: none, computings: [] }));
  server.on("GET", /^\/jobs/, () => []);
  server.on("GET", /\/(photographs|sample|lots\/summary)/, () => {
    throw 404;
  });
  server.on("GET", /^\/surveys\/5$/, () => survey.value);
  document.body.append(box);
});

afterEach(() => {
  render(null, box);
  box.remove();
  survey.value = null;
  vi.unstubAllGlobals();
});

it.each([
  [null, []],
  [NOTHING, []],
  [SEVEN, ["Outdated, 7 heights since"]],
  [{ heights: 1, reviews: 2, other: 3 }, ["Outdated, 1 height, 2 verdicts and 3 other changes since"]],
])("the step of the overview: %o", async (since, words) => {
  open(since);
  render(<SurveyScreen surveyId={5} />, box);
  await vi.waitFor(() => expect(box.textContent).toContain("1 package built."));
  expect(said()).toEqual(words);
});

const entry = (id: number, since: typeof NOTHING) => ({
  id,
  since,
  created_at: "2026-11-26T10:00:00Z",
  created_by: null,
  size_bytes: 9,
  sha256: "a".repeat(64),
  audit_head: "b".repeat(64),
  selection: {
    lighting: null,
    class_sets: [],
    categories: [],
    filmed_from: null,
    filmed_to: null,
    hour_from: null,
    hour_to: null,
  },
  language: "en",
  signing_key: "c".repeat(64),
  url: `/api/exports/${id}.zip`,
  filename: "a.zip",
});

it("each package of the list says what it lacks itself", async () => {
  server.on("GET", /\/exports$/, () => [entry(2, NOTHING), entry(1, SEVEN)]);
  render(<ExportScreen surveyId={5} />, box);
  await vi.waitFor(() => expect(said()).toEqual(["Outdated, 7 heights since"]));
  const rows = [...box.querySelectorAll("table")][0]?.querySelectorAll("tbody tr");
  expect(rows?.[1]?.querySelector('[data-testid="package-outdated"]')).not.toBeNull();
});

it.each([
  ["2026-05-01", "2026-05-04", "filmed in the nights that begin on 2026-05-01 to 2026-05-04, 22:00 to 06:00"],
  ["2026-05-04", "2026-05-04", "filmed in the night that begins on 2026-05-04, 22:00 to 06:00"],
  ["2026-05-01", null, "filmed in the nights that begin on 2026-05-01 or later, 22:00 to 06:00"],
  [null, "2026-05-04", "filmed in the nights that begin on 2026-05-04 or earlier, 22:00 to 06:00"],
  [null, null, "filmed between 22:00 and 06:00"],
])("nights from %s to %s are said to be of the day on which they begin", async (from, to, words) => {
  const night = {
    ...entry(1, NOTHING).selection,
    filmed_from: from,
    filmed_to: to,
    hour_from: 22,
    hour_to: 6,
  };
  server.on("GET", /\/exports$/, () => [{ ...entry(1, NOTHING), selection: night }]);
  render(<ExportScreen surveyId={5} />, box);
  await vi.waitFor(() => expect(box.querySelectorAll("tbody td")[1]?.textContent).toBe(words));
});

it("the list is read again once heights were computed on the page", async () => {
  let since = NOTHING;
  server.on("GET", /\/exports$/, () => [entry(1, since)]);
  const old = { heights: 7, in_line_scans: 0, waiting: 0, other_program: 0, causes: {}, measurements: {} };
  server.on("GET", /\/computings$/, () => ({ out_of_date: old, computings: [] }));
  server.on("POST", /\/computings$/, () => ({ id: 9, state: "done" }));
  server.on("GET", /^\/jobs\/9$/, () => ({ id: 9, state: "done" }));
  me.value = { person: { id: 1, role: "operator" } } as never;
  survey.value = { id: 5, my_role: "operator", counts: { to_review: 0, rejected: 0 }, steps: [] } as never;
  render(<ExportScreen surveyId={5} />, box);
  const button = () =>
    [...box.querySelectorAll("button")].find((one) => one.textContent?.includes("Compute"));
  await vi.waitFor(() => expect(button()).toBeDefined());
  expect(said()).toEqual([]);
  since = SEVEN;
  button()?.click();
  await vi.waitFor(() => expect(said()).toEqual(["Outdated, 7 heights since"]));
});
