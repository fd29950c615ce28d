/** Wherever heights are shown stands how many are out of date, until they are computed again there. */
import { type ComponentChild, render } from "preact";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../testing/server";
import type { ReviewItem } from "../core/types";
import { OutOfDateNotice } from "../parts/again/OutOfDateNotice";
import ExportScreen from "../screens/export/ExportScreen";
import { MeasureModel } from "../screens/measure/model";
import { VehiclePanel } from "../screens/measure/VehiclePanel";
import { ReviewModel } from "../screens/review/model";
import { VerdictPanel } from "../screens/review/VerdictPanel";
import SightScreen from "../screens/sightdistance/SightScreen";
import StatisticsScreen from "../screens/statistics/StatisticsScreen";

const NONE = { heights: 0, in_line_scans: 0, waiting: 0, other_program: 0, causes: {}, measurements: {} };
const STALE = { ...NONE, heights: 2, causes: { side: 2 }, measurements: { 1: ["side"], 9: ["side"] } };
let server: FakeServer;
let found: typeof NONE;
const box = document.createElement("div");

function measured() {
  return server.save(1, {
    target: "driver_eye",
    frame: 40,
    contact: [100, 400],
    target_point: [101, 250],
    revision: 1,
    withdrawn: false,
    pose_id: 1,
    status: "ok",
    height_m: 1.2,
    U95_height_m: 0.03,
    created_at: "2026-11-26T10:00:00Z",
  });
}

async function measure(): Promise<ComponentChild> {
  const own = vehicle([measured()], { doubts: [] });
  const model = new MeasureModel(5);
  model.reel.recordings.value = [recording()];
  model.reading.put(own);
  model.open(own);
  return <VehiclePanel model={model} />;
}

async function review(): Promise<ComponentChild> {
  const judged = {
    blind: false,
    signs: [],
    error_m: null,
    U95_error_m: null,
    operator: null,
    clicked_at: "2026-11-26T10:00:00Z",
  };
  const item = { measurement: measured(), mine: false, vehicle: { number: 3 }, judged };
  server.on("GET", /\/review-queue/, () => [item]);
  server.on("GET", /\/review-plan$/, () => ({ blind_one_in: 0, version: 0 }));
  server.on("GET", /\/recordings$/, () => [recording()]);
  history.replaceState(null, "", "/surveys/5/review");
  const model = new ReviewModel(5);
  await model.load();
  return <VerdictPanel model={model} item={item as unknown as ReviewItem} />;
}

function ofSurvey(page: ComponentChild): ComponentChild {
  history.replaceState(null, "", "/page?survey=5");
  dispatchEvent(new PopStateEvent("popstate"));
  return page;
}

const PAGES: Readonly<Record<string, () => ComponentChild | Promise<ComponentChild>>> = {
  measure,
  review,
  statistics: () => ofSurvey(<StatisticsScreen />),
  "sight distance": () => ofSurvey(<SightScreen surveyId={5} />),
  export: () => <ExportScreen surveyId={5} />,
};

const notice = () => box.querySelector('[data-testid="out-of-date"]');
const marks = () => box.querySelectorAll('[data-testid="out-of-date-mark"]').length;

beforeEach(() => {
  found = STALE as unknown as typeof NONE;
  server = new FakeServer();
  server.on("GET", /^\/surveys\/5\/computings$/, () => ({ out_of_date: found, computings: [] }));
  server.on("GET", /^\/measurements\/1\/history$/, () => ({ revisions: [], reviews: [] }));
  for (const path of [/^\/statistics\?/, /^\/sightdistance\?/, /\/lots\/summary$/, /\/conclusion\?/])
    server.on("GET", path, () => {
      throw 404;
    });
  server.on("POST", /^\/surveys\/5\/computings$/, () => {
    found = NONE;
    return { id: 3, state: "queued", progress: 0 };
  });
  server.on("GET", /^\/jobs\/3/, () => ({ id: 3, state: "done", progress: 1, result: { heights: 2 } }));
  document.body.append(box);
});

afterEach(() => {
  render(null, box);
  box.remove();
  vi.unstubAllGlobals();
});

describe.each(Object.keys(PAGES))("heights that are out of date, on the page %s", (name) => {
  it("are counted, and no longer once they are computed again", async () => {
    render(await PAGES[name]?.(), box);
    await vi.waitFor(() => expect(notice()?.textContent).toMatch(/^2 heights are out of date/));
    if (name === "measure" || name === "review") await vi.waitFor(() => expect(marks()).toBe(1));
    const button = notice()?.closest(".notice")?.querySelector("button");
    button?.click();
    await vi.waitFor(() => expect(notice()).toBeNull());
    expect(server.writes).toContain("POST /surveys/5/computings");
    await vi.waitFor(() => expect(marks()).toBe(0));
  });
});

it("says where it cannot be told whether heights are out of date", async () => {
  server.on("GET", /^\/surveys\/6\/computings$/, () => {
    throw 400;
  });
  render(<OutOfDateNotice surveyId={6} />, box);
  await vi.waitFor(() => expect(box.textContent).toContain("(status 400)"));
});
