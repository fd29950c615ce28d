"""Heights and overlays for a click: the one way from points to numbers.

What is shown while the pointer moves, what is stored, what an export contains and what a check recomputes
all come from `answer`, so they cannot differ. Nothing here reads or writes.
"""

import math
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Any

import numpy as np
from cachetools import LRUCache
from pydantic import Field

from sightline.enums import Category, DriverSide, Target
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.height import (
    BudgetEntry,
    Height,
    Parts,
    height_both,
    measure_height,
    measure_with_budgets,
    not_measurable,
)
from sightline.geometry.insets import SIDE_UNKNOWN, inset_name
from sightline.geometry.multiframe import MultiHeight, measure_frames
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.sides import FoundSide
from sightline.geometry.whole_pass import WholePass, measure_pass
from sightline.measurements.followed_text import read_text
from sightline.measurements.records import Clicks, HeightOfClicks
from sightline.messages.said import Said
from sightline.surveys.records import Inset

DEFAULT_SIGMA_PX = 1.0
# Insets are kept to the micrometre: that is what the CSV carries, so an export recomputes to the same figure.
_INSET_DECIMALS = 6
_MOST_POSES = 32
_MOST_SOLVED = 1024
SIDE_FROM_PLACE = Said("height-flag-side-from-place")


@dataclass(frozen=True)
class SingleFrame:
    """What the first frame alone would give, with the inset assumed: shown beside a several-frame height."""

    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Answer(HeightOfClicks):
    """A height as answered while clicking; the heading: of the vehicle's travel against the road's X axis."""

    frames: int = 1
    heading_rad: float | None = None
    u_heading_rad: float | None = None
    travel_m: float | None = None
    speed_mps: Annotated[float | None, Field(description="Of a whole pass, towards the road's +X.")] = None
    wheelbase_m: Annotated[float | None, Field(description="Of a whole pass with both tyres.")] = None
    u_wheelbase_m: float | None = None
    chance: Annotated[
        float | None, Field(description="Of a whole pass: that its points would disagree more by chance.")
    ] = None
    of_class: Annotated[
        bool,
        Field(
            description="False: such a target lies elsewhere on vehicles of the class; a slip, if clicked."
        ),
    ] = True
    single: Annotated[SingleFrame | None, Field(description="Beside a height from several frames.")] = None


class PoseCache:
    """Parsed poses by id. A stored pose never changes, so what was parsed once holds. Thread-safe."""

    def __init__(self, most: int = _MOST_POSES) -> None:
        self._poses: LRUCache[int, RoadPose] = LRUCache(most)
        self._lock = threading.Lock()

    def get(self, pose_id: int) -> RoadPose | None:
        with self._lock:
            return self._poses.get(pose_id)

    def put(self, pose_id: int, document: Mapping[str, Any]) -> RoadPose:
        """Parse a pose.json document and keep it. Raises BadInput naming a key that is wrong."""
        pose = pose_from_dict(document, f"camera pose {pose_id}")
        with self._lock:
            self._poses[pose_id] = pose
        return pose


def on_side(clicks: Clicks, side: FoundSide | None) -> Clicks:
    """Clicks on an eye with the side on which its driver sits, where they say none themselves."""
    if clicks.target != "driver_eye" or clicks.side is not None or side is None:
        return clicks
    return replace(clicks, side=side.side, side_from=side.basis)


def filled_in(
    clicks: Clicks, insets: Mapping[str, Inset], category: Category | None, own_sigma_px: float | None = None
) -> Clicks:
    """The clicks with what was left out: the person's own sigma, else 1 px, and the inset for this target and
    side on a vehicle of this class; there is none for an eye of which nobody knows the side.
    """
    usual = inset_for(clicks.target, clicks.side, category, insets)
    usual_sigma_px = DEFAULT_SIGMA_PX if own_sigma_px is None else own_sigma_px
    inset_m, u_inset_m = clicks.inset_m, clicks.u_inset_m
    if usual is not None:
        inset_m = usual.inset_m if inset_m is None else inset_m
        u_inset_m = usual.u_inset_m if u_inset_m is None else u_inset_m
    elif inset_m is not None and u_inset_m is None:
        u_inset_m = max(insets[name].u_inset_m for name in ("driver_eye_near", "driver_eye_far"))
    inset_m, u_inset_m = _rounded(inset_m), _rounded(u_inset_m if inset_m is not None else None)
    is_usual = inset_m is None or (usual is not None and _is_usual_inset(usual, inset_m, u_inset_m))
    return replace(
        clicks,
        sigma_px=usual_sigma_px if clicks.sigma_px is None else clicks.sigma_px,
        inset_m=inset_m,
        u_inset_m=u_inset_m,
        inset_from="usual" if is_usual else clicks.inset_from or "own",
    )


def _rounded(length_m: float | None) -> float | None:
    return None if length_m is None else round(length_m, _INSET_DECIMALS)


def _is_usual_inset(usual: Inset, inset_m: float, u_inset_m: float | None) -> bool:
    return (inset_m, u_inset_m) == (_rounded(usual.inset_m), _rounded(usual.u_inset_m))


def inset_for(
    target: Target, side: DriverSide | None, category: Category | None, insets: Mapping[str, Inset]
) -> Inset | None:
    """The survey's inset of a target of a vehicle; None for an eye of which nobody knows the side."""
    name = inset_name(target, side, category)
    return None if name is None else insets[name]


def answer(pose: RoadPose, clicks: Clicks) -> Answer:
    """The height of the target with its uncertainty, corrected for its inset and not.

    One frame assumes the inset; several solve for it. Where several frames give no height, none is given: the
    reason says why, and what the first frame alone would give stands in `single`. The uncorrected height is
    always the first frame's; an eye of unknown side has none of the two from one frame.
    """
    height, uncorrected = _first_frame(pose, clicks)
    if clicks.followed is not None:
        return _of_whole_pass(clicks, height, uncorrected, measured_pass(pose, clicks))
    if not clicks.more_frames:
        return _make_answer(clicks, height, uncorrected)
    measured = measured_frames(pose, clicks)
    alone = SingleFrame(height.height_m, height.u_height_m, height.U95_height_m)
    return replace(
        _make_answer(clicks, measured.height, uncorrected),
        frames=len(clicks.frames),
        solved_inset_m=measured.solved_inset_m,
        u_solved_inset_m=measured.u_solved_inset_m,
        heading_rad=measured.heading_rad,
        u_heading_rad=measured.u_heading_rad,
        travel_m=measured.travel_m,
        single=alone,
    )


def answers(pose: RoadPose, asked: Sequence[Clicks]) -> list[Answer]:
    """`answer` of thousands of clicks at once, in their order."""
    alone = [n for n, one in enumerate(asked) if not one.solves_inset and one.inset_m is not None]
    given = [asked[n] for n in alone]
    contacts = np.array([one.contact for one in given], dtype=np.float64).reshape(-1, 2)
    targets = np.array([one.target_point for one in given], dtype=np.float64).reshape(-1, 2)
    assumed = np.array([one.assumed() for one in given], dtype=np.float64).reshape(-1, 3).T
    corrected = measure_with_budgets(pose, contacts, targets, *assumed)
    nothing = np.zeros(len(given))
    uncorrected = measure_with_budgets(pose, contacts, targets, assumed[0], nothing, nothing)
    found = {
        n: _make_answer(one, _with_flags(one, height), flat)
        for n, one, height, flat in zip(alone, given, corrected, uncorrected, strict=True)
    }
    return [found[n] if n in found else answer(pose, one) for n, one in enumerate(asked)]


def _first_frame(pose: RoadPose, clicks: Clicks) -> tuple[Height, Height]:
    """The height by the inset assumed, and with an inset of 0."""
    if clicks.inset_m is not None:
        height, uncorrected = height_both(pose, clicks.contact, clicks.target_point, *clicks.assumed())
    else:
        uncorrected = measure_height(pose, clicks.contact, clicks.target_point, clicks.known_sigma_px)
        height = not_measurable(uncorrected.reason or SIDE_UNKNOWN)
        if not clicks.solves_inset:
            uncorrected = height
    return _with_flags(clicks, height), uncorrected


def _with_flags(clicks: Clicks, height: Height) -> Height:
    """The height with what is to be said of where its inset comes from."""
    if height.status == "ok" and clicks.side_from == "place" and clicks.inset_from == "usual":
        return replace(height, flags=(*height.flags, SIDE_FROM_PLACE))
    return height


def measured_frames(pose: RoadPose, clicks: Clicks) -> MultiHeight:
    """The height from all frames of the clicks, the first one first."""
    return measure_frames(pose, clicks.contacts, clicks.target_points, clicks.known_sigma_px)


def measured_pass(pose: RoadPose, clicks: Clicks) -> WholePass:
    """The height from all that was followed.

    Raises ValueError where nothing was, Damaged for a text that Sightline did not write.
    """
    if clicks.followed is None:
        raise ValueError("nothing was followed from these clicks")
    assumed = None if clicks.inset_m is None else clicks.assumed()[1:]
    return measure_pass(pose, *read_text(clicks.followed), assumed_inset=assumed)


@dataclass(frozen=True, slots=True)
class SolvedInset:
    """An inset that several frames or a whole pass tell, nothing assumed of it, metres; its u in parts."""

    inset_m: float
    parts: Parts


@lru_cache(_MOST_SOLVED)
def inset_alone(pose: RoadPose, clicks: Clicks) -> SolvedInset | None:
    """None where the clicks do not tell it. A whole pass takes long to solve and never changes: kept."""
    if clicks.followed is None:
        of_frames = measured_frames(pose, clicks)
        inset_m, parts = of_frames.solved_inset_m, of_frames.inset_parts
    else:
        of_pass = measure_pass(pose, *read_text(clicks.followed))
        inset_m, parts = None if of_pass.inset_m is None else of_pass.inset_m.value, of_pass.inset_parts
    return None if inset_m is None or parts is None else SolvedInset(inset_m, parts)


def _of_whole_pass(clicks: Clicks, first: Height, uncorrected: Height, whole_pass: WholePass) -> Answer:
    out = replace(
        _make_answer(clicks, _with_flags(clicks, whole_pass.height), uncorrected),
        frames=whole_pass.frames,
        single=SingleFrame(first.height_m, first.u_height_m, first.U95_height_m),
    )
    if whole_pass.inset_m is None or whole_pass.heading_rad is None or whole_pass.speed_mps is None:
        return out
    base = whole_pass.wheelbase_m
    return replace(
        out,
        solved_inset_m=whole_pass.inset_m.value,
        u_solved_inset_m=whole_pass.inset_m.u,
        heading_rad=whole_pass.heading_rad.value,
        u_heading_rad=whole_pass.heading_rad.u,
        speed_mps=whole_pass.speed_mps.value,
        wheelbase_m=None if base is None else base.value,
        u_wheelbase_m=None if base is None else base.u,
        chance=whole_pass.chance,
    )


# Sources of a height's budget that no other height shares, and the assumed inset's.
_OF_CLICKS = (
    *("click, target", "click, contact", "clicks", "heading"),
    *("following", "confirmed points", "drift", "frame times"),
    *("depth of what is followed", "seen from another side"),
)
_OF_INSET = ("inset",)


def part_of_budget(budget: Sequence[BudgetEntry], sources: Sequence[str]) -> float:
    """The root of the sum of squares of some sources, metres."""
    return math.sqrt(sum(entry.u_m**2 for entry in budget if entry.source in sources))


def _make_answer(clicks: Clicks, height: Height, uncorrected: Height) -> Answer:
    return Answer(
        status=height.status,
        reason=height.reason,
        height_m=height.height_m,
        u_height_m=height.u_height_m,
        U95_height_m=height.U95_height_m,
        uncorrected_height_m=uncorrected.height_m,
        inset_m=clicks.inset_m,
        u_inset_m=clicks.u_inset_m,
        inset_from=clicks.inset_from or "own",
        side=clicks.side,
        side_from=clicks.side_from,
        x_m=height.x_m,
        y_m=height.y_m,
        distance_m=height.distance_m,
        budget=[{"source": entry.source, "u_m": entry.u_m} for entry in height.budget],
        flags=list(height.flags),
        u_clicks_m=None if height.height_m is None else part_of_budget(height.budget, _OF_CLICKS),
        u_by_inset_m=None if height.height_m is None else part_of_budget(height.budget, _OF_INSET),
    )
