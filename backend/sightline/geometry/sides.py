"""On which side of a vehicle, as the camera sees it, its driver sits: by its direction, or by the lane."""

from dataclasses import dataclass

from sightline.enums import CameraPlace, Direction, DriverSide, Hand, SideBasis


@dataclass(frozen=True, slots=True)
class TrafficFacts:
    """What holds for all vehicles of a site, unless one is said to differ; None: nobody has said."""

    traffic_side: Hand | None = None
    steering_side: Hand | None = None
    camera_place: CameraPlace | None = None


@dataclass(frozen=True, slots=True)
class FoundSide:
    """The driver's side and what it follows from: said of the vehicle, its direction, the camera's place."""

    side: DriverSide
    basis: SideBasis


def direction_beside_camera(facts: TrafficFacts) -> Direction | None:
    """Which way the lane beside the camera goes in the picture; None while the facts do not say.

    Whoever drives on the right has the right verge beside them, so that the camera there sees the right side
    of vehicles that go to the right; from the median it sees left sides.
    """
    if facts.traffic_side is None or facts.camera_place is None:
        return None
    from_verge = facts.camera_place == "verge"
    return "right" if (facts.traffic_side == "right") == from_verge else "left"


def driver_side(
    stated: DriverSide | None, direction: Direction | None, facts: TrafficFacts
) -> FoundSide | None:
    """The driver's side of one vehicle: as said, else by its direction, else by the lane beside the camera.

    A camera sees the right side of what goes to the right in its picture, and the left side of what goes to
    the left. Only from the median all that it sees goes one way: from a verge a pass without a direction may
    be in the opposite lane. None where the side cannot be told.
    """
    if stated is not None:
        return FoundSide(stated, "said")
    one_way = direction_beside_camera(facts) if facts.camera_place == "median" else None
    shown = direction or one_way
    if shown is None or facts.steering_side is None:
        return None
    side: DriverSide = "near" if facts.steering_side == shown else "far"
    return FoundSide(side, "place" if direction is None else "direction")
