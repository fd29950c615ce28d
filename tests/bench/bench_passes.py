"""Vehicle passes found in drawn videos against their truth: recall, precision, speed, spans, best frames.

    python -m tests.bench.bench_passes             the demonstration's two videos
    python -m tests.bench.bench_passes --sites     twelve other surveys, in which vehicles meet and are hidden
    python -m tests.bench.bench_passes --baseline  the held-out surveys by OpenCV's MOG2 and KNN, and by ours
    python -m tests.bench.bench_passes --real FOLDER  the shared real clips, against spans read off them
    python -m tests.bench.bench_passes VIDEO ...   a contact sheet of the best frames, in .build/passes

`--sites` draws its videos into .build/passes first, about a minute each. Of the sites, six were looked at
while the search was made (training), six were not (held out). Speed is process CPU time of one thread over
the recording's length.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from time import process_time
from typing import Any, get_args

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
cv2.setNumThreads(1)

from sightline.demo.made import FOLDER, TRUTH  # noqa: E402
from sightline.detection.classify import FoundPass  # noqa: E402
from sightline.media.store.local import sha256_of  # noqa: E402
from sightline.media.video.decode import frames_of  # noqa: E402
from sightline.media.video.passes import find_passes  # noqa: E402
from sightline.vehicles.passes.find_job import square_at  # noqa: E402
from tests.bench import pass_baseline  # noqa: E402
from tests.bench.goals import Row, report, row  # noqa: E402
from tests.bench.surveys import HELD_OUT, TRAINING, Passing, passings, pose_of, site, video_of  # noqa: E402

LEAST_OVERLAP = 0.5
TILE_PX = 320
BUILD = ROOT / ".build" / "passes"


@dataclass(frozen=True)
class Counted:
    """One video searched: pairs of found and true passes, how many there were of each, and how fast."""

    pairs: list[tuple[FoundPass, Passing]]
    found: int
    true: int
    speed: float

    @property
    def recall(self) -> float:
        return len(self.pairs) / self.true

    @property
    def precision(self) -> float:
        return len(self.pairs) / max(1, self.found)

    def words(self) -> str:
        """Spans and best frames in one line."""
        ends = [(one.first_frame - t.first_frame, one.last_frame - t.last_frame) for one, t in self.pairs]
        errors = np.abs(ends)
        whole = [(one.best_frame, t.whole) for one, t in self.pairs if t.whole]
        on = sum(span[0] <= n <= span[1] for n, span in whole)
        return (
            f"spans off by {errors.mean():.1f} frames, 90 % {np.percentile(errors, 90):.0f}, "
            f"most {errors.max()}; whole on the best frame {on}/{len(whole)}; {self.speed:.1f} x real time"
        )


def overlap(one: FoundPass, true: Passing) -> float:
    """Shared frames over all frames of both spans; 0 where they go opposite ways."""
    if one.direction != ("right" if true.direction > 0 else "left"):
        return 0.0
    shared = min(one.last_frame, true.last_frame) - max(one.first_frame, true.first_frame) + 1
    both = max(one.last_frame, true.last_frame) - min(one.first_frame, true.first_frame) + 1
    return max(0.0, shared / both)


def counted(
    path: Path, truth: list[Passing], fps: float, square: float, method: pass_baseline.Method | None = None
) -> Counted:
    """Search a video; each true pass is paired with the found one that covers it best, none twice."""
    started = process_time()
    if method is None:
        search = find_passes(path, square_at=square)
        found, frames = search.passes, search.frames
    else:
        found, frames = pass_baseline.find_passes(path, method)
    speed = frames / fps / (process_time() - started)
    left, pairs = list(found), []
    for true in truth:
        best = max(left, key=lambda one: overlap(one, true), default=None)
        if best is not None and overlap(best, true) >= LEAST_OVERLAP:
            left.remove(best)
            pairs.append((best, true))
    return Counted(pairs, len(found), len(truth), speed)


def rows_of(name: str, one: Counted) -> Iterator[Row]:
    pairs = f"{one.recall:.3f} ({len(one.pairs)}/{one.true})"
    yield row(f"{name}: recall", "0.98", pairs, one.recall >= 0.98)
    yield row(f"{name}: precision", "0.9", f"{one.precision:.3f} of {one.found}", one.precision >= 0.9)
    yield row(f"{name}: faster than real time", "5 x", f"{one.speed:.1f} x", one.speed >= 5)
    yield row(f"{name}: in view", "-", one.words(), True)


def demonstration() -> Iterator[Row]:
    truth = json.loads(TRUTH.read_text())["scenes"]
    for name, scene in truth.items():
        true = [_passing(one) for one in scene["passes"]]
        yield from rows_of(name, counted(FOLDER / scene["video"], true, scene["fps"], 0.5))


def _passing(one: dict[str, Any]) -> Passing:
    whole = one["first_whole_frame"], one["last_whole_frame"]
    return Passing(
        one["number"], one["category"], one["lane"], one["direction"], one["speed_mps"],
        one["first_frame"], one["last_frame"], None if None in whole else whole, 0.0,
    )  # fmt: skip


def baselines() -> Iterator[Row]:
    """The same held-out surveys by what a library gives, and by ours."""
    for method in (None, *get_args(pass_baseline.Method)):
        every = []
        for seed in HELD_OUT:
            scene = site(seed)
            path = video_of(scene, BUILD)
            every.append(counted(path, passings(scene), scene.fps, square_at(pose_of(scene)), method))
        pairs, found = sum(len(one.pairs) for one in every), sum(one.found for one in every)
        recall, precision = pairs / sum(one.true for one in every), pairs / max(1, found)
        words = f"recall {recall:.3f}, precision {precision:.3f}, slowest {min(o.speed for o in every):.1f} x"
        yield row(f"held out, {method or 'ours'}", "-", words, True)


def sites() -> Iterator[Row]:
    for group, seeds in (("training", TRAINING), ("held out", HELD_OUT)):
        every = []
        for seed in seeds:
            scene = site(seed)
            one = counted(video_of(scene, BUILD), passings(scene), scene.fps, square_at(pose_of(scene)))
            every.append(one)
            light = "low light" if scene.light.low else "daytime"
            told = f"recall {one.recall:.3f}, precision {one.precision:.3f}; {one.words()}"
            print(f"{group} {seed} ({light}, {one.true} passes): {told}", flush=True)
        pairs = [pair for one in every for pair in one.pairs]
        found, true = sum(one.found for one in every), sum(one.true for one in every)
        yield from rows_of(group, Counted(pairs, found, true, min(one.speed for one in every)))
        clear = [one for seed in seeds for one in passings(site(seed)) if not one.hidden]
        seen = sum(not true.hidden for _, true in pairs) / len(clear)
        yield row(f"{group}: recall, never hidden", "0.98", f"{seen:.3f} of {len(clear)}", seen >= 0.98)


# First and last frame of every vehicle in view, read off the pictures; a train is one.
REAL: dict[str, list[tuple[int, int]]] = {
    "video/car-detection.mp4": [(56, 117), (177, 227), (189, 244), (312, 355)],
    "video/cars_truck_roadside.mp4": [(0, 59), (0, 59)],
    "video/cars_truck_roadside_rotate90.mov": [(0, 59), (0, 59)],
    "linescan/train_day.mp4": [(20, 155)],
    "linescan/train_snow.mp4": [(0, 83)],
    "linescan/train_platform_portrait_vfr.mov": [(12, 414)],
    "video/odd/vtest_msmpeg4.avi": [],
    "video/odd/tree_cinepak_vfr.avi": [],
    "video/odd/smallcar_unordered_pts.mp4": [],
    "calibration/clip_screen_board/chessboard.mp4": [],
}


def real(folder: Path) -> None:
    """Recall and precision on real clips: a vehicle is found where half of both spans is shared."""
    hits = true = count = 0
    for name, spans in REAL.items():
        search = find_passes(folder / name)
        left = list(search.passes)
        for first, last in spans:
            best = max(left, key=lambda one: _shared(one, first, last), default=None)
            if best is not None and _shared(best, first, last) >= LEAST_OVERLAP:
                left.remove(best)
        found = len(search.passes)
        print(f"{name}: {found - len(left)} of {len(spans)}, {len(left)} false", *search.notes, flush=True)
        hits, true, count = hits + found - len(left), true + len(spans), count + found
    print(f"recall {hits / true:.2f}, precision {hits / max(1, count):.2f}")


def _shared(one: FoundPass, first: int, last: int) -> float:
    shared = min(one.last_frame, last) - max(one.first_frame, first) + 1
    return shared / (max(one.last_frame, last) - min(one.first_frame, first) + 1)


def sheet(path: Path) -> None:
    """Best frames of a video as one picture, and what was found in words."""
    started = process_time()
    search = find_passes(path)
    found, frames = search.passes, search.frames
    print(f"{path.name} ({sha256_of(path)[:12]}): {len(found)} passes in {frames} frames,", end=" ")
    print(f"{process_time() - started:.1f} s of one core", *search.notes)
    wanted = {one.best_frame: one for one in found}
    tiles = []
    for n, _pts, gray in frames_of(path):
        if n not in wanted:
            continue
        one = wanted[n]
        _, x0, y0, x1, y1 = next(box for box in one.boxes if box[0] == n)
        picture = cv2.cvtColor(gray, cv2.COLOR_GRAY2BGR)
        cv2.rectangle(picture, (int(x0), int(y0)), (int(x1), int(y1)), (0, 200, 255), 2)
        height = round(TILE_PX * gray.shape[0] / gray.shape[1])
        tile = cv2.resize(picture, (TILE_PX, height), interpolation=cv2.INTER_AREA)
        words = f"{one.first_frame}-{one.last_frame} best {n} {one.direction} {one.score:.2f}"
        tiles.append(cv2.putText(tile, words, (4, 16), 0, 0.45, (0, 200, 255), 1))
        print(" ", words, "whole" if one.whole else "cut off")
    if tiles:
        blank = np.zeros_like(tiles[0])
        tiles += [blank] * (-len(tiles) % 4)
        BUILD.mkdir(parents=True, exist_ok=True)
        rows = [np.hstack(tiles[i : i + 4]) for i in range(0, len(tiles), 4)]
        cv2.imwrite(str(BUILD / f"{path.stem}.png"), np.vstack(rows))


if __name__ == "__main__":
    if sys.argv[1:] == ["--sites"]:
        raise SystemExit(report([sites], []))
    if sys.argv[1:] == ["--baseline"]:
        raise SystemExit(report([baselines], []))
    if sys.argv[1:2] == ["--real"]:
        real(Path(sys.argv[2]))
    elif len(sys.argv) > 1:
        for argument in sys.argv[1:]:
            sheet(Path(argument))
    else:
        raise SystemExit(report([demonstration], []))
