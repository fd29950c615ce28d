import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { speak } from "../../core/messages";
import { Traffic } from "./Traffic";

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("names the line scans that overlap, in which a vehicle counts twice", async () => {
  const note = {
    code: "scans-traffic-overlap",
    values: { earlier: "Gate", later: "Gate again", seconds: 1340, others: 0 },
    message: "",
  };
  new FakeServer().on("GET", /\/surveys\/1\/scan-traffic/, () => ({
    minutes: 5,
    length_limits_m: [5.2, 6.6, 11.6],
    scans: [],
    notes: [note],
  }));
  const filmed = { filmed_from: null, filmed_to: null, hour_from: null, hour_to: null };
  render(<Traffic surveyId={1} acceptedOnly filmed={filmed} />, document.body);
  const shown = () => document.querySelector("[data-testid=scan-traffic] .notice--warning")?.textContent;
  await vi.waitFor(() => expect(shown()).toContain("Gate and Gate again overlap for 1340"));
  await speak("fr");
  await vi.waitFor(() => expect(shown()).toContain("Gate et Gate again se chevauchent pendant 1340"));
  await speak("en");
});
