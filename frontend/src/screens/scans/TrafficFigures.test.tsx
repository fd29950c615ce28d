import { render } from "preact";
import { afterEach, describe, expect, it } from "vitest";
import { learn, speak } from "../../core/messages";
import type { ScanTraffic, TrafficInterval } from "../../core/types";
import { readAt } from "../../parts/figures/reading";
import { countedWords } from "./counted";
import { busiest, FundamentalFigure, overIntervals, statesOf } from "./TrafficFigures";

afterEach(() => render(null, document.body));

function interval(minute: number, flow: number, speed: number | null, partial = false): TrafficInterval {
  return {
    begins_at: `2026-05-03T08:0${minute}:00.000+02:00`,
    watched_s: 60,
    partial,
    vehicles: flow / 60,
    refused: 0,
    measured: speed === null ? 0 : flow / 60,
    flow_per_hour: flow,
    space_mean_speed_mps: { value: speed, u: speed && 0.1 },
    density_per_km: { value: speed && flow / (3.6 * speed), u: speed && 0.1 },
    percentiles: [],
  } as unknown as TrafficInterval;
}

const scan = (...intervals: TrafficInterval[]) =>
  ({
    scan_id: 3,
    name: "Hill",
    direction: "camera_1_first",
    lane: null,
    intervals,
    unplaced: 0,
    reason: null,
  }) as ScanTraffic;

describe("the fundamental diagram", () => {
  it("has a point for each interval with a speed, and tells those observed in part", () => {
    const states = statesOf([interval(0, 720, 20), interval(1, 600, null), interval(2, 1080, 15, true)]);
    expect(states.map((one) => [one.density_per_km, one.flow_per_hour, one.speed_mps, one.partial])).toEqual([
      [10, 720, 20, false],
      [20, 1080, 15, true],
    ]);
  });

  it("is called by its axes in every language, and says why there is none", async () => {
    await learn("scans");
    const shown = scan(interval(0, 720, 20));
    for (const [code, density, flow] of [
      ["en", "Flow against density, Hill", "Speed against flow, Hill"],
      ["fr", "Débit selon la concentration, Hill", "Vitesse selon le débit, Hill"],
    ] as const) {
      await speak(code);
      render(<FundamentalFigure scan={shown} against="density" />, document.body);
      expect(document.querySelector("h3")?.textContent).toBe(density);
      expect(document.querySelector("[data-testid=figure-traffic-flow-by-density-3]")).not.toBeNull();
      render(<FundamentalFigure scan={shown} against="flow" />, document.body);
      expect(document.querySelector("h3")?.textContent).toBe(flow);
    }
    await speak("en");
    render(<FundamentalFigure scan={scan(interval(0, 720, null))} against="flow" />, document.body);
    expect(document.body.textContent).toContain("No interval contains an accepted speed.");
    expect(document.querySelector("[data-testid^=figure-]")).toBeNull();
  });
});

describe("a figure over the day", () => {
  it("is read within its intervals alone, and without ends where there are none", () => {
    const value = (one: TrafficInterval) => one.space_mean_speed_mps.value;
    const shown = [interval(0, 720, 20), interval(2, 1080, 15)];
    const speeds = overIntervals(shown, { y: value, low: () => Number.NaN, high: () => 25 });
    const at = (minute: number) => readAt(speeds, Date.parse(`2026-05-03T08:0${minute}:30.000Z`), 0);
    expect(at(0)).toMatchObject({ y: 20, low: null, high: 25 });
    expect([at(1), at(3)]).toEqual([null, null]);
    expect(at(2)).toMatchObject({ y: 15 });
  });
});

describe("the flow over the day", () => {
  it("tells the largest of intervals that were observed whole, where there are any", () => {
    const part = interval(0, 3600, null, true);
    expect(busiest([part, interval(1, 720, 20), interval(2, 660, 20)]).flow_per_hour).toBe(720);
    expect(busiest([part]).flow_per_hour).toBe(3600);
  });
});

describe("how many vehicles the figures of Motion include", () => {
  const counted = { vehicles: 9, used: 7, accepted: 7, to_review: 1, rejected: 1, not_measurable: 0 };
  it("agrees with the Overview: it says why the others are not among them", async () => {
    expect(countedWords({ counted, scans: 1 }, true)).toBe(
      "7 of 9 vehicles in 1 line scan; 1 waits for review; 1 rejected.",
    );
    expect(countedWords({ counted: { ...counted, used: 8 }, scans: 1 }, false)).toBe(
      "8 of 9 vehicles in 1 line scan; 1 rejected.",
    );
    expect(countedWords({ counted: { vehicles: 9, used: 9 }, scans: 2 }, true)).toBe(
      "9 vehicles in 2 line scans.",
    );
    await speak("fr");
    expect(countedWords({ counted, scans: 1 }, true)).toBe(
      "7 véhicules sur 9 dans 1 balayage\u202f; 1 à vérifier\u202f; 1 rejeté.",
    );
    await speak("en");
  });
});
