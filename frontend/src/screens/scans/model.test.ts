import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { tryAgainNow } from "../../core/api";
import { say, speak } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { me } from "../../core/session";
import { toasts } from "../../core/toasts";
import type { StripPoint } from "../../parts/strips/view";
import { Gestures } from "../../viewer/gestures";
import { screenPoint } from "../../viewer/points";
import { ScanModel } from "./model";

const LINES = { front_line_1: 200, rear_line_1: 500, front_line_2: 220, rear_line_2: 520 };

let server: FakeServer;
let model: ScanModel;
let measurement: Record<string, unknown>;
let version: number;
let deleted: boolean;
const shown = () => ({ id: 9, number: 1, version, deleted, measurement });
const quiet = () => vi.advanceTimersByTimeAsync(20);
const puts = () => server.writes.filter((write) => write.startsWith("PUT"));

beforeEach(async () => {
  vi.useFakeTimers();
  toasts.value = [];
  server = new FakeServer();
  measurement = { id: 1, ...LINES, front_wheel_line: null, rear_wheel_line: null, status: "ok" };
  server.on("GET", /^\/scans\/3$/, () => ({ id: 3, state: "ready", lines: 1000, rows_px: 200, levels: [] }));
  version = 1;
  deleted = false;
  server.on("GET", /^\/scans\/3\/vehicles$/, () => (deleted ? [] : [shown()]));
  server.on("GET", /^\/scan-vehicles\/9$/, () => ({ vehicle: shown() }));
  server.on("GET", /\/line-pose$/, () => ({ current: null, history: [] }));
  server.on("PUT", /\/boundaries$/, (_match, { version: _version, ...lines }) => {
    measurement = { ...measurement, ...lines };
    version += 1;
    return shown();
  });
  server.on("PUT", /\/wheels$/, (_match, { version: _version, ...wheels }) => {
    measurement = { ...measurement, ...wheels };
    version += 1;
    return shown();
  });
  model = new ScanModel(3);
  await model.load();
  // one line and one row to a screen pixel
  model.stage.view.value = model.stage.view.value.resized({ width: 1000, height: 424 });
  model.choose(9);
  await quiet();
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

function hand(): (fromX: number, toX: number, y?: number, cancelled?: boolean) => void {
  const gestures = new Gestures(model.stage);
  gestures.options = { panByDrag: true };
  return (fromX, toX, y = 100, cancelled = false) => {
    gestures.down(screenPoint(fromX, y), 0, false);
    gestures.move(screenPoint(toX, y));
    if (cancelled) gestures.cancel();
    else gestures.up(screenPoint(toX, y));
  };
}

describe("a window that gets another size", () => {
  const size = { clientWidth: 1000, clientHeight: 424 };
  let changed = () => {};
  const seen = (line: number) => model.stage.view.value.toScreen({ camera: 1, line, row: 0 })[0];
  const narrowed = (width: number) => {
    size.clientWidth = width;
    changed();
  };
  beforeEach(() => {
    class Watcher {
      constructor(told: () => void) {
        changed = told;
      }
      observe() {}
      disconnect() {}
    }
    vi.stubGlobal("ResizeObserver", Watcher);
    size.clientWidth = 900;
    model.stage.attach(size as unknown as HTMLElement);
    model.show("fit");
  });

  it("still shows the whole of the chosen vehicle", () => {
    narrowed(300);
    expect(seen(200)).toBeGreaterThan(0);
    expect(seen(520)).toBeLessThan(300);
  });

  it("does not go back to a vehicle that was left", () => {
    model.stage.view.value = model.stage.view.value.zoom(screenPoint(0, 0), 3).pan(-1e9, 0);
    narrowed(300);
    expect(seen(520)).toBeLessThan(0);
  });
});

it("goes from a vehicle that is not listed any more to the last and the first", async () => {
  for (const by of [-1, 1] as const) {
    model.choose(77);
    model.step(by);
    expect([model.chosenId.value, toasts.value]).toEqual([9, []]);
  }
});

describe("the strips", () => {
  it("go to the screen and back, each camera in its own window", () => {
    for (const at of [
      { camera: 1, line: 30.5, row: 12 },
      { camera: 2, line: 700, row: 150.25 },
    ] as StripPoint[]) {
      const view = model.view.value;
      expect(view.toPicture(view.toScreen(at))).toEqual(at);
    }
  });

  it("have boundaries that are dragged on their own strip, as one step", async () => {
    const drag = hand();
    drag(202, 262, 330); // the front at camera 2 stands at 220, out of reach
    expect(model.boundaries.draft.value).toBeNull();
    model.stage.fit();
    drag(202, 262);
    await quiet();
    expect(measurement).toMatchObject({ ...LINES, front_line_1: 260 });
    expect(model.history.undoLabel.value).toContain("boundaries");
    await model.history.undo();
    expect(measurement).toMatchObject(LINES);
  });

  it("keep a boundary where it was when its drag is cancelled, or nudged forth and back", async () => {
    hand()(200, 260, 100, true);
    expect(model.boundaries.draft.value).toBeNull();
    model.boundaries.edge.value = "front_line_1";
    model.stage.nudge(1, 0);
    model.stage.nudge(-1, 0);
    await vi.advanceTimersByTimeAsync(1000);
    expect(model.boundaries.draft.value).toBeNull();
    expect(puts()).toEqual([]);
    expect(model.history.undoLabel.value).toBeNull();
  });

  it("take two clicks on camera 1 for the wheels, a slide among them", async () => {
    model.start("wheels");
    const click = hand();
    click(300, 305, 330);
    expect(toasts.value[0]?.text).toContain("camera 1");
    click(450, 455);
    expect(model.stage.hint.value).toContain("rear wheel");
    click(300, 300);
    await quiet();
    expect(measurement["front_wheel_line"]).toBeCloseTo(299.5);
    expect(measurement["rear_wheel_line"]).toBeCloseTo(449.5);
    expect(model.stage.placing.value).toBe(false);
    await model.history.undo();
    expect(measurement).toMatchObject({ front_wheel_line: null, rear_wheel_line: null });
  });

  it("give the first of two clicks back with Ctrl+Z, and let go of everything with Esc", () => {
    model.start("new");
    hand()(600, 600);
    expect(model.stage.back()).toBe(true);
    expect(model.stage.hint.value).toContain("front");
    expect(model.stage.cancel()).toBe(true);
    expect(model.mode.value).toBe("look");
  });

  it("tell why a search stopped", async () => {
    server.on("POST", /^\/scans\/3\/find$/, () => ({ id: 4, state: "running" }));
    server.on("GET", /^\/jobs\/4$/, () => ({
      id: 4,
      state: "failed",
      error: { code: "said", values: { sentence: "The strips are gone." }, message: "The strips are gone." },
    }));
    void model.search.find("direct", true);
    await vi.advanceTimersByTimeAsync(3000);
    expect(toasts.value.map((one) => one.text)).toContain("The strips are gone.");
  });

  it("choose the vehicle under a click, and none beside it", async () => {
    hand()(800, 800);
    expect(model.chosenId.value).toBeNull();
    hand()(350, 350, 330);
    expect(model.chosenId.value).toBe(9);
  });

  it("keep what was taken up while a vehicle was being stored", async () => {
    const made = { id: 10, number: 2, version: 1, deleted: false, measurement: null };
    server.on("POST", /^\/scans\/3\/vehicles$/, () => made);
    server.on("GET", /^\/scans\/3\/vehicles$/, () => [shown(), made]);
    const stored = model.edits["addVehicle"](600, 700);
    model.start("rod");
    await vi.advanceTimersByTimeAsync(100);
    await stored;
    expect(model.vehicles.value.map((one) => one.id)).toEqual([9, 10]);
    expect(model.mode.value).toBe("rod");
    expect(model.chosenId.value).toBe(9);
  });
});

describe("judging vehicles of a line scan", () => {
  const REVIEW = { verdict: "to_review", reason: null, reviewer: null, at: null };
  const [ME, OTHER] = [
    { id: 4, name: "R" },
    { id: 8, name: "S" },
  ];
  let all: Record<string, unknown>[];
  let verdicts: string[];
  const measuredOf = (vehicle: Record<string, unknown>) => vehicle["measurement"] as Record<string, unknown>;
  const change = (id: number, facts: object) => {
    all = all.map((vehicle) =>
      vehicle["id"] === id ? { ...vehicle, measurement: { ...measuredOf(vehicle), ...facts } } : vehicle,
    );
    return all.find((vehicle) => vehicle["id"] === id);
  };

  beforeEach(async () => {
    model.close();
    history.replaceState(null, "", "/");
    verdicts = [];
    me.value = { person: { ...ME, role: "reviewer" } } as unknown as typeof me.value;
    const one = (id: number, part: object = {}) => ({
      id,
      number: id,
      version: 1,
      deleted: false,
      measurement: { ...measurement, id: 100 + id, mine: false, review: REVIEW, ...part },
    });
    all = [
      one(1, { review: { ...REVIEW, verdict: "accepted", reviewer: OTHER } }),
      one(2),
      one(3, { mine: true }),
      one(4),
      one(5),
    ];
    server.on("GET", /^\/scans\/3\/vehicles$/, () => all);
    server.on("GET", /^\/scan-vehicles\/(\d+)$/, ([, id]) => ({
      vehicle: all.find((vehicle) => String(vehicle["id"]) === id),
    }));
    // as the server has it: only the verdict that was seen is put another in the place of
    server.on(
      "POST",
      /^\/scan-measurements\/(\d+)\/review/,
      ([, id], { verdict, reason = null, seen, seen_at }) => {
        const now = all.find((vehicle) => String(measuredOf(vehicle)["id"]) === id);
        const stands = now && (measuredOf(now)["review"] as typeof REVIEW);
        if (!stands || seen !== stands.verdict || (seen_at ?? stands.at) !== stands.at) throw 409;
        verdicts.push(`${id} ${verdict}`);
        const at = `2026-11-30T10:00:0${verdicts.length}Z`;
        return change(now["id"] as number, { review: { verdict, reason, reviewer: ME, at } });
      },
    );
    model = new ScanModel(3);
    model.stage.view.value = model.stage.view.value.resized({ width: 1000, height: 424 });
    await model.load();
    await quiet();
  });

  it("begins with the first that waits, as large as the window lets it be", () => {
    expect(model.chosenId.value).toBe(2);
    const { perPx, width } = model.view.value;
    expect((LINES.rear_line_2 - LINES.front_line_1) / perPx).toBeGreaterThan(width / 2);
  });

  it("goes on to the next that waits, past one's own, and says when there is none", async () => {
    for (const expected of [4, 5, 5]) {
      await model.judging.review("accepted");
      await quiet();
      expect(model.chosenId.value).toBe(expected);
    }
    expect(verdicts).toEqual(["102 accepted", "104 accepted", "105 accepted"]);
    expect(toasts.value.at(-1)?.text).toContain("No other vehicle");
  });

  it("asks for the reason of a rejection: a digit chooses one, Enter gives it, Esc leaves it", async () => {
    const { rejection } = model.judging;
    model.judging.reject();
    expect(model.stage.cancel()).toBe(true);
    expect(rejection.begun.value).toBe(false);
    model.judging.reject();
    model.stage.confirm();
    rejection.commands[1]?.run(true);
    model.stage.confirm();
    await quiet();
    expect(verdicts).toEqual(["102 rejected"]);
    expect(rejection.begun.value).toBe(false);
    expect(model.chosenId.value).toBe(4);
  });

  it("takes a verdict on a motion back as a step, and gives it again", async () => {
    await model.judging.review("rejected", "It is two vehicles.");
    await quiet();
    expect(model.chosenId.value).toBe(4);
    expect(model.history.undoLabel.value).toContain("verdict on vehicle 2");
    await model.history.undo();
    await quiet();
    expect([model.chosenId.value, model.chosen.value?.measurement?.review.verdict]).toEqual([2, "reopened"]);
    await model.history.redo();
    await quiet();
    expect(verdicts).toEqual(["102 rejected", "102 reopened", "102 rejected"]);
    expect(model.chosen.value?.measurement?.review).toMatchObject({ verdict: "rejected" });
  });

  it("does not give a verdict again on a revision that nobody looked at", async () => {
    await model.judging.review("rejected", "It is two vehicles.");
    await model.history.undo();
    change(2, { id: 112, review: REVIEW });
    await model.refresh();
    await expect(model.history.redo()).rejects.toThrow(
      "Nothing was changed: this measurement has since been",
    );
    expect(verdicts).toEqual(["102 rejected", "102 reopened"]);
    expect(model.history.redoLabel.value).toBeNull();
  });

  it.each([
    ["rejects it", "rejected", true],
    ["accepts it like oneself", "accepted", true],
    ["reopens it", "reopened", true],
    ["rejects it, unseen here", "rejected", false],
    ["accepts it like oneself, unseen here", "accepted", false],
    ["reopens it, unseen here", "reopened", false],
  ])("takes back nothing where another person %s since, and says so", async (_what, verdict, reread) => {
    await model.judging.review("accepted");
    await quiet();
    change(2, { review: { verdict, reason: null, reviewer: OTHER, at: "2026-11-30T11:00:00Z" } });
    if (reread) await model.refresh();
    await expect(model.history.undo()).rejects.toThrow(
      "Nothing was changed: this measurement has since been",
    );
    await quiet();
    expect(verdicts).toEqual(["102 accepted"]);
    expect(outbox.wishes.value.size).toBe(0);
    expect([model.history.undoLabel.value, model.history.redoLabel.value]).toEqual([null, null]);
    expect(model.vehicles.value[1]?.measurement?.review).toMatchObject({ verdict, reviewer: OTHER });
  });

  it("shows another's verdict as soon as it is taken in a conflict", async () => {
    server.down = true;
    await model.judging.review("accepted");
    change(2, { review: { ...REVIEW, verdict: "rejected", reviewer: OTHER, at: "2026-11-30T11:00:00Z" } });
    server.down = false;
    tryAgainNow();
    await quiet();
    const reviewOf2 = () => model.vehicles.value[1]?.measurement?.review;
    expect(reviewOf2()).toMatchObject({ verdict: "to_review" });
    outbox.resolve("scan-verdict.102", "theirs");
    expect(reviewOf2()).toMatchObject({ verdict: "rejected", reviewer: OTHER });
    expect(verdicts).toEqual([]);
  });

  it("does not give another person's verdict again that was reopened, and says what to do", async () => {
    model.choose(1);
    await model.judging.review("reopened");
    await expect(model.history.undo()).rejects.toThrow("accept the measurement if it is right");
    expect(verdicts).toEqual(["101 reopened"]);
    expect(model.history.undoLabel.value).toBeNull();
  });

  it("takes a verdict back that is kept, and gives it again: nobody came between", async () => {
    server.down = true;
    void model.judging.review("accepted");
    await quiet();
    await model.history.undo();
    server.down = false;
    tryAgainNow();
    await quiet();
    tryAgainNow(); // what the page itself was asking for
    await quiet();
    expect(outbox.wishes.value.size).toBe(0);
    await model.history.redo();
    expect(verdicts.at(-1)).toBe("102 accepted");
  });

  it("says nothing of a verdict that was not stored, and makes no step of it", async () => {
    server.on("POST", /^\/scan-measurements\/102\/review/, () => {
      throw 422;
    });
    await model.judging.review("accepted");
    await quiet();
    expect(model.chosenId.value).toBe(2);
    expect(model.history.undoLabel.value).toBeNull();
  });

  it("writes one verdict where the key is pressed twice, and none on what is accepted", async () => {
    void model.judging.review("accepted");
    void model.judging.review("accepted");
    await quiet();
    expect(verdicts).toEqual(["102 accepted"]);
    model.choose(1);
    await model.judging.review("accepted");
    expect(verdicts).toEqual(["102 accepted"]);
    expect(model.chosenId.value).toBe(4);
  });

  it("says of a verdict that waits for the connection that it is kept, and goes on", async () => {
    server.down = true;
    for (const verdict of ["accepted", "reopened"] as const) {
      toasts.value = [];
      void model.judging.review(verdict);
      await quiet();
      expect(toasts.value.map((one) => one.text)).toEqual([say("review-verdict-kept")]);
      expect(model.chosenId.value).toBe(4);
    }
  });

  it("stays where something else was chosen meanwhile", async () => {
    void model.judging.review("accepted");
    model.choose(5);
    await quiet();
    expect(model.chosenId.value).toBe(5);
  });
});

it("axles that are none were found by nobody", async () => {
  const told = (count: number, by: "person" | "machine") => say("scan-axles-of", { count, by });
  expect(told(0, "machine")).toBe("no wheel found");
  expect(told(0, "person")).toBe("none, corrected by hand");
  expect(told(2, "machine")).toBe("2, found by Sightline");
  vi.useRealTimers();
  await speak("fr");
  expect(told(2, "machine")).toBe("2, trouvés par Sightline");
  expect(told(3, "person")).toBe("3, corrigés à la main");
  await speak("en");
});
