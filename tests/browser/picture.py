"""Where a pixel of the picture lies in the window, from what the frame view says of the picture it shows."""

from collections.abc import Sequence

from playwright.sync_api import Page

# `data-picture`: the picture's left and top edge in the view, and its scale; pixels count from their centres.
_SPOT = """([x, y]) => {
  const view = document.querySelector("[data-testid=frame-view]:has(canvas[data-picture])");
  if (!view || view.querySelector("[data-testid=stand-in]")) return null;
  const [left, top, scale] = view.querySelector("canvas").dataset.picture.split(" ").map(Number);
  const box = view.getBoundingClientRect();
  return [box.left + left + (x + 0.5) * scale, box.top + top + (y + 0.5) * scale];
}"""


def on_screen(page: Page, pixel: Sequence[float]) -> tuple[float, float]:
    """Where to point to hit a pixel, once its frame is shown: a click on a thumbnail is lost."""
    x, y = page.wait_for_function(_SPOT, arg=[float(pixel[0]), float(pixel[1])]).json_value()
    return float(x), float(y)
