"""Makes the weights of the networks that propose points: drawn vehicles in, two ONNX files out.

    python -m tests.bench.train_proposals draw FOLDER FIRST COUNT   draw sites (10 s of processor time each)
    python -m tests.bench.train_proposals lay FOLDER OUT.npz        lay out what the networks are shown
    python -m tests.bench.train_proposals fit coarse OUT.npz ...    train one, write its weights
    python -m tests.bench.train_proposals fit fine OUT.npz ...

Only `fit` wants PyTorch (2.13, the processor is enough) and onnx beside the project's own packages; the
application runs the weights by OpenCV. Seeds and their order are fixed; sums on other machines differ in the
last places.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from sightline.geometry.camera import Camera
from sightline.geometry.road_pose import RoadPose
from sightline.media.networks import WEIGHTS
from sightline.proposals.canvas import Canvas, lay_on_canvas
from sightline.proposals.keypoints import (
    COARSE_STEP,
    FINE_POINTS,
    FINE_STEP,
    POINTS,
    coarse_canvas,
    fine_canvas,
    plane_point,
)
from tests.bench.proposal_drawings import FIRST_SEED, file_of

ASTRAY = 0.08  # share of the fine views that are laid out about another place
OFF_M = 0.07
VIEWS = 2
COARSE_ARRAYS = ("coarse", "places", "coarse_seed")
FINE_ARRAYS = ("fine", "kind", "place", "fine_seed")


def lay(folder: Path, out: Path) -> None:
    """What both networks are shown of every drawn vehicle, and what is true of it."""
    coarse: list[Any] = []
    fine: list[Any] = []
    for path in sorted(folder.glob("*.pickle")):
        rng = np.random.default_rng((int(path.stem), 79))
        document = pickle.loads(path.read_bytes())
        pose = _pose(document["camera"])
        level, tolerance = (one.astype(np.float32) for one in document["road"])
        for frame in document["frames"].values():
            coded = np.frombuffer(frame["jpeg"], np.uint8)
            picture = np.asarray(cv2.imdecode(coded, cv2.IMREAD_COLOR), np.uint8)
            gray = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY).astype(np.float32)
            change = np.abs(gray - level) / tolerance
            for one in frame["vehicles"]:
                view = _coarse_view(pose, picture, change, one, rng)
                if view is not None:
                    coarse.append((*view, int(path.stem)))
                fine += [(*v, int(path.stem)) for v in _fine_views(pose, picture, change, one, rng)]
        print(path.stem, len(coarse), len(fine), flush=True)
    np.savez(
        out,
        coarse=np.stack([one[0] for one in coarse]),
        places=np.stack([one[1] for one in coarse]),
        coarse_seed=np.array([one[2] for one in coarse]),
        fine=np.stack([one[0] for one in fine]),
        kind=np.array([one[1] for one in fine]),
        place=np.stack([one[2] for one in fine]),
        fine_seed=np.array([one[3] for one in fine]),
    )


def _pose(c: Any) -> RoadPose:
    bend = np.array(c.distortion)
    lens = Camera("drawn", c.width_px, c.height_px, "brown", c.fx_px, c.fy_px, c.cx_px, c.cy_px, bend)
    return RoadPose(lens, c.rotation(), c.translation_m())


def _coarse_view(pose: RoadPose, picture: Any, change: Any, one: Any, rng: np.random.Generator) -> Any:
    """A view (4, rows, columns) and the cell of each point (6, 2), NaN where it is not seen."""
    away = one["side_m"] - float(pose.centre_m[1])
    y = float(pose.centre_m[1]) + max(1.2, away * (1 + float(np.clip(rng.normal(-0.02, 0.05), -0.15, 0.12))))
    box = np.clip(one["box"], 0, [picture.shape[1], picture.shape[0]] * 2) + rng.normal(0, 6, 4)
    canvas = coarse_canvas(pose, tuple(box), y, one["direction"])
    if canvas is None:
        return None
    cells = [_cell(pose, canvas, one, name) for name in POINTS]
    return lay_on_canvas(canvas, picture, change, pose).astype(np.float16), np.array(cells, np.float32)


def _cell(pose: RoadPose, canvas: Canvas, one: Any, name: str) -> tuple[float, float]:
    if name not in one["seen"]:
        return np.nan, np.nan
    x, z = plane_point(pose, one["pixels"][name], canvas.y_m)
    column, row = canvas.cell(canvas.ahead * x, z)
    inside = 0 <= column <= canvas.size[0] - 1 and 0 <= row <= canvas.size[1] - 1
    return (float(column), float(row)) if inside else (np.nan, np.nan)


def _fine_views(
    pose: RoadPose, picture: Any, change: Any, one: Any, rng: np.random.Generator
) -> Iterator[Any]:
    """Views (4, FINE_SIZE, FINE_SIZE), which point, and its cell (2,)."""
    ahead = one["direction"]
    for k, name in enumerate(FINE_POINTS):
        if name not in one["pixels"]:
            continue
        seen = name in one["seen"]
        y = one["side_m"] + float(rng.normal(0, 0.03))
        x, z = plane_point(pose, one["pixels"][name], y)
        for _ in range(VIEWS if seen else 1):
            off = rng.normal(0, OFF_M, 2).clip(-0.19, 0.19)
            if name == "roof":
                off[0] *= 2
            if rng.uniform() < ASTRAY:
                off = rng.uniform(0.3, 1.0, 2) * rng.choice((-1, 1), 2)
            canvas = fine_canvas(name, ahead * x + off[0], z + off[1], y, ahead)
            cell = _cell(pose, canvas, one, name)
            yield (
                lay_on_canvas(canvas, picture, change, pose).astype(np.float16),
                k,
                np.array(cell, np.float32),
            )


def fit(which: str, paths: Sequence[Path]) -> None:
    """Train one of both networks and write its weights."""
    from tests.bench.proposal_networks import trained  # PyTorch, not among the project's packages

    WEIGHTS.mkdir(exist_ok=True)
    parts = [np.load(path) for path in paths]
    names = COARSE_ARRAYS if which == "coarse" else FINE_ARRAYS
    data = {name: np.concatenate([part[name] for part in parts]) for name in names}
    trained(which, data, COARSE_STEP, FINE_STEP, WEIGHTS)


if __name__ == "__main__":
    work, folder = sys.argv[1], Path(sys.argv[2])
    cv2.setNumThreads(1)
    if work == "draw":
        for seed in range(FIRST_SEED + int(sys.argv[3]), FIRST_SEED + int(sys.argv[3]) + int(sys.argv[4])):
            print(file_of(seed, folder), flush=True)
    elif work == "lay":
        lay(folder, Path(sys.argv[3]))
    else:
        fit(sys.argv[2], [Path(one) for one in sys.argv[3:]])
