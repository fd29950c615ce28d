import { describe, expect, it } from "vitest";
import { imagePoint, screenPoint } from "./points";
import { Viewport } from "./viewport";

const image = { width: 640, height: 480 };

describe("Viewport", () => {
  it("puts the centre of the top-left pixel half a scaled pixel inside the picture", () => {
    const view = Viewport.fit(image, { width: 1280, height: 960 });
    expect(view.scale).toBe(2);
    expect([...view.toScreen(imagePoint(0, 0))]).toEqual([1, 1]);
    expect([...view.toScreen(imagePoint(-0.5, -0.5))]).toEqual([0, 0]);
    expect([...view.toScreen(imagePoint(639.5, 479.5))]).toEqual([1280, 960]);
  });

  it("centres the picture in a window of another shape", () => {
    const view = Viewport.fit(image, { width: 1000, height: 480 });
    expect([view.scale, view.left, view.top]).toEqual([1, 180, 0]);
  });

  it("goes to the screen and back, at any zoom and pan", () => {
    const view = Viewport.fit(image, { width: 913, height: 577 })
      .zoom(screenPoint(300, 200), 7.3)
      .pan(-41.5, 12.25);
    const back = view.toPicture(view.toScreen(imagePoint(123.456, 234.567)));
    expect(back[0]).toBeCloseTo(123.456, 10);
    expect(back[1]).toBeCloseTo(234.567, 10);
  });

  it("keeps the point under the pointer while zooming", () => {
    const at = screenPoint(421, 333);
    const view = Viewport.fit(image, { width: 900, height: 700 });
    const before = view.toPicture(at);
    const after = view.zoom(at, 3).toPicture(at);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
  });

  it("draws polylines in image coordinates where its points go", () => {
    const view = Viewport.fit(image, { width: 1280, height: 960 }).zoom(screenPoint(10, 20), 2);
    const [a, , , d, e, f] = (view.svgTransform.match(/-?[\d.]+/g) ?? []).map(Number);
    const p = view.toScreen(imagePoint(17, 29));
    expect((a ?? 0) * 17 + (e ?? 0)).toBeCloseTo(p[0], 9);
    expect((d ?? 0) * 29 + (f ?? 0)).toBeCloseTo(p[1], 9);
  });

  it("follows the window while fitted and keeps its centre once zoomed", () => {
    const fitted = Viewport.fit(image, { width: 640, height: 480 });
    expect(fitted.resized({ width: 1280, height: 960 }).scale).toBe(2);
    const zoomed = fitted.zoom(screenPoint(320, 240), 4);
    const centre = zoomed.toPicture(screenPoint(320, 240));
    const wider = zoomed.resized({ width: 840, height: 580 });
    expect(wider.scale).toBe(zoomed.scale);
    expect(wider.toPicture(screenPoint(420, 290))[0]).toBeCloseTo(centre[0], 9);
  });

  it("never loses the picture and never zooms without end", () => {
    const view = Viewport.fit(image, { width: 640, height: 480 });
    expect(view.pan(1e6, 1e6).left).toBeLessThan(640);
    expect(view.zoom(screenPoint(0, 0), 1e9).scale).toBe(40);
    expect(view.zoom(screenPoint(0, 0), 1e-9).scale).toBe(0.5);
  });

  it("moves only as far as needed to show a point", () => {
    const view = Viewport.fit(image, { width: 640, height: 480 }).zoom(screenPoint(0, 0), 4);
    expect(view.reveal(view.toPicture(screenPoint(300, 200)))).toBe(view);
    const far = view.reveal(imagePoint(600, 400));
    expect([...far.toScreen(imagePoint(600, 400))]).toEqual([580, 420]);
  });
});
