import { describe, expect, it } from "vitest";
import type { NamedEvent } from "../../core/types";
import { actionWords, pageOf, rowWords, subjectWords } from "./words";

const named = (event: object, subject: object = {}): NamedEvent =>
  ({
    event: { id: 1, entity_id: 25, survey_id: 5, action: "review", entity: "review", after: null, ...event },
    subject: {
      survey: "A",
      name: null,
      vehicle_id: null,
      vehicle: null,
      target: null,
      measurement_id: null,
      ...subject,
    },
  }) as unknown as NamedEvent;

describe("an audit event in words", () => {
  it("names vehicle and target, not a row of the database, and leads to it", () => {
    const on = { vehicle_id: 9, vehicle: 9, target: "roof", measurement_id: 31 };
    const one = named({ after: { verdict: "rejected" } }, on);
    expect(`${actionWords(one.event)} ${subjectWords(one)}`).toBe("reviewed vehicle 09, roof: rejected");
    expect(pageOf(one)).toBe("/surveys/5/review?measurement=31");
    expect(rowWords(one.event)).toContain("25");
  });

  it("names what has a name, and says the kind of what has none", () => {
    expect(subjectWords(named({ entity: "camera" }, { name: "left" }))).toBe("camera “left”");
    expect(subjectWords(named({ entity: "click_sigma" }))).toBe("click uncertainty");
    expect(subjectWords(named({ entity: "job" }, { name: "drift" }))).toBe("job “Camera stability check”");
    expect(pageOf(named({ entity: "person", survey_id: null }))).toBeNull();
    expect(pageOf(named({ entity: "vehicle", entity_id: 7 }, { vehicle: 7 }))).toBe(
      "/surveys/5/measure?vehicle=7",
    );
  });
});
