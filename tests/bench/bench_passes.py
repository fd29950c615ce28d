"""Vehicle passes found in the demonstration's videos against their truth: recall, precision, speed, spans.

Needs a made demonstration survey: SIGHTLINE_DATA_DIR (default .data) with demonstration/truth.json. Speed is
process CPU time of one thread over the recording's length. More videos may be named as arguments: what is
found in them is printed, and a contact sheet of the best frames is written beside the current folder's
.build/passes.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from time import process_time
from typing import Any

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
cv2.setNumThreads(1)

from backend.media.decode import frames_of  # noqa: E402
from backend.media.passes import FoundPass, find_passes  # noqa: E402
from backend.media.store import sha256_of  # noqa: E402
from backend.settings import load_settings  # noqa: E402
from tests.bench.goals import Row, report, row  # noqa: E402

LEAST_OVERLAP = 0.5
TILE_PX = 320


def overlap(one: FoundPass, true: dict[str, Any]) -> float:
    """Shared frames over all frames of both spans; 0 where they go opposite ways."""
    if one.direction != ("right" if true["direction"] > 0 else "left"):
        return 0.0
    shared = min(one.last_frame, true["last_frame"]) - max(one.first_frame, true["first_frame"]) + 1
    both = max(one.last_frame, true["last_frame"]) - min(one.first_frame, true["first_frame"]) + 1
    return max(0.0, shared / both)


def matched(
    found: tuple[FoundPass, ...], truth: list[dict[str, Any]]
) -> list[tuple[FoundPass, dict[str, Any]]]:
    """Each true pass with the found one that covers it best; no found pass twice."""
    left, pairs = list(found), []
    for true in truth:
        best = max(left, key=lambda one: overlap(one, true), default=None)
        if best is not None and overlap(best, true) >= LEAST_OVERLAP:
            left.remove(best)
            pairs.append((best, true))
    return pairs


def scene_rows(name: str, path: Path, scene: dict[str, Any], square_at: float) -> Iterator[Row]:
    """Goals and what was reached in one scene."""
    truth = scene["passes"]
    started = process_time()
    found, frames = find_passes(path, square_at=square_at)
    speed = frames / scene["fps"] / (process_time() - started)
    pairs = matched(found, truth)
    recall, precision = len(pairs) / len(truth), len(pairs) / max(1, len(found))
    yield row(f"{name}: recall", "0.98", f"{recall:.3f} ({len(pairs)}/{len(truth)})", recall >= 0.98)
    yield row(f"{name}: precision", "0.9", f"{precision:.3f} of {len(found)}", precision >= 0.9)
    yield row(f"{name}: faster than real time", "5 x", f"{speed:.1f} x", speed >= 5)
    spans = [(one.first_frame - t["first_frame"], one.last_frame - t["last_frame"]) for one, t in pairs]
    worst = max(abs(error) for pair in spans for error in pair)
    mean = np.mean([abs(error) for pair in spans for error in pair])
    yield row(f"{name}: span error", "6 frames", f"worst {worst}, mean {mean:.1f}", worst <= 6)
    whole = [t["first_whole_frame"] <= one.best_frame <= t["last_whole_frame"] for one, t in pairs]
    yield row(f"{name}: whole on the best frame", "0.9", f"{sum(whole)}/{len(whole)}", np.mean(whole) >= 0.9)
    off = [abs(one.best_frame - t["best_frame"]) for one, t in pairs]
    yield row(
        f"{name}: best frame off the truth's", "-", f"median {np.median(off):.0f}, worst {max(off)}", True
    )


def demonstration() -> Iterator[Row]:
    settings = load_settings()
    path = settings.data_dir / "demonstration" / "truth.json"
    if not path.is_file():
        print(f"not measured: {path} is missing; run `sightline demo` once or name SIGHTLINE_DATA_DIR.")
        return
    truth = json.loads(path.read_text())
    lengths = {sum(1 for _ in frames_of(video)): video for video in Path(settings.media_url).rglob("*.mp4")}
    for name, scene in truth.items():
        yield from scene_rows(name, lengths[scene["frames"]], scene, 0.5)


def sheet(path: Path) -> None:
    """Best frames of a video as one picture, and what was found in words."""
    started = process_time()
    found, frames = find_passes(path)
    print(f"{path.name} ({sha256_of(path)[:12]}): {len(found)} passes in {frames} frames,", end=" ")
    print(f"{process_time() - started:.1f} s of one core")
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
        folder = ROOT / ".build" / "passes"
        folder.mkdir(parents=True, exist_ok=True)
        rows = [np.hstack(tiles[i : i + 4]) for i in range(0, len(tiles), 4)]
        cv2.imwrite(str(folder / f"{path.stem}.png"), np.vstack(rows))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        for argument in sys.argv[1:]:
            sheet(Path(argument))
    else:
        raise SystemExit(report([demonstration], []))
