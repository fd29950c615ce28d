"""What snapping does to contact clicks: how often it moves one to a worse place, on drawn surveys.

    python -m tests.bench.bench_snap [every]             sites on which reach and trust were set
    python -m tests.bench.bench_snap --held-out [every]  sites on which nothing was set

Clicks on the contacts of wheels in full view: careful (1 px in x and y), hasty (3 px), and aimed 0 to 30 px
above the contact (3 px across); careful ones where a nearer vehicle covers the contact and a person guesses
its place; and stray ones, anywhere in the lower half of the picture, which mean no wheel (for those `wrong`
is a snap at all, and `right` one within 2 px of some contact). `right`: within 2 px of the contact. `worse`:
farther from the contact than the click was; `by 1 px`: by more than that. All by the function that the server
asks.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass, field

import cv2
import numpy as np

from sightline.geometry.snap import Snap, snap
from tests.bench.bench_contact import _covers
from tests.bench.surveys import boxes_of, pose_of, site
from tests.simulation import truth
from tests.simulation.render import render_frame
from tests.simulation.scene import Scene

SETTING = (503, 504, 505, 506, 507, 509)
HELD_OUT = (601, 602, 603, 604, 605, 606)
FRAMES_A_WHEEL = 3
RIGHT_PX, WORSE_PX = 2.0, 1.0
Place = tuple[float, float]


@dataclass(eq=False)
class Tally:
    """Errors of clicks (n,) and of where they went, px; `asked` clicks in all."""

    asked: int = 0
    clicked_px: list[float] = field(default_factory=list)
    snapped_px: list[float] = field(default_factory=list)

    def words(self) -> str:
        before, after = np.array(self.clicked_px), np.array(self.snapped_px)
        right, worse = int(np.sum(after <= RIGHT_PX)), int(np.sum(after > before))
        much = int(np.sum(after > before + WORSE_PX))
        largest = f"{after.max():.1f}" if len(after) else "-"
        return (
            f"{self.asked:4} clicks  snapped {len(after):4}  right {right:4}  worse {worse:3}  "
            f"by {WORSE_PX:.0f} px {much:2}  largest error {largest} px"
        )


def clicks_at(spot: Place, covered: bool, rng: np.random.Generator) -> Iterator[tuple[str, Place]]:
    """What people may click for a contact."""
    x, y = spot
    kinds = (
        {"covered": rng.normal(0, 1, 2)}
        if covered
        else {
            "careful": rng.normal(0, 1, 2),
            "hasty": rng.normal(0, 3, 2),
            "above": np.array([rng.normal(0, 3), -rng.uniform(0, 30)]),
        }
    )
    for kind, (across, down) in kinds.items():
        yield kind, (x + across, y + down)


def spots(scene: Scene, every: int) -> Iterator[tuple[int, Place, bool, list[Place]]]:
    """(frame, contact, whether it is covered, all contacts of that frame) of every so many vehicles."""
    boxes = {one.number: boxes_of(scene.camera, one) for one in scene.vehicles}
    sides = {one.number: one.side_plane_m for one in scene.vehicles}
    contacts: dict[int, list[Place]] = {}
    for one in truth(scene):
        for seen in one.frames:
            some = [px for name, px in seen.pixels.items() if name.startswith("contact")]
            contacts.setdefault(seen.frame, []).extend(some)
    for one in truth(scene)[::every]:
        number = one.vehicle.number
        nearer = [boxes[other] for other in boxes if sides[other] < sides[number]]
        for name in ("contact_rear", "contact_front"):
            seen_on = [(one.frame, one.pixels[name]) for one in one.frames if name in one.pixels]
            for covered, count in ((False, FRAMES_A_WHEEL), (True, 1)):
                some_on = [
                    (n, at) for n, at in seen_on if any(_covers(b.get(n), at) for b in nearer) == covered
                ]
                step = max(1, len(some_on) // count)
                for n, at in some_on[step // 2 :: step][:count]:
                    yield n, at, covered, contacts[n]


def measured(seed: int, every: int, tallies: dict[str, Tally]) -> None:
    """Adds what comes out for a site."""
    scene, rng = site(seed), np.random.default_rng(seed)
    pose = pose_of(scene)
    width, height = scene.camera.width_px, scene.camera.height_px
    for frame, at, covered, all_ in spots(scene, every):
        gray = cv2.cvtColor(render_frame(scene, frame), cv2.COLOR_BGR2GRAY)
        asked = list(clicks_at(at, covered, rng))
        asked.append(("stray", (rng.uniform(0, width), rng.uniform(height / 2, height))))
        for kind, click in asked:
            tally = tallies.setdefault(kind, Tally())
            tally.asked += 1
            found = snap(gray, pose, click)
            if not isinstance(found, Snap):
                continue
            meant = all_ if kind == "stray" else [at]
            tally.clicked_px.append(_nearest(click, meant))
            tally.snapped_px.append(_nearest(found.contact_px, meant))


def _nearest(place: Place, some: list[Place]) -> float:
    return min(float(np.hypot(place[0] - x, place[1] - y)) for x, y in some)


def main() -> None:
    numbers = [int(one) for one in sys.argv[1:] if one.isdigit()]
    tallies: dict[str, Tally] = {}
    for seed in HELD_OUT if "--held-out" in sys.argv else SETTING:
        measured(seed, numbers[0] if numbers else 2, tallies)
        print(f"site {seed} done", flush=True)
    for kind, tally in tallies.items():
        print(f"{kind:8} {tally.words()}")


if __name__ == "__main__":
    main()
