"""What the metrology benches share: scenes, timing, and the table of goal, limit and reached."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from time import perf_counter

import numpy as np

from sightline.geometry.board import Board
from tests.geometry.simulate import Lens, Scene

BOARD = Board(6, 4, 0.1)
Row = tuple[str, str, str, bool]


def row(goal: str, limit: str, reached: str, ok: bool) -> Row:
    return goal, limit, reached, ok


def best_s(action: Callable[[], object], repeats: int = 5) -> float:
    """Fastest of several runs."""
    times = []
    for _ in range(repeats):
        start = perf_counter()
        action()
        times.append(perf_counter() - start)
    return min(times)


def rms(values: object) -> float:
    return float(np.sqrt(np.mean(np.square(np.asarray(values, dtype=float)))))


def facing(yaw: float, distance: float, seed: int = 0, lens: Lens | None = None) -> Scene:
    x = 0.25 - distance * np.tan(np.radians(yaw)) + 0.013 * seed
    return Scene(lens or Lens(), (x, -distance, 1.4 + 0.007 * seed), yaw, 4 + 0.3 * seed, 1.0 + seed)


def truth_of(scene: Scene, top_m: float = 1.5) -> np.ndarray:
    return scene.look(scene.board(6, 4, 0.1, top_m).reshape(-1, 3)).reshape(4, 6, 2)


def report(parts: Sequence[Callable[[], Iterator[Row]]], wanted: Sequence[str]) -> int:
    """Print the rows of all parts, or of those `wanted` by name."""
    missed = 0
    print(f"{'goal':<62} {'limit':<20} reached")
    for part in parts:
        if wanted and part.__name__ not in wanted:
            continue
        for goal, limit, reached, ok in part():
            missed += not ok
            print(f"{goal:<62} {limit:<20} {reached}{'' if ok else '   <-- missed'}", flush=True)
    print(f"{missed} goals missed" if missed else "every goal reached")
    return 0
