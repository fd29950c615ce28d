/** What the page asks of the server when it opens: each thing once. */
import { type ComponentChild, render } from "preact";
import { useEffect } from "preact/hooks";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { FakeServer, recording, vehicle } from "../../../testing/server";
import { refreshSurvey, survey } from "../../core/survey";
import type { Survey } from "../../core/types";
import { OutOfDateNotice } from "../../parts/again/OutOfDateNotice";
import { MeasureModel } from "./model";
import { PassList } from "./PassList";

let server: FakeServer;
let model: MeasureModel;
let asked: string[];
const OF_SURVEY = { id: 5, counts: {}, steps: [] } as unknown as Survey;

function counted(path: RegExp, answer: () => unknown): void {
  server.on("GET", path, (match) => {
    asked.push(match[0]);
    return answer();
  });
}

beforeEach(async () => {
  asked = [];
  server = new FakeServer();
  server.on("GET", /^\/recordings\/1$/, () => recording());
  server.on("GET", /^\/surveys\/5\/recordings$/, () => [recording()]);
  server.on("GET", /^\/surveys\/5\/vehicles$/, () => [vehicle([], { doubts: [] })]);
  server.on("GET", /^\/surveys\/5$/, () => ({ ...OF_SURVEY }));
  const quota = { lighting: "daylight", class_set: null, measured: 3, wanted: 40 };
  counted(/\/sample$/, () => ({ quotas: [quota], response: [] }));
  const out_of_date = { heights: 2, causes: { side: 2 }, measurements: {} };
  counted(/\/computings$/, () => ({ out_of_date, computings: [] }));
  history.replaceState(null, "", "/surveys/5/measure");
  model = new MeasureModel(5);
});

afterEach(() => {
  render(null, document.body);
  model.close();
  survey.value = null;
  vi.unstubAllGlobals();
});

/** Shows something and waits until its effects have run, and those of `so`. */
async function shown(what: ComponentChild, so: () => boolean = () => true): Promise<void> {
  let ran = false;
  const Last = () => {
    const holds = so();
    useEffect(() => {
      ran ||= holds;
    });
    return null;
  };
  render([what, <Last key="last" />], document.body);
  await vi.waitFor(() => expect(ran).toBe(true));
}

it("asks for the sample once, when the passes are there, and again when one became another", async () => {
  await shown(<PassList key="list" model={model} />);
  expect(asked).toEqual([]);
  await model.load();
  await vi.waitFor(() => expect(document.querySelector('[data-testid="quotas"]')).not.toBeNull());
  expect(asked).toEqual(["/sample"]);
  model.vehicles.take(vehicle([], { doubts: [], state: "accepted", version: 2 }));
  await vi.waitFor(() => expect(asked).toEqual(["/sample", "/sample"]));
});

it("asks what is out of date once, however late the survey comes, and again when it is read again", async () => {
  const all = shown(<OutOfDateNotice key="notice" surveyId={5} />, () => survey.value !== null);
  await vi.waitFor(() => expect(document.querySelector('[data-testid="out-of-date"]')).not.toBeNull());
  survey.value = OF_SURVEY;
  await all;
  expect(asked).toEqual(["/computings"]);
  await refreshSurvey();
  await vi.waitFor(() => expect(asked).toEqual(["/computings", "/computings"]));
});
