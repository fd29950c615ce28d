import { signal } from "@preact/signals";
import { beforeEach, describe, expect, it } from "vitest";
import { FakeServer } from "../../../testing/server";
import { History } from "../../core/history";
import { toasts } from "../../core/toasts";
import type { LineHeight, LinePose, LinePoses } from "../../core/types";
import { fitAll } from "../../parts/strips/view";
import type { Bench } from "./bench";
import { LineHeights } from "./heights";
import { isRodOf, rodOf } from "./kinds";
import { RodDraft } from "./rod";

const SOLVED = { status: "ok", residuals_px: [], warnings: [], camera_height_m: 1.2 };
const MARK = { distance_m: 2.7, height_m: 0, row_px: 250, line: 10 };

/** As much of the bench as marks and heights need. */
function bench() {
  const undo = new History();
  const model = {
    id: 7,
    mode: signal("rod"),
    view: signal(fitAll({ lines: 100, rows: 256 }, 100, 256)),
    history: undo,
    edge: signal(null),
    chosenId: signal<number | null>(3),
    start: (mode: string) => {
      model.mode.value = mode;
    },
    cancel: () => {
      model.mode.value = "look";
    },
    page: () => "",
    change: (label: string, work: Parameters<History["run"]>[1]) => undo.run(label, work),
  };
  const heights = new LineHeights(model as unknown as Bench);
  return { model, undo, heights, rod: new RodDraft(model as unknown as Bench, heights) };
}

function pose(): LinePoses {
  const current = { revision: 1, marks: [MARK], sigma_px: 0.5, u_distance_m: 0, u_lean_rad: 0 };
  return { current: { ...current, solved: SOLVED } as unknown as LinePose, history: [] };
}

describe("the rod's marks", () => {
  beforeEach(() => {
    new FakeServer().on("POST", /\/line-pose\/preview$/, () => SOLVED);
  });

  it("asks for the distance first, then counts the heights up", () => {
    const { rod } = bench();
    rod.open();
    rod.click({ line: 5, row: 200 });
    expect(rod.values.value.marks).toEqual([]);
    rod.next.value = { distance_m: 2.7, height_m: 0, step_m: 0.1 };
    for (const row of [250, 240, 230]) rod.click({ line: 5, row });
    expect(rod.values.value.marks.map((mark) => mark.height_m)).toEqual([0, 0.1, 0.2]);
    expect(rod.next.value.height_m).toBe(0.3);
  });

  it("keeps what is not stored yet, goes back on demand, and shows what an undo changes", async () => {
    const { rod, heights, model, undo } = bench();
    heights.kept.poses.value = pose();
    rod.open();
    expect(rod.values.value).toMatchObject({ marks: [MARK], sigma_px: 0.5 });
    rod.remove(0);
    model.mode.value = "look";
    rod.open();
    expect(rod.values.value.marks).toEqual([]);
    await undo.undo();
    expect(model.mode.value).toBe("rod");
    expect(rod.values.value.marks).toEqual([MARK]);
    rod.clear();
    rod.reset();
    expect(rod.values.value.marks).toEqual([MARK]);
    expect(rod.changed.value).toBe(false);
  });

  it("are not stored while the stored ones have their uncertainty from the residuals", () => {
    const saved = pose().current as LinePose;
    const unsaid = { ...saved, sigma_px: null };
    expect(isRodOf(saved, rodOf(saved))).toBe(true);
    expect(isRodOf(unsaid, rodOf(unsaid))).toBe(false);
  });

  it("closes what it is stored from, and nothing that was taken up meanwhile", async () => {
    const server = new FakeServer();
    server.on("POST", /\/line-pose\/preview$/, () => SOLVED);
    server.on("PUT", /\/line-pose$/, () => pose().current);
    server.on("GET", /\/line-pose$/, () => pose());
    server.on("GET", /\/heights$/, () => []);
    for (const [taken, after] of [
      [null, "look"],
      ["height", "height"],
    ] as const) {
      const { rod, heights, model } = bench();
      heights.kept.poses.value = pose();
      rod.open();
      rod.remove(0);
      const stored = rod.store();
      if (taken) model.mode.value = taken;
      await stored;
      expect(model.mode.value).toBe(after);
    }
  });
});

it("is said to be kept, not saved, where there is no connection", async () => {
  const server = new FakeServer();
  server.down = true;
  const { rod, heights } = bench();
  heights.kept.poses.value = pose();
  rod.open();
  rod.change({ sigma_px: 2 });
  await rod.store();
  expect(toasts.value.at(-1)?.text).toContain("kept in this browser");
});

describe("a vehicle's heights", () => {
  it("are selected one after the other, target before contact, without the withdrawn", () => {
    const { heights } = bench();
    const one = (target: string, withdrawn = false, vehicle_id = 3) =>
      ({ target, withdrawn, vehicle_id }) as LineHeight;
    heights.kept.stored.value = [
      one("roof"),
      one("taillight", true),
      one("driver_eye"),
      one("roof", false, 4),
    ];
    const seen: unknown[] = [];
    while (heights.selectNext()) seen.push({ ...heights.selected.value });
    expect(seen).toEqual([
      { target: "roof", role: "point" },
      { target: "roof", role: "contact" },
      { target: "driver_eye", role: "point" },
      { target: "driver_eye", role: "contact" },
    ]);
    expect(heights.selected.value).toBeNull();
  });
});
