"""Low-light vehicles for tests that need one of their own; the main journey takes the daytime ones."""

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from playwright.sync_api import Page

from .conftest import wait_for_demonstration
from .picture import on_screen
from .server import Server

TARGETS = ("roof", "driver_eye", "taillight")
Pixel = tuple[float, float]


@dataclass(frozen=True)
class Untouched:
    """A vehicle without measurements, and where its points are on a frame that shows them all."""

    survey: int
    vehicle: dict[str, Any]
    frame: int
    pixels: dict[str, Pixel]

    @property
    def address(self) -> str:
        recording = self.vehicle["recording_id"]
        return (
            f"/surveys/{self.survey}/measure?recording={recording}&vehicle={self.vehicle['id']}"
            f"&frame={self.frame}"
        )


def untouched(page: Page, server: Server) -> Untouched:
    """The last low-light vehicle that nobody has measured and whose three targets can all be seen."""
    page.goto("/")
    survey = wait_for_demonstration(page)
    night = json.loads((server.data_dir / "demonstration" / "truth.json").read_text())["low_light"]
    recordings = page.request.get(f"/api/surveys/{survey}/recordings").json()
    recording = next(r for r in recordings if r["lighting"] == "low_light")
    vehicles = page.request.get(f"/api/surveys/{survey}/vehicles?recording_id={recording['id']}").json()
    by_first_frame = {one["first_frame"]: one for one in night["passes"]}
    for vehicle in sorted(vehicles, key=lambda v: -int(v["number"])):
        one = by_first_frame.get(vehicle["first_frame"])
        if vehicle["measurements"] or vehicle["version"] != 1 or one is None:
            continue
        for frame in sorted(one["frames"], key=lambda f: abs(f["frame"] - one["best_frame"])):
            pixels = frame["pixels"]
            if {"contact_rear", *TARGETS} <= set(pixels) and not set(TARGETS) & set(frame["hidden"]):
                return Untouched(
                    survey, vehicle, frame["frame"], {k: (v[0], v[1]) for k, v in pixels.items()}
                )
    raise AssertionError("no low-light vehicle is left to measure")


def stored(page: Page, vehicle_id: int) -> dict[str, dict[str, Any]]:
    """What the server has of a vehicle and has not withdrawn, by target."""
    vehicle = page.request.get(f"/api/vehicles/{vehicle_id}").json()
    standing = [m for m in vehicle["measurements"] if not m["withdrawn"]]
    assert len(standing) == len({m["target"] for m in standing}), standing
    return {m["target"]: m for m in standing}


def until(page: Page, vehicle_id: int, wanted: Callable[[dict[str, dict[str, Any]]], bool]) -> None:
    """Waits until what the server has of a vehicle is as wanted."""
    end = time.monotonic() + 10
    while not wanted(have := stored(page, vehicle_id)):
        assert time.monotonic() < end, have
        page.wait_for_timeout(50)


def click_at(page: Page, pixel: Pixel) -> None:
    """Moves the pointer to an image pixel and clicks."""
    x, y = on_screen(page, pixel)
    page.mouse.move(x, y)
    page.mouse.click(x, y)
