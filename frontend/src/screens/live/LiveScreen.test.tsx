import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import { learn, speak } from "../../core/messages";
import { survey } from "../../core/survey";
import type { LiveStream, Survey } from "../../core/types";
import { clockThere, momentThere, Stream } from "./LiveScreen";

afterEach(() => {
  survey.value = null;
});

it.each([
  ["Asia/Tokyo", "02:30:05", "4 May 2026, 02:30:05"],
  ["America/Lima", "12:30:05", "3 May 2026, 12:30:05"],
])("tells the time of day by the clocks of the place: %s", (time_zone, told, moment) => {
  survey.value = { place: { time_zone } } as unknown as Survey;
  expect(clockThere("2026-05-03T17:30:05Z")).toBe(told);
  expect(momentThere("2026-05-03T17:30:05Z")).toBe(moment);
});

it("names a stream by its cameras or file, and what is piped in the language of the page", async () => {
  await learn("live");
  const facts = { scan_id: 4, began_at: "2026-05-03T17:30:05Z", state: "ended", health: null };
  const titled = (source: string | null) => {
    const stream = { ...facts, source, vehicles: [], flow: [], earlier: [] } as unknown as LiveStream;
    render(<Stream stream={stream} surveyId={1} />, document.body);
    return document.querySelector("h2")?.textContent;
  };
  expect(titled("/cameras/lines.raw")).toBe("/cameras/lines.raw");
  expect(titled(null)).toBe("Lines from a pipe");
  await speak("fr");
  expect(titled(null)).toBe("Lignes reçues par un tube");
  await speak("en");
  render(null, document.body);
});
