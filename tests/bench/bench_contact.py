"""Error of the contact assistant against the truth of drawn surveys, by day and in low light.

    python -m tests.bench.bench_contact [every]          the demonstration, on which its limits were set
    python -m tests.bench.bench_contact --sites [every]  twelve other surveys: other cameras, light, meetings

Prints, for a pointer up to 8 px off in x and y: wheels in full view, share refused, median, 90 % and largest
error, bias (found minus true, x to the right and y down), and the root mean square of error over what was
expected (1 where the expected error is honest).
"""

import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.geometry.contact import Proposal, propose
from tests.bench.surveys import HELD_OUT, TRAINING, boxes_of, pose_of, site
from tests.simulation import truth
from tests.simulation.render import render_frame
from tests.simulation.scene import Scene, day_scene, low_light_scene

POINTER_PX = 8.0
FRAMES_A_WHEEL = 3
_BESIDE_PX = 8.0
Spot = tuple[int, str, tuple[float, float]]


@dataclass(eq=False)
class Tally:
    """What came out for some wheels: error (x, y) over expected, refusals, seconds."""

    off_px: list[tuple[float, float]] = field(default_factory=list)
    expected_px: list[float] = field(default_factory=list)
    refused: int = 0
    took_s: float = 0.0

    def add(self, other: "Tally") -> None:
        self.off_px += other.off_px
        self.expected_px += other.expected_px
        self.refused += other.refused
        self.took_s += other.took_s

    def words(self) -> str:
        count = len(self.off_px) + self.refused
        if not self.off_px:
            return f"{count:4} wheels  all refused"
        off = np.array(self.off_px)
        error = np.hypot(*off.T)
        median, ninety, most = np.percentile(error, [50, 90, 100])
        x, y = np.median(off, axis=0)
        ratio = float(np.sqrt(np.mean((error / np.array(self.expected_px)) ** 2)))
        return (
            f"{count:4} wheels  refused {self.refused / count:5.1%}  median {median:.2f} px  "
            f"90 % {ninety:.2f}  largest {most:.2f}  bias {x:+.2f}, {y:+.2f}  over expected {ratio:.2f}  "
            f"{1000 * self.took_s / count:.0f} ms each"
        )


def measured(scene: Scene, every: int) -> Tally:
    """Every so many vehicles of a scene."""
    tally, pose, rng = Tally(), pose_of(scene), np.random.default_rng(0)
    for frame, _, (x, y) in _spots(scene, every):
        gray = cv2.cvtColor(render_frame(scene, frame), cv2.COLOR_BGR2GRAY)
        began = time.perf_counter()
        found = propose(gray, pose, np.array([x, y]) + rng.uniform(-POINTER_PX, POINTER_PX, 2))
        tally.took_s += time.perf_counter() - began
        if isinstance(found, Proposal):
            tally.off_px.append((found.contact_px[0] - x, found.contact_px[1] - y))
            tally.expected_px.append(found.expected_px)
        else:
            tally.refused += 1
    return tally


def _spots(scene: Scene, every: int) -> Iterator[Spot]:
    """Contacts that no other vehicle stands before, FRAMES_A_WHEEL of each wheel."""
    boxes = {one.number: boxes_of(scene.camera, one) for one in scene.vehicles}
    sides = {one.number: one.side_plane_m for one in scene.vehicles}
    for one in truth(scene)[::every]:
        number = one.vehicle.number
        nearer = [boxes[other] for other in boxes if sides[other] < sides[number]]
        for name in ("contact_rear", "contact_front"):
            frames = [(seen.frame, seen.pixels[name]) for seen in one.frames if name in seen.pixels]
            clear = [(n, at) for n, at in frames if not any(_covers(all_.get(n), at) for all_ in nearer)]
            step = max(1, len(clear) // FRAMES_A_WHEEL)
            for n, (x, y) in clear[step // 2 :: step][:FRAMES_A_WHEEL]:
                yield n, name, (float(x), float(y))


def _covers(box: Sequence[float] | None, at: Sequence[float]) -> bool:
    if box is None:
        return False
    (x, y), (left, top, right, bottom) = at, box
    return left - _BESIDE_PX <= x <= right + _BESIDE_PX and top - _BESIDE_PX <= y <= bottom + _BESIDE_PX


def demonstration(every: int) -> None:
    for scene in (day_scene(), low_light_scene()):
        print(f"{scene.name:10} {measured(scene, every).words()}", flush=True)


def sites(every: int) -> None:
    together = {"daytime": Tally(), "low light": Tally()}
    for seed in (*TRAINING, *HELD_OUT):
        scene = site(seed)
        light, found = "low light" if scene.light.low else "daytime", measured(scene, every)
        together[light].add(found)
        print(f"site {seed} ({light:9}) {found.words()}", flush=True)
    for light, all_ in together.items():
        print(f"all, {light:9}      {all_.words()}")


if __name__ == "__main__":
    numbers = [int(one) for one in sys.argv[1:] if one.isdigit()]
    work = sites if "--sites" in sys.argv else demonstration
    work(numbers[0] if numbers else 1)
