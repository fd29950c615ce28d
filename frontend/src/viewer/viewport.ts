/**
 * The one place that knows how image pixels lie on the screen, and the only home of the half pixel:
 * image x = 0 is a pixel's centre, the canvas counts from that pixel's left edge.
 * A Viewport is immutable; zooming and panning return a new one.
 */
import { type ImagePoint, imagePoint, type ScreenPoint, screenPoint } from "./points";
import { clamp, type Size, type View } from "./view";

const MAX_SCALE = 40;
/** A picture may be panned away until this many screen pixels of it are left. */
const KEEP_VISIBLE_PX = 48;

export class Viewport implements View<ImagePoint, Viewport> {
  private constructor(
    readonly image: Size,
    readonly screen: Size,
    readonly scale: number,
    /** Screen position of the image's top-left CORNER. */
    readonly left: number,
    readonly top: number,
    /** True while the picture follows the window's size. */
    readonly fitted: boolean,
  ) {}

  static fit(image: Size, screen: Size): Viewport {
    const scale = fitScale(image, screen);
    return new Viewport(
      image,
      screen,
      scale,
      (screen.width - image.width * scale) / 2,
      (screen.height - image.height * scale) / 2,
      true,
    );
  }

  toScreen(point: ImagePoint): ScreenPoint {
    return screenPoint(this.left + (point[0] + 0.5) * this.scale, this.top + (point[1] + 0.5) * this.scale);
  }

  toPicture(point: ScreenPoint): ImagePoint {
    return imagePoint((point[0] - this.left) / this.scale - 0.5, (point[1] - this.top) / this.scale - 0.5);
  }

  /** SVG transform that puts image coordinates (pixel centres) on the screen. */
  get svgTransform(): string {
    const [x, y] = this.toScreen(imagePoint(0, 0));
    return `matrix(${this.scale} 0 0 ${this.scale} ${x} ${y})`;
  }

  get minScale(): number {
    return fitScale(this.image, this.screen) / 2;
  }

  /** Zoom by a factor; the image point under `at` stays under it. */
  zoom(at: ScreenPoint, factor: number): Viewport {
    const scale = clamp(this.scale * factor, this.minScale, MAX_SCALE);
    const ratio = scale / this.scale;
    return this.placed(scale, at[0] - (at[0] - this.left) * ratio, at[1] - (at[1] - this.top) * ratio);
  }

  pan(dx: number, dy: number): Viewport {
    return this.placed(this.scale, this.left + dx, this.top + dy);
  }

  /** The window changed: a fitted picture stays fitted, a zoomed one keeps its centre. */
  resized(screen: Size): Viewport {
    if (this.fitted) return Viewport.fit(this.image, screen);
    const dx = (screen.width - this.screen.width) / 2;
    const dy = (screen.height - this.screen.height) / 2;
    const moved = new Viewport(this.image, screen, this.scale, this.left, this.top, false);
    return moved.pan(dx, dy);
  }

  /** Move just enough that an image point is at least `margin` inside the window. */
  reveal(point: ImagePoint, margin = 60): Viewport {
    const [x, y] = this.toScreen(point);
    const dx = x - clamp(x, margin, Math.max(margin, this.screen.width - margin));
    const dy = y - clamp(y, margin, Math.max(margin, this.screen.height - margin));
    return dx === 0 && dy === 0 ? this : this.pan(-dx, -dy);
  }

  contains(point: ImagePoint): boolean {
    return (
      point[0] >= -0.5 &&
      point[1] >= -0.5 &&
      point[0] <= this.image.width - 0.5 &&
      point[1] <= this.image.height - 0.5
    );
  }

  nearest(at: ImagePoint): ImagePoint {
    return imagePoint(clamp(at[0], 0, this.image.width - 1), clamp(at[1], 0, this.image.height - 1));
  }

  shifted(at: ImagePoint, dx: number, dy: number): ImagePoint {
    return imagePoint(at[0] + dx, at[1] + dy);
  }

  fit(): Viewport {
    return Viewport.fit(this.image, this.screen);
  }

  private placed(scale: number, left: number, top: number): Viewport {
    const { image, screen } = this;
    return new Viewport(
      image,
      screen,
      scale,
      clamp(left, KEEP_VISIBLE_PX - image.width * scale, screen.width - KEEP_VISIBLE_PX),
      clamp(top, KEEP_VISIBLE_PX - image.height * scale, screen.height - KEEP_VISIBLE_PX),
      false,
    );
  }
}

function fitScale(image: Size, screen: Size): number {
  if (screen.width <= 0 || screen.height <= 0) return 1;
  return Math.min(screen.width / image.width, screen.height / image.height, MAX_SCALE);
}
