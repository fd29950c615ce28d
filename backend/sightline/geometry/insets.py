"""Usual insets: how far each target lies behind the side plane through the wheel contact.

These are estimates without a published source; screens and files show them as such, and they can be edited. A
target whose inset is unknown gets a wide uncertainty instead of a guess (the bias it stands for: `bias_m`). A
driver's eye has two, for a driver on the near and on the far side, and none until one knows which. A roof has
one for each shape of body, which the vehicle's class tells.
"""

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.enums import Category, DriverSide, InsetName, InsetPlace, Target
from sightline.messages.said import Said

USUAL_INSETS: dict[InsetName, tuple[float, float, str]] = {
    "roof": (0.30, 0.10, "near edge of the roof; 0.85 m (u = 0.10 m) for its crown (estimate)"),
    "roof_van": (0.20, 0.10, "near edge of the roof (estimate)"),
    "roof_box": (0.03, 0.05, "a body with upright sides (estimate)"),
    "roof_unknown": (0.30, 0.15, "as of a car, less certain (estimate)"),
    "driver_eye_near": (0.45, 0.10, "driver on the side of the camera (estimate)"),
    "driver_eye_far": (1.15, 0.15, "driver on the side away from the camera (estimate)"),
    "taillight": (0.05, 0.05, "outer edge of the lamp (estimate)"),
    "headlight": (0.05, 0.05, "outer edge of the lamp (estimate)"),
    "other": (0.0, 0.30, "not known"),
}

#: The inset of the roof of each class; of other classes and of none it is `roof_unknown`.
ROOF_OF_CLASS: dict[Category, InsetName] = {
    **dict.fromkeys(("hatchback", "saloon", "estate", "suv", "multi_purpose", "pickup"), "roof"),
    **dict.fromkeys(("van", "recreational_vehicle"), "roof_van"),
    **dict.fromkeys(("lorry", "tractor_unit", "bus", "trailer"), "roof_box"),
}

# What an operator can see of a vehicle and choose between: place, inset, standard uncertainty (estimates).
INSET_CHOICES: dict[Target, tuple[tuple[InsetPlace, float, float], ...]] = {
    "roof": (("near_edge", 0.30, 0.10), ("crown", 0.85, 0.10)),
}

# No vehicle is wider; below 0 what scatter and a body that bulges past its wheels may make of an inset.
LEAST_INSET_M, MOST_INSET_M = -0.5, 2.6

# An eye of which nobody knows the side lies somewhere here: to look for it on other frames, for no height.
EITHER_SIDE_M, U_EITHER_SIDE_M = 0.80, 0.40

SIDE_UNKNOWN = Said("height-side-unknown")


def implausible_inset(inset_m: float) -> Said | None:
    """Why an inset that was solved for, m, gives no height: no vehicle has it. None where one may."""
    if LEAST_INSET_M < inset_m < MOST_INSET_M:
        return None
    return Said(
        "height-inset-implausible", inset_m=round(inset_m, 2), low_m=LEAST_INSET_M, high_m=MOST_INSET_M
    )


def inset_name(target: Target, side: DriverSide | None, category: Category | None) -> InsetName | None:
    """The name of a target's usual inset on a vehicle of a class (None: nobody said); None for an eye while
    the driver's side is unknown.
    """
    if target == "roof":
        return "roof_unknown" if category is None else ROOF_OF_CLASS.get(category, "roof_unknown")
    if target != "driver_eye":
        return target
    if side is None:
        return None
    return "driver_eye_near" if side == "near" else "driver_eye_far"


def target_of(name: InsetName) -> tuple[Target, DriverSide | None]:
    """The target, and for an eye the driver's side, that an inset is for."""
    match name:
        case "roof" | "roof_van" | "roof_box" | "roof_unknown":
            return "roof", None
        case "driver_eye_near":
            return "driver_eye", "near"
        case "driver_eye_far":
            return "driver_eye", "far"
        case _:
            return name, None


def bias_m(
    camera_height_m: ArrayLike, height_m: ArrayLike, inset_m: ArrayLike, distance_m: ArrayLike
) -> Floats:
    """How much too high a target reads where its inset is taken to be 0, in metres; `camera_height_m`,
    `height_m`, `inset_m`, `distance_m`, any shape each, are broadcast: of the same shape.

    (Hc - h) inset / (D + inset): camera height Hc, true height h, distance D to the side plane. Exact for any
    pose and lens, for it is where the ray to the target meets the plane (CONVENTIONS.md, Height; not in the
    paper).
    """
    camera, height, inset, distance = (
        np.asarray(v, dtype=np.float64) for v in (camera_height_m, height_m, inset_m, distance_m)
    )
    return np.asarray((camera - height) * inset / (distance + inset), dtype=np.float64)
