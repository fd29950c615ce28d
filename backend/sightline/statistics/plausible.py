"""Heights of one vehicle that deserve a second look: asked about at once, never refused.

The ranges are wide on purpose and no result rests on them: they are there to catch a click on the wrong
feature, the wrong vehicle, or a contact beside the tyre, not a car that is a little taller than others.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot
from typing import get_args

from sightline.coverage import COVERAGE_95
from sightline.enums import Category, DoubtKind, StatisticsTarget, Target

#: Metres between which a target of a class usually lies; estimates, see above.
_ANY: dict[Target, tuple[float, float]] = dict(
    zip(get_args(StatisticsTarget), ((0.8, 3.2), (0.2, 1.8), (0.3, 1.5), (1.0, 4.6)), strict=True)
)
_CAR: dict[Target, tuple[float, float]] = {"roof": (1.15, 1.75), "driver_eye": (0.9, 1.4)}
_OF_CLASS: dict[Category, dict[Target, tuple[float, float]]] = {
    "hatchback": _CAR,
    "saloon": _CAR,
    "estate": _CAR,
    "suv": {"roof": (1.4, 2.15), "driver_eye": (1.1, 1.75)},
    "multi_purpose": {"roof": (1.45, 2.1), "driver_eye": (1.1, 1.75)},
    "pickup": {"roof": (1.5, 2.2), "driver_eye": (1.2, 1.9)},
    "van": {"roof": (1.6, 3.2), "driver_eye": (1.3, 2.3)},
    "lorry": {"roof": (2.0, 4.6), "driver_eye": (1.6, 3.2)},
    "tractor_unit": {"roof": (2.4, 4.6), "driver_eye": (1.9, 3.2)},
    "bus": {"roof": (2.4, 4.6), "driver_eye": (1.3, 3.0)},
    "recreational_vehicle": {"roof": (1.9, 4.2), "driver_eye": (1.3, 2.8)},
    "trailer": {"roof": (0.5, 4.6)},
    "motorcycle": {"roof": (0.7, 2.0), "driver_eye": (1.1, 1.9)},
}
#: A roof this much beside the maker's height is asked about, if its uncertainty does not explain it.
_FAR_M = 0.08


@dataclass(frozen=True, slots=True)
class Height:
    """A measured height and its standard uncertainty, metres."""

    height_m: float
    u_m: float


@dataclass(frozen=True, slots=True)
class Doubt:
    """What is asked about a target: beside which height (`other`, `low_m`), or outside which range."""

    target: Target
    kind: DoubtKind
    other: Target | None
    low_m: float | None
    high_m: float | None


def doubts(
    heights: Mapping[Target, Height],
    category: Category | None = None,
    maker_m: float | None = None,
    u_maker_m: float = 0.0,
) -> tuple[Doubt, ...]:
    """What does not fit: among the heights of one vehicle, with its class, and with its maker's height."""
    return (
        *_order(heights),
        *_range(heights, category),
        *_maker(heights.get("roof"), maker_m, u_maker_m),
    )


def is_of_class(target: Target, height_m: float, category: Category | None) -> bool:
    """Whether a target of the class, of any where it is not known, lies at such a height."""
    return not _range({target: Height(height_m, 0.0)}, category)


def _order(heights: Mapping[Target, Height]) -> list[Doubt]:
    """Nothing lies above the roof, and no headlight above the driver's eye."""
    doubtful = []
    roof, eye, headlight = (heights.get(name) for name in ("roof", "driver_eye", "headlight"))
    for target in ("driver_eye", "taillight", "headlight"):
        one = heights.get(target)
        if roof and one and one.height_m >= roof.height_m:
            doubtful.append(Doubt(target, "above_roof", "roof", roof.height_m, None))
    if eye and headlight and headlight.height_m >= eye.height_m:
        doubtful.append(Doubt("driver_eye", "below_lamp", "headlight", headlight.height_m, None))
    return doubtful


def _range(heights: Mapping[Target, Height], category: Category | None) -> list[Doubt]:
    ranges = {**_ANY, **(_OF_CLASS.get(category, {}) if category else {})}
    return [
        Doubt(target, "outside_class", None, *ranges[target])
        for target, one in heights.items()
        if target in ranges and not ranges[target][0] <= one.height_m <= ranges[target][1]
    ]


def _maker(roof: Height | None, maker_m: float | None, u_maker_m: float) -> list[Doubt]:
    if roof is None or maker_m is None:
        return []
    beside_m = abs(roof.height_m - maker_m)
    far = beside_m > max(_FAR_M, COVERAGE_95 * hypot(roof.u_m, u_maker_m))
    return [Doubt("roof", "far_from_maker", None, maker_m, None)] if far else []
