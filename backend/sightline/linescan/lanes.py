"""Lanes of a rig: which one a vehicle drives in, and the rig with which it is then measured.

The baseline at a vehicle is b + q D, so its speed, acceleration and length go with its distance D. Two line
cameras do not tell D: planes that open by q act like a longer baseline. What tells lanes apart is seen in one
strip: the direction, and the row at which tyres meet the road, which lies higher the farther the lane is.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from sightline.linescan.either_way import exact_at_camera_1
from sightline.linescan.parts import Lane, Motion, Passage, Rig
from sightline.linescan.rig import at_lane, baseline_of
from sightline.linescan.wheels import tyres_row
from sightline.messages.said import Said

NO_TYRES = Said("scan-lane-no-wheel")
NO_LANE_THIS_WAY = Said("scan-lane-not-this-way")


@dataclass(frozen=True)
class Assigned:
    """A vehicle's lane, or why it is not known; `tyres_px`: the row of its tyres' feet, if found."""

    lane: Lane | None
    why: Said | None = None
    tyres_px: float | None = None


def lane_of(passage: Passage, rig: Rig) -> Assigned:
    """The one lane that has the vehicle's direction and its tyres' row."""
    ways = [one for one in rig.lanes if one.direction in (None, passage.crossings.direction)]
    if not ways:
        return Assigned(None, NO_LANE_THIS_WAY)
    if len(ways) == 1 and ways[0].tyres_from_px is None:
        return Assigned(ways[0])
    row = None if passage.reason else _tyres_px(passage, rig)
    if row is None:
        return Assigned(None, NO_TYRES)
    inside = [
        one
        for one in ways
        if one.tyres_from_px is None or one.tyres_from_px <= row < (one.tyres_to_px or 0.0)
    ]
    if len(inside) == 1:
        return Assigned(inside[0], None, row)
    return Assigned(None, Said("scan-lane-other-rows", row=round(row), lanes=len(inside)), row)


def in_its_lane(measure: Callable[[Passage, Rig], Motion]) -> Callable[[Passage, Rig], Motion]:
    """A method that measures every vehicle with the distance of its lane."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        if not rig.lanes:
            return measure(passage, rig)
        located = lane_of(passage, rig)
        if located.lane is not None:
            motion = measure(passage, at_lane(rig, located.lane.name))
            return replace(motion, lane=located.lane.name, lane_by="machine", tyres_px=located.tyres_px)
        motion = measure(passage, at_lane(rig, None, passage.crossings.direction))
        if motion.status == "ok":
            said = Said("scan-motion-lane-unknown", why=located.why)
            motion = replace(motion, warnings=(*motion.warnings, said))
        return replace(motion, tyres_px=located.tyres_px)

    return measured


def _tyres_px(passage: Passage, rig: Rig) -> float | None:
    """By the motion that the boundaries alone give: wheels are looked for in a picture laid out in metres."""
    try:
        baseline_m, _ = baseline_of(at_lane(rig, None, passage.crossings.direction))
        rough = exact_at_camera_1(passage.crossings, baseline_m, rig.line_rate_hz)
    except (ValueError, ArithmeticError):
        return None
    motion = Motion(
        method="direct",
        crossings=passage.crossings,
        status="ok",
        speed_mps=rough.speed_mps,
        acceleration_mps2=rough.acceleration_mps2,
        length_m=rough.length_m,
    )
    return tyres_row(passage.first, passage.start_1, motion, rig)
