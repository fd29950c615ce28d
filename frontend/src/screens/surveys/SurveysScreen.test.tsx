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
