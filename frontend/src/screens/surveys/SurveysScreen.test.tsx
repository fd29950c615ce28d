import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import type { Survey } from "../../core/types";
import { SurveyCard } from "./SurveysScreen";

afterEach(() => render(null, document.body));

it("says which heights its tally is of where those of line scans are among them", () => {
  const told = (heights_accepted: number) => {
    const counts = {
      recordings: 2,
      vehicles: 20,
      vehicles_measured: 20,
      accepted: 42 + heights_accepted,
      rejected: 0,
      to_review: 15,
    };
    const none = { scans: 0, accepted: 0, rejected: 0, to_review: 0, summary: [], state: "done" };
    const scans = { ...none, heights_to_review: 0, heights_rejected: 0, heights_accepted };
    const survey = { id: 1, name: "Rouen", created_at: "2026-05-03T08:10:00Z", steps: [], counts, scans };
    render(<SurveyCard survey={survey as unknown as Survey} />, document.body);
    return document.querySelectorAll(".progress__words")[1]?.textContent;
  };
  expect(told(0)).toMatch(/^Heights reviewed\D*42\D+57/);
  expect(told(2)).toMatch(/^Heights reviewed \(frames and line scans\)\D*44\D+59/);
});

it("shows no bar where nothing is done, and a full one only where all is", () => {
  const told = (vehicles_measured: number) => {
    const counts = {
      recordings: 1,
      vehicles: 300,
      vehicles_measured,
      accepted: 0,
      rejected: 0,
      to_review: 0,
    };
    const scans = { scans: 0, heights_to_review: 0, heights_rejected: 0, heights_accepted: 0 };
    const survey = { id: 1, name: "Rouen", created_at: "2026-05-03T08:10:00Z", steps: [], counts, scans };
    render(<SurveyCard survey={survey as unknown as Survey} />, document.body);
    const track = document.querySelector('[role="progressbar"]');
    const bar = track?.querySelector<HTMLElement>(".progress__bar");
    return [track?.getAttribute("aria-valuenow"), bar ? Number.parseFloat(bar.style.width) : null];
  };
  expect(told(0)).toEqual(["0", null]);
  expect(told(1)[1]).toBeCloseTo(0.333, 3);
  expect(told(299)[0]).toBe("99");
  expect(told(299)[1]).toBeCloseTo(99.667, 3);
  expect(told(300)).toEqual(["100", 100]);
});
