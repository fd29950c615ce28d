"""Draws the files of the demonstration anew: `python -m tests.simulation.make`, some minutes.

They lie in the product, so that a first start has nothing to draw; `test_made.py` holds them against what is
drawn.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, replace
from itertools import repeat
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from sightline.demo.made import FOLDER, LINES, TRUTH, Model
from sightline.demo.scan import RIG
from sightline.media.video.writer import write_mp4
from tests.simulation.board import LAB_COLUMNS, LAB_COUNT, LAB_ROWS, LAB_SQUARE_M, lab_image
from tests.simulation.camera import Image
from tests.simulation.models import MODELS
from tests.simulation.render import render_frame
from tests.simulation.scan_rod import HeldRod, row_of
from tests.simulation.scan_strips import CHUNK, recording
from tests.simulation.scan_traffic import ScanSite, ScanTruth, demo_traffic, truths
from tests.simulation.scene import Scene, day_scene, low_light_scene
from tests.simulation.truth import TARGETS, spots_of, truth_document

VIDEO_CRF, LAB_QUALITY, STRIP_QUALITY = 21, 92, 95
DIGITS = 6
VIDEOS = {"day": "daytime.mp4", "low_light": "low-light.mp4"}
# Quiet cameras: grain costs most of a JPEG, and coarser ones leave seams every 8 lines that match each other.
SITE = ScanSite(
    rows=256,
    line_rate_hz=RIG.line_rate_hz,
    misalignment_px=0.6,
    seed=11,
    plane_m=3.0,
    read_noise_dn=0.8,
    shot_dn2_per_dn=0.006,
)
# Held up before the first vehicle: the nearest at which its foot and top are in the field, and the far edge.
RODS = (HeldRod(2.7, 1.3, 2.0), HeldRod(4.5, 2.9, 3.6))
SCAN_VEHICLES = demo_traffic()[:9]
_MARGIN_ROWS = 4.0


def first_of(scene: Scene, vehicles: int) -> Scene:
    """A scene that ends when so many have passed."""
    kept = scene.vehicles[:vehicles]
    return replace(scene, vehicles=kept, frames=kept[-1].last_frame + 1)


def scenes() -> dict[str, Scene]:
    """The demonstration's two videos: the board, then some vehicles."""
    return {"day": first_of(day_scene(), 9), "low_light": first_of(low_light_scene(), 7)}


def lab_name(index: int) -> str:
    """The file of a laboratory image."""
    return f"lab-{index + 1:02d}.jpg"


def strip_name(camera: int, block: int) -> str:
    """The file of a block of LINES lines of a strip."""
    return f"strip-{camera}-{block + 1}.jpg"


def contact_of(site: ScanSite, true: ScanTruth) -> tuple[float, float]:
    """(line, row) in strip 1 where the rear wheel stands on the road."""
    assert site.plane_m is not None
    return true.wheel_lines_1[1], row_of(site, site.plane_m, 0.0)


def targets_of(site: ScanSite, true: ScanTruth) -> dict[str, tuple[float, float]]:
    """(line, row) in strip 1 of each target that the field of view holds."""
    assert site.plane_m is not None
    found: dict[str, tuple[float, float]] = {}
    for spot in spots_of(true.vehicle.vehicle):
        row = row_of(site, site.plane_m + spot.inset_m, spot.height_m)
        if spot.name in TARGETS and row > _MARGIN_ROWS:
            time_s = true.vehicle.time_s(true.vehicle.length_m - spot.along_m)
            found[spot.name] = (time_s * site.line_rate_hz, row)
    return found


def held_rods(site: ScanSite) -> list[dict[str, Any]]:
    """The rods as they are seen: a line at which each stands, and the rows of its marks."""
    return [
        {
            "distance_m": rod.distance_m,
            "line": (rod.from_s + rod.to_s) / 2 * site.line_rate_hz,
            "marks": [[height_m, row_of(site, rod.distance_m, height_m)] for height_m in rod.marks_m],
        }
        for rod in RODS
    ]


def _scan_vehicle(true: ScanTruth) -> dict[str, Any]:
    body, model = true.vehicle.vehicle, true.vehicle.vehicle.model
    return {
        "make": model.make,
        "model": model.model,
        "year": body.year,
        "category": model.category,
        "length_m": model.length_m,
        "wheelbase_m": model.wheelbase_m,
        "speed_mps": true.vehicle.speed_mps,
        "front_line_1": true.front_line_1,
        "wheel_lines_1": true.wheel_lines_1,
        "contact": contact_of(SITE, true),
        "targets": targets_of(SITE, true),
        "true_heights_m": {s.name: s.height_m for s in spots_of(body) if s.name in TARGETS},
    }


def document() -> dict[str, Any]:
    """All that is true of the files, as JSON values to so many digits."""
    known = Model.__dataclass_fields__
    made = {
        "models": [{key: value for key, value in asdict(one).items() if key in known} for one in MODELS],
        "lab": {"columns": LAB_COLUMNS, "rows": LAB_ROWS, "square_m": LAB_SQUARE_M},
        "scenes": {
            name: {"video": VIDEOS[name], **truth_document(scene)} for name, scene in scenes().items()
        },
        "scan": {
            "rods": held_rods(SITE),
            "vehicles": [_scan_vehicle(one) for one in truths(SITE, SCAN_VEHICLES)],
        },
    }
    rounded: dict[str, Any] = _rounded(made)
    return rounded


def _rounded(value: Any) -> Any:
    match value:
        case dict():
            return {key: _rounded(one) for key, one in value.items()}
        case list() | tuple():
            return [_rounded(one) for one in value]
        case float():
            return round(value, DIGITS) + 0.0  # no -0.0
    return value


def truth_json() -> str:
    """What is true of the files, as `truth.json` says it, a line for each frame."""
    return json.dumps(document(), separators=(",", ":")).replace('{"frame":', '\n{"frame":') + "\n"


def drawn_strips() -> tuple[Image, Image]:
    """Both strips (lines, rows)."""
    first, second = zip(*recording(SITE, SCAN_VEHICLES, rods=RODS), strict=True)
    return np.concatenate(first), np.concatenate(second)


def write_jpeg(path: Path, image: Image, quality: int) -> None:
    """One image as JPEG."""
    done, packed = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])
    assert done
    path.write_bytes(packed.tobytes())


def drawn_frames(scene: Scene, pool: ProcessPoolExecutor) -> Iterator[Image]:
    """All frames in order."""
    return pool.map(render_frame, repeat(scene, scene.frames), range(scene.frames), chunksize=24)


def make(folder: Path) -> None:
    """Draw every file into a folder."""
    assert LINES % CHUNK == 0
    folder.mkdir(exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    for index in range(LAB_COUNT):
        write_jpeg(folder / lab_name(index), lab_image(index), LAB_QUALITY)
    for camera, strip in enumerate(drawn_strips(), 1):
        for block, first in enumerate(range(0, len(strip), LINES)):
            write_jpeg(folder / strip_name(camera, block), strip[first : first + LINES], STRIP_QUALITY)
    with ProcessPoolExecutor() as pool:
        for name, scene in scenes().items():
            frames = drawn_frames(scene, pool)
            write_mp4(folder / VIDEOS[name], frames, scene.fps, crf=VIDEO_CRF, preset="slow")
    (folder / TRUTH.name).write_text(truth_json())


if __name__ == "__main__":
    make(FOLDER)
    print(f"{sum(one.stat().st_size for one in FOLDER.iterdir()) / 1e6:.1f} MB in {FOLDER}")
