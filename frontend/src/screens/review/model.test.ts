import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer, recording } from "../../../testing/server";
import { connection, tryAgainNow } from "../../core/api";
import { outbox } from "../../core/outbox";
import { toasts } from "../../core/toasts";
import type { Measurement, ReviewItem } from "../../core/types";
import { imagePoint, pair } from "../../viewer/points";
import { ReviewModel } from "./model";

let server: FakeServer;
let model: ReviewModel;
let judged: unknown[];
let items: ReviewItem[];
const quiet = () => vi.advanceTimersByTimeAsync(20);

/** The survey's plan wants all of them clicked again first. */
let blind = false;

function item(id: number): ReviewItem {
  const measurement = server.save(id, {
    target: "roof",
    frame: 40 + id,
    contact: [100, 400],
    target_point: [101, 250],
    revision: 1,
    withdrawn: false,
    pose_id: 1,
  });
  const judged = { blind, signs: [], error_m: null, U95_error_m: null };
  return { measurement, mine: false, vehicle: { number: 3 }, judged } as unknown as ReviewItem;
}

async function open(all: 0 | 1, more = ""): Promise<void> {
  blind = all === 1;
  items = [item(1), item(2)];
  history.replaceState(null, "", `/surveys/5/review?${more}`);
  model = new ReviewModel(5);
  await model.load();
  await quiet();
}

beforeEach(() => {
  vi.useFakeTimers();
  localStorage.clear();
  judged = [];
  toasts.value = [];
  server = new FakeServer("reviewer");
  server.on("GET", /\/review-queue/, () => items);
  server.on("GET", /\/review-plan$/, () => ({ blind_one_in: blind ? 1 : 0, version: 0 }));
  server.on("GET", /\/review-work$/, () => ({
    to_review: 2,
    own: 0,
    in_lots: 0,
    accepted: 0,
    rejected: 0,
    heights: 2,
  }));
  server.on("GET", /\/recordings$/, () => [recording()]);
  server.on("POST", /^\/measurements\/(\d+)\/reviews$/, (match, body) => {
    judged.push(body);
    const review = {
      verdict: body["verdict"],
      reason: body["reason"] ?? null,
      reviewer: { id: 1, name: "R" },
      at: "2026-11-30T10:00Z",
    };
    return server.save(Number(match[1]), { ...server.stored.get(Number(match[1])), review });
  });
});

afterEach(() => {
  model.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
  history.replaceState(null, "", "/");
});

describe("the review queue", () => {
  it("opens the first on its frame, and goes on to the next after a verdict", async () => {
    await open(0);
    expect(model.currentId.value).toBe(1);
    expect(model.onFrame.value).toBe(true);
    await model.judge("accepted");
    await quiet();
    expect(judged).toEqual([{ revision: 1, verdict: "accepted", seen: "to_review" }]);
    expect(model.currentId.value).toBe(2);
    expect(model.reel.seen.value).toBe(42);
  });

  it("keeps a verdict over a closed page without a connection, goes on, and sends it once from the next", async () => {
    await open(0);
    server.down = true;
    await model.judge("rejected", "The feature is hidden.");
    expect(model.currentId.value).toBe(2);
    model.close();
    outbox.open(null);
    server.down = false;
    outbox.open(1);
    await quiet();
    tryAgainNow(); // what the page itself was asking for
    await quiet();
    expect(server.writes).toEqual(["POST /measurements/1/reviews"]);
    expect(judged).toMatchObject([{ verdict: "rejected", reason: "The feature is hidden." }]);
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("shows what there is now where the points were changed meanwhile, and leaves nothing to send", async () => {
    await open(0);
    server.on("POST", /\/reviews$/, () => {
      throw 409;
    });
    server.save(1, { ...server.stored.get(1), revision: 2 });
    await model.judge("accepted");
    await quiet();
    expect(model.current.value?.measurement).toMatchObject({ id: 1, revision: 2 });
    expect(outbox.wishes.value.size).toBe(0);
    expect(judged).toEqual([]);
  });

  it("judges heights of line scans like the others, on their strips, and corrects none", async () => {
    const { recording_id: _, frame: __, ...line } = item(4).measurement as Measurement;
    const scanned = { ...line, scan_id: 9, contact: [3000, 150], target_point: [3040, 40] };
    server.on("GET", /^\/scans\/9$/, () => ({ id: 9, lines: 8000, rows_px: 200, levels: [] }));
    server.on("POST", /^\/measurements\/4\/reviews$/, (_match, body) => {
      judged.push(body);
      return {
        ...scanned,
        review: { verdict: body["verdict"], reason: null, reviewer: { id: 1, name: "R" } },
      };
    });
    await open(0);
    const of = { vehicle: { number: 8, scan_name: "East" }, judged: { blind: false, signs: [] } };
    items = [{ ...of, measurement: scanned, mine: false } as unknown as ReviewItem, item(2)];
    await model.load();
    await quiet();
    expect([model.currentId.value, model.ofFrame.value]).toEqual([4, null]);
    const { line0, perPx, width } = model.strips.stage.view.value;
    expect(line0).toBeLessThan(3000);
    expect(line0 + width * perPx).toBeGreaterThan(3040);
    model.startFix();
    expect(model.fix.value).toBeNull();
    await model.judge("accepted");
    expect(judged).toEqual([{ revision: 1, verdict: "accepted", seen: "to_review" }]);
    expect([model.currentId.value, model.ofFrame.value?.id]).toEqual([2, 2]);
    await model.history.undo();
    await quiet();
    expect(judged.at(-1)).toMatchObject({ verdict: "reopened", seen: "accepted" });
    expect(model.currentId.value).toBe(4);
  });

  it("stores dragged and nudged points as a fix with Enter", async () => {
    await open(0);
    model.startFix();
    model.fixing.drag("point", imagePoint(110, 240), "move");
    model.fixing.drag("point", imagePoint(111, 241), "end");
    model.stage.nudge(0, -1);
    model.fixing.selectNext();
    model.stage.nudge(0.1, 0);
    await quiet();
    expect(server.heights.at(-1)).toMatchObject({ target_point: [111, 240], contact: [100.1, 400] });
    model.stage.confirm();
    await quiet();
    expect(judged).toEqual([
      {
        revision: 1,
        verdict: "fixed",
        seen: "to_review",
        target_point: [111, 240],
        contact: [100.1, 400],
        frame: 41,
      },
    ]);
  });

  it("has no fix to save where nothing was moved, or was moved back", async () => {
    await open(0);
    model.startFix();
    model.stage.confirm();
    model.stage.nudge(1, 0);
    expect(model.fixing.differs.value).toBe(true);
    model.stage.nudge(-1, 0);
    expect(model.fixing.differs.value).toBe(false);
    model.stage.confirm();
    await quiet();
    expect(judged).toEqual([]);
    expect(model.fix.value).not.toBeNull();
  });

  it("saves a fix that moves nothing where the road pose is another: its height is", async () => {
    await open(0);
    model.reel.recordings.value = [recording({ pose_id: 2 })];
    model.startFix();
    model.stage.confirm();
    await quiet();
    expect(judged).toMatchObject([{ verdict: "fixed" }]);
  });

  it("shows what the address names whatever its verdict, and says where there is no such measurement", async () => {
    const accepted = item(3);
    server.on("GET", /measurement=3&state=all|state=all&measurement=3/, () => [accepted]);
    await open(0, "&measurement=3");
    expect(model.currentId.value).toBe(3);
    expect(toasts.value).toEqual([]);
    model.close();
    server.on("GET", /measurement=77/, () => []);
    await open(0, "&measurement=77");
    expect(toasts.value.map((one) => one.kind)).toEqual(["problem"]);
  });

  it("puts a point back where it was when its drag is cancelled", async () => {
    await open(0);
    model.startFix();
    model.fixing.drag("point", imagePoint(150, 240), "move");
    model.fixing.drag("point", imagePoint(101, 250), "cancel");
    expect(model.point.value && pair(model.point.value)).toEqual([101, 250]);
    expect(model.fix.value).not.toBeNull();
    expect(model.stage.cancel()).toBe(true);
    expect(model.fix.value).toBeNull();
    expect(judged).toEqual([]);
  });

  it("takes a verdict back where it was given, and gives it again", async () => {
    await open(0);
    await model.judge("rejected", "It is hidden.");
    await quiet();
    expect(model.currentId.value).toBe(2);
    expect(await model.history.undo()).toBe("verdict on roof of vehicle 03");
    expect(model.currentId.value).toBe(1);
    expect(judged).toMatchObject([{ verdict: "rejected" }, { verdict: "reopened", seen: "rejected" }]);
    model.go(1);
    await model.history.redo();
    await quiet();
    expect(judged.at(-1)).toMatchObject({ verdict: "rejected", reason: "It is hidden." });
    expect(model.currentId.value).toBe(1);
  });

  it("takes a verdict back that another state's list does not show: what it was on is opened before that list", async () => {
    await open(0);
    const [first] = items;
    await model.judge("rejected", "It is hidden.");
    items = [item(6), item(8)];
    await model.show("accepted");
    await quiet();
    expect(model.currentId.value).toBe(6);
    server.on("GET", /review-queue\?.*measurement=1/, () => [
      { ...first, measurement: server.stored.get(1) },
    ]);
    await model.history.undo();
    await quiet();
    expect(judged.at(-1)).toMatchObject({ verdict: "reopened", seen: "rejected" });
    expect(model.current.value?.measurement.id).toBe(1);
    model.go(-1);
    expect(model.currentId.value).toBe(1);
    expect(toasts.value.at(-1)?.text).toBe("This is the start of the queue.");
    model.go(1);
    expect(model.currentId.value).toBe(6);
  });

  it("asks for what comes after the list once, and not of a list that is on its way", async () => {
    await open(0);
    model.go(1);
    let asked = 0;
    server.on("GET", /review-queue\?.*after=/, () => {
      asked += 1;
      throw 500;
    });
    model.queue.more.value = true;
    model.go(1);
    await quiet();
    expect(asked).toBe(1);
    model.queue.items.value = null;
    model.go(1);
    await quiet();
    expect(asked).toBe(1);
  });

  describe("with another list open since", () => {
    let stands: Record<string, unknown>;
    const readAlone = () => server.on("GET", /review-queue\?.*measurement=1/, () => [stands]);
    const refused = () =>
      expect(model.history.undo()).rejects.toThrow(
        "Nothing was changed: this measurement has since been withdrawn, changed or given another verdict.",
      );
    beforeEach(async () => {
      await open(0);
      const [first] = items;
      await model.judge("rejected", "It is hidden.");
      await quiet();
      stands = { ...first, measurement: server.stored.get(1) };
      items = [item(6), item(8)];
    });

    it.each([
      [
        "another person's verdict",
        { revision: 1 },
        { verdict: "accepted", reason: null, reviewer: { id: 2 } },
      ],
      ["another person's like one's own", { revision: 1 }, { verdict: "rejected", reviewer: { id: 2 } }],
      ["another verdict of one's own", { revision: 1 }, { verdict: "accepted", reason: null }],
      ["other points", { revision: 2 }, {}],
    ])("takes back nothing where %s stands there; the step is gone", async (_what, facts, told) => {
      await model.show("accepted");
      await quiet();
      const { review, ...before } = stands["measurement"] as Measurement;
      stands = { ...stands, measurement: { ...before, ...facts, review: { ...review, ...told } } };
      readAlone();
      model.history.push({ label: "a later step", undo: () => {}, redo: () => {} });
      await model.history.undo();
      await refused();
      expect(judged).toHaveLength(1);
      expect(model.history.undoLabel.value).toBeNull();
      expect(model.history.redoLabel.value).toBe("a later step");
    });

    it("does not give a verdict again on points that nobody looked at", async () => {
      await model.history.undo();
      await model.show("accepted");
      await quiet();
      stands = { ...stands, measurement: { ...server.stored.get(1), revision: 2 } };
      readAlone();
      await expect(model.history.redo()).rejects.toThrow("Nothing was changed");
      expect(judged).toHaveLength(2);
      expect(model.history.redoLabel.value).toBeNull();
    });

    it("takes back nothing where the height was withdrawn; the list that is shown stays", async () => {
      await model.show("accepted");
      await quiet();
      server.on("GET", /review-queue\?.*measurement=1/, () => []);
      await refused();
      expect(model.history.undoLabel.value).toBeNull();
      expect(model.currentId.value).toBe(6);
    });

    it("takes a verdict back while that list is on its way", async () => {
      model.go(-1);
      expect(model.currentId.value).toBe(1);
      readAlone();
      const shown = model.show("accepted");
      expect(model.queue.items.value).toBeNull();
      await model.history.undo();
      await shown;
      expect(judged.at(-1)).toMatchObject({ verdict: "reopened", seen: "rejected" });
    });

    it("has a step for a verdict that was stored when its list was gone", async () => {
      const under = model.judge("accepted");
      await model.show("accepted");
      await under;
      await quiet();
      server.on("GET", /review-queue\?.*measurement=2/, () => [
        { ...stands, measurement: server.stored.get(2) },
      ]);
      await model.history.undo();
      expect(judged.at(-1)).toMatchObject({ verdict: "reopened", seen: "accepted" });
      expect(model.currentId.value).toBe(2);
    });
  });

  describe("with this list still open", () => {
    /** As the server has it: only the verdict that was seen is put another in the place of. */
    const judgedByServer = (stands: Measurement["review"]) =>
      server.on("POST", /^\/measurements\/(\d+)\/reviews$/, (match, body) => {
        const now = server.stored.get(Number(match[1]));
        server.on("GET", /\/history$/, () => ({ revisions: [{ ...now, review: stands }], reviews: [] }));
        if (body["seen"] !== stands.verdict || (body["seen_at"] ?? stands.at) !== stands.at) throw 409;
        judged.push(body);
        return { ...now, review: { ...stands, verdict: body["verdict"] } };
      });
    const other = { id: 2, name: "S" };

    it.each([
      [
        "like one's own",
        { verdict: "rejected", reason: "It is hidden.", reviewer: other, at: "2026-11-30T11:00Z" },
      ],
      ["that reopened it", { verdict: "reopened", reason: null, reviewer: other, at: "2026-11-30T11:00Z" }],
    ])("takes back nothing where another gave a verdict %s since, and says so", async (_what, stands) => {
      await open(0);
      await model.judge("rejected", "It is hidden.");
      await quiet();
      judgedByServer(stands as unknown as Measurement["review"]);
      await expect(model.history.undo()).rejects.toThrow(
        "Nothing was changed: this measurement has since been",
      );
      await quiet();
      expect(judged).toHaveLength(1);
      expect(outbox.wishes.value.size).toBe(0);
      expect(model.history.undoLabel.value).toBeNull();
      expect(model.queue.find(1)?.measurement.review).toMatchObject({ reviewer: other });
    });

    it.each([
      ["a fix", "fixed", 1, "accept the measurement if it is right"],
      ["another person's verdict", "accepted", 2, "accept the measurement if it is right"],
    ])("does not give %s again that was reopened, and says what to do", async (_what, verdict, by, words) => {
      await open(0);
      const [first] = items;
      const review = { verdict, reason: null, reviewer: { id: by, name: "S" }, at: null };
      items = [{ ...first, measurement: { ...first?.measurement, review } } as unknown as ReviewItem];
      await model.load();
      await quiet();
      await model.judge("reopened");
      await expect(model.history.undo()).rejects.toThrow(words);
      expect(judged).toMatchObject([{ verdict: "reopened" }]);
      expect(model.history.undoLabel.value).toBeNull();
    });

    it("takes back nothing where another's verdict was taken in a conflict, like one's own as it is", async () => {
      await open(0);
      server.down = true;
      await model.judge("accepted");
      const stands = { verdict: "accepted", reason: null, reviewer: other, at: "2026-11-30T11:00Z" };
      judgedByServer(stands as unknown as Measurement["review"]);
      server.down = false;
      tryAgainNow();
      await quiet();
      tryAgainNow(); // what the page itself was asking for
      await quiet();
      outbox.resolve("verdict.1", "theirs");
      await quiet();
      expect(model.queue.find(1)?.measurement.review).toMatchObject({ reviewer: other });
      await expect(model.history.undo()).rejects.toThrow(
        "Nothing was changed: this measurement has since been",
      );
      expect(judged).toEqual([]);
    });

    it("knows of a verdict that was sent later when it was given", async () => {
      await open(0);
      server.down = true;
      await model.judge("rejected", "It is hidden.");
      server.down = false;
      tryAgainNow();
      await quiet();
      tryAgainNow(); // what the page itself was asking for
      await quiet();
      expect(connection.value.lost).toBe(false);
      expect(model.queue.find(1)?.measurement.review.at).toBe("2026-11-30T10:00Z");
    });
  });

  it("leaves no step and nothing to send where a verdict was refused", async () => {
    await open(0);
    server.on("POST", /\/reviews$/, () => {
      throw 422;
    });
    await model.judge("accepted");
    await quiet();
    expect(model.history.undoLabel.value).toBeNull();
    expect(outbox.wishes.value.size).toBe(0);
  });

  it("goes back with K to what was just judged, which stays in the list", async () => {
    await open(0);
    await model.judge("accepted");
    await quiet();
    model.go(-1);
    expect(model.current.value?.measurement).toMatchObject({ id: 1, review: { verdict: "accepted" } });
    await model.judge("reopened");
    await quiet();
    expect(judged.at(-1)).toMatchObject({ verdict: "reopened", seen: "accepted" });
    expect(model.currentId.value).toBe(1);
  });

  it("stays with what was opened while a verdict was on its way", async () => {
    items = [];
    await open(0);
    items.push(item(3));
    await model.load();
    const under = model.judge("accepted");
    model.go(1);
    model.go(1);
    const opened = model.currentId.value;
    await under;
    await quiet();
    expect(model.currentId.value).toBe(opened);
  });

  it("rejects with a digit and Enter, and never types the digit", async () => {
    await open(0);
    model.startReject();
    expect(model.stage.confirm()).toBe(false);
    model.rejection.reason.value = "The feature is hidden.";
    expect(model.stage.confirm()).toBe(true);
    await quiet();
    expect(judged).toMatchObject([{ verdict: "rejected", reason: "The feature is hidden." }]);
    expect(model.rejection.begun.value).toBe(false);
  });

  it("lets what cannot be clicked blind be rejected, and nothing else", async () => {
    await open(1);
    await model.judge("accepted");
    expect(judged).toEqual([]);
    model.startReject();
    await model.judge("rejected", "The feature is hidden.");
    await quiet();
    expect(judged).toMatchObject([{ verdict: "rejected" }]);
  });

  it("keeps a second click without a connection, shows the points, and sends the verdict behind it", async () => {
    await open(1);
    server.down = true;
    model.stage.place(imagePoint(99, 401));
    model.stage.place(imagePoint(100, 251));
    await quiet();
    expect(model.hidden.value).toBe(false);
    void model.judge("accepted");
    await quiet();
    server.down = false;
    tryAgainNow();
    await vi.advanceTimersByTimeAsync(100);
    expect(server.writes).toEqual(["POST /vehicles/7/measurements", "POST /measurements/1/reviews"]);
  });

  it("hides the points until they are clicked again, and stores that as a repeat", async () => {
    await open(1);
    expect(model.hidden.value).toBe(true);
    model.startFix();
    expect(model.fix.value).toBeNull();
    model.stage.place(imagePoint(99, 401));
    expect(model.stage.hint.value).toContain("roof");
    model.stage.place(imagePoint(100, 251));
    await quiet();
    expect(server.writes).toEqual(["POST /vehicles/7/measurements"]);
    expect([...server.stored.values()].at(-1)).toMatchObject({
      repeat_of: 1,
      contact: [99, 401],
      target_point: [100, 251],
    });
    expect(model.hidden.value).toBe(false);
  });

  it("takes a blind contact back with Esc, the cursor before it", async () => {
    await open(1);
    model.stage.place(imagePoint(99, 401));
    model.stage.keyboard.toggle();
    model.stage.cancel();
    expect(model.stage.cursor.value).toBeNull();
    expect(model.blind.contact.value).not.toBeNull();
    model.stage.cancel();
    expect(model.blind.contact.value).toBeNull();
  });
});
