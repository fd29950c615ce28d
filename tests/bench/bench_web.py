"""The speed that people feel, in Chromium and by the clock: `python tests/bench/bench_web.py [part ...]`.

Works on a demonstration survey made in a temporary folder, or on a copy of SIGHTLINE_BENCH_DATA. Medians; the
load average stands beside each, for on a busy machine everything takes as much longer.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from bench_media import scene, standing  # noqa: E402
from playwright.sync_api import Browser, BrowserContext, Page  # noqa: E402
from web_ground import (  # noqa: E402
    CLIP_GOP,
    chromium,
    clip_recording,
    cold_starts,
    measurable,
    median_ms,
    prepare,
    serving,
    sign_in_link,
    signed_in,
)

from tests.browser.picture import on_screen  # noqa: E402
from tests.real.client import Client  # noqa: E402

PROBE = (Path(__file__).parent / "web_probe.js").read_text()
TARGETS = {"1": "roof", "2": "driver_eye", "3": "taillight"}
Row = tuple[str, str, str, bool]
STEPS_HZ = 8


@dataclass(frozen=True, eq=False)
class Ground:
    """A server with the demonstration, a browser signed in to it, and what is in there."""

    browser: Browser
    url: str
    state: Any
    client: Client
    folder: Path
    survey_id: int
    recording_id: int

    def context(self) -> BrowserContext:
        """A signed-in context with an empty cache and the probe in its pages."""
        context = self.browser.new_context(
            base_url=self.url,
            storage_state=self.state,
            viewport={"width": 1440, "height": 900},
            bypass_csp=True,
        )
        context.add_init_script(PROBE)
        return context

    def measure_page(self, context: BrowserContext, recording_id: int, more: str = "") -> Page:
        """The measure page with its first picture drawn."""
        page = context.new_page()
        page.goto(f"/surveys/{self.survey_id}/measure?recording={recording_id}{more}", wait_until="commit")
        page.wait_for_function("window.__probe?.pictures.length > 0", timeout=30_000)
        return page


def row(goal: str, limit: float, unit: str, reached: float, note: str = "") -> Row:
    return goal, f"< {limit:g} {unit}", f"{reached:.1f} {unit}{note}", reached < limit


def first_picture(ground: Ground) -> Iterator[Row]:
    """Navigation to the first picture in an empty browser, and what it had to load for that."""
    times, sizes = [], []
    for _ in range(3):
        context = ground.context()
        page = ground.measure_page(context, ground.recording_id)
        times.append(page.evaluate("window.__probe.pictures[0].at") / 1000)
        page.wait_for_load_state("networkidle")
        sizes.append(page.evaluate(_CODE_BYTES))
        context.close()
    yield row("measure page, first picture", 1.5, "s", median_ms(times) / 1000)
    yield row("measure page, code and styles as sent (Brotli)", 110, "kB", max(sizes) / 1000)


_CODE_BYTES = """performance.getEntriesByType("resource")
  .filter((one) => /\\.(js|css)$/.test(new URL(one.name).pathname))
  .reduce((sum, one) => sum + one.encodedBodySize, 0)"""


def steps(ground: Ground) -> Iterator[Row]:
    """Frame steps at 640 x 480."""
    context = ground.context()
    yield from _steps(ground.measure_page(context, ground.recording_id, "&frame=100"), "640x480", 150)
    context.close()


def steps_hd(ground: Ground) -> Iterator[Row]:
    """Frame steps and jumps at 1920 x 1080: a standing camera, and a picture that moves as a whole."""
    for draw, size in ((standing, "1080p"), (scene, "1080p moving")):
        recording_id = clip_recording(ground.client, ground.survey_id, ground.folder, (1920, 1080), 250, draw)
        context = ground.context()
        page = ground.measure_page(context, recording_id, "&frame=20")
        yield from _steps(page, size, 300)
        yield from _jumps(page, size, 1920, (150, 240, 60, 120, 200))
        context.close()


def steps_4k(ground: Ground) -> Iterator[Row]:
    """Frame steps at 3840 x 2160; the browser keeps a handful of these."""
    recording_id = clip_recording(ground.client, ground.survey_id, ground.folder, (3840, 2160), 60, scene)
    context = ground.context()
    yield from _steps(ground.measure_page(context, recording_id, "&frame=10"), "4K", 500, far=4)
    context.close()


def _steps(page: Page, size: str, limit_ms: float, far: int = 9) -> Iterator[Row]:
    """`d` goes back, `f` on, `v` ten on."""
    page.get_by_test_id("frame-view").focus()
    page.wait_for_timeout(1500)
    rested = [_pressed(page, key, 500) for key in "ddddddddffffffff"]
    yield row(f"frame step, prefetched neighbour, {size}", 16, "ms", median_ms(rested))
    working = [_pressed(page, key, 1000 / STEPS_HZ) for key in "ffffffffffffffffdddddddd"]
    yield row(f"frame step, {STEPS_HZ} a second, {size}", 50, "ms", median_ms(working))
    # Ten on is past what was fetched ahead; each place is visited once.
    times = [_pressed(page, "v", 700) for _ in range(far)]
    yield row(f"frame step, ten on, not in the browser, {size}", limit_ms, "ms", median_ms(times))


def _pressed(page: Page, key: str, every_ms: float) -> float:
    """Seconds from the key press until the new frame is drawn; returns so long after the press, or later."""
    begun = time.monotonic()
    before = page.evaluate("window.__probe.pictures.length")
    page.keyboard.press(key)
    page.wait_for_function(f"window.__probe.pictures.length > {before}", timeout=10_000)
    took = page.evaluate(f"window.__probe.pictures[{before}].at - window.__probe.keys.at(-1)")
    page.wait_for_timeout(max(1.0, every_ms - 1000 * (time.monotonic() - begun)))
    return float(took) / 1000


def _jumps(page: Page, size: str, width_px: int, frames: tuple[int, ...]) -> Iterator[Row]:
    """From the frame's number typed to its thumbnail, and to the frame itself."""
    first, whole = [], []
    for frame in frames:
        before = page.evaluate("window.__probe.pictures.length")
        page.get_by_test_id("frame-box").fill(str(frame))
        page.get_by_test_id("frame-box").press("Enter")
        there = f"window.__probe.pictures.slice({before}).find((one) => one.width === {width_px})"
        page.wait_for_function(there, timeout=30_000)
        first.append(page.evaluate(f"window.__probe.pictures[{before}].at - window.__probe.keys.at(-1)"))
        whole.append(page.evaluate(f"({there}).at - window.__probe.keys.at(-1)"))
        page.wait_for_timeout(1500)
    yield row(f"jump, its thumbnail, {size}", 50, "ms", median_ms(first) / 1000)
    yield row(f"jump, the frame, key frame every {CLIP_GOP}, {size}", 300, "ms", median_ms(whole) / 1000)


def clicks(ground: Ground) -> Iterator[Row]:
    """From the click on a target to the answer with the stored height, as an operator works."""
    vehicles = ground.client.get(f"/surveys/{ground.survey_id}/vehicles?recording_id={ground.recording_id}")
    context = ground.context()
    page = ground.measure_page(context, ground.recording_id)
    felt = []
    for number, frame in measurable(vehicles)[:8]:
        felt += _measured(page, number, frame)
    served = page.evaluate(_SERVED, "/measurements$")
    stills = page.evaluate(_SERVED, "/frames/\\d+\\.jpg")
    context.close()
    if not felt:
        raise SystemExit("Every vehicle of this demonstration is measured already; take a fresh one.")
    yield row("click to stored height", 60, "ms", median_ms(felt), f"  ({len(felt)} clicks)")
    yield row("of that the server, POST measurement", 60, "ms", median_ms([t / 1000 for t in served]))
    yield row("server, still of 640x480", 150, "ms", median_ms([t / 1000 for t in stills]))


_SERVED = """(address) => performance.getEntriesByType("resource")
  .filter((one) => new RegExp(address).test(new URL(one.name).pathname) && one.responseStart > 0)
  .map((one) => one.responseEnd - one.requestStart)"""


def _measured(page: Page, number: int, frame: dict[str, Any]) -> list[float]:
    """One vehicle: contact and three targets; seconds of each target's click."""
    page.get_by_test_id(f"pass-{number}").click()
    page.get_by_test_id("frame-box").fill(str(frame["frame"]))
    page.get_by_test_id("frame-box").press("Enter")
    page.wait_for_timeout(500)
    page.keyboard.press("Escape")
    found = []
    for position, (key, target) in enumerate(TARGETS.items()):
        page.keyboard.press(key)
        if position == 0:
            _click(page, frame["pixels"]["contact_rear"])
            page.get_by_test_id("ladder").wait_for()
        before = page.evaluate(_STORED)
        _click(page, frame["pixels"][target])
        page.wait_for_function(f"({_STORED}) > {before}", timeout=10_000)
        found.append(page.evaluate(_CLICK_MS) / 1000)
        page.wait_for_timeout(150)
    return found


_POSTED = "window.__probe.posts.filter((one) => /\\/measurements$/.test(one.url) && one.status === 201)"
_STORED = f"{_POSTED}.length"
_CLICK_MS = f"{_POSTED}.at(-1).at - window.__probe.clicks.at(-1)"


def _click(page: Page, pixel: list[float]) -> None:
    spot = on_screen(page, pixel)
    page.mouse.move(*spot)
    page.get_by_test_id("frame-view").evaluate("() => new Promise(requestAnimationFrame)")
    page.mouse.click(*spot)


PARTS = (first_picture, steps, clicks, steps_hd, steps_4k)


def show(found: Row) -> bool:
    """Print one row; whether the goal is reached."""
    goal, limit, reached, ok = found
    load = os.getloadavg()[0]
    print(f"{goal:<50} {limit:<10} {reached:<24} {load:4.1f}{'' if ok else '   <-- missed'}", flush=True)
    return ok


def opened(browser: Browser, url: str, client: Client, folder: Path) -> Ground:
    """Signs the browser in."""
    context = browser.new_context(base_url=url)
    page = context.new_page()
    page.goto(sign_in_link(folder))
    page.wait_for_url(lambda address: "sign-in" not in address)
    state = context.storage_state()
    context.close()
    survey_id = client.get("/session")["demo_survey_id"]
    recordings = client.get(f"/surveys/{survey_id}/recordings")
    day = next(one["id"] for one in recordings if one["lighting"] == "daytime")
    return Ground(browser, url, state, client, folder, survey_id, day)


def main(wanted: list[str]) -> int:
    results = []
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as name:
        folder = Path(name)
        print(f"{'goal':<50} {'limit':<10} {'median':<24} load")
        made = prepare(folder)
        if made is not None:
            results.append(show(row("demonstration survey made, server start included", 60, "s", made)))
        if not wanted or "cold_start" in wanted:
            started = cold_starts(folder)
            results.append(show(row("cold start to the first answer", 3, "s", median_ms(started) / 1000)))
        with serving("serve", folder) as server, chromium() as browser:
            client = signed_in(server, folder)
            time.sleep(2)  # the worker has started
            ground = opened(browser, server.url, client, folder)
            for part in PARTS:
                if not wanted or part.__name__ in wanted:
                    results += [show(one) for one in part(ground)]
    missed = results.count(False)
    print(f"{missed} goals missed" if missed else "every goal reached")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
