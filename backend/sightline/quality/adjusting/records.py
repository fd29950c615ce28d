"""What the traffic says of a road pose, and what an adjusted pose would change."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.adjustment.adjust import Moved
from sightline.enums import Target
from sightline.messages.said import Said


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownUncertainties:
    """What is taken for known lengths, metres: u of a wheelbase whose catalogue row states none, and the
    errors that all known wheelbases, all known roofs share.
    """

    u_wheelbase_m: float
    u_wheelbase_common_m: float
    u_roof_common_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class LeftOutVehicle:
    """A vehicle of which something was seen that is not used, and why."""

    vehicle_id: int
    number: int
    what: Annotated[str, Field(description="tyres or roof")]
    reason: Said


@dataclass(frozen=True, slots=True, kw_only=True)
class WithoutModel:
    """The camera's height above the road as adjusted without the vehicles of one model, against with them."""

    model: str
    vehicles: int
    camera_height_change_m: float
    by_u: Annotated[float, Field(description="That change by the u after the adjustment.")]


@dataclass(frozen=True, slots=True, kw_only=True)
class AdjustedHeight:
    """A stored height as it is and as the adjusted pose would have it; same clicks, same inset."""

    measurement_id: int
    vehicle_id: int
    number: int
    target: Target
    height_m: float
    U95_height_m: float
    adjusted_m: float
    U95_adjusted_m: float
    change_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class PoseAdjustment:
    """A pose in force, adjusted by its traffic; nothing is stored. `reason`: why there is none."""

    pose_id: int
    recordings: tuple[str, ...]
    adjusted_from: Annotated[int | None, Field(description="The pose before this one was adjusted itself.")]
    known: KnownUncertainties
    tyres: Annotated[int, Field(description="Vehicles with both tyres clicked and a known wheelbase.")]
    roofs: Annotated[int, Field(description="Vehicles with a measured roof and a known height.")]
    reason: Said | None = None
    passes: int = 0
    used: int = 0
    left_out: tuple[LeftOutVehicle, ...] = ()
    chi2: float | None = None
    degrees_of_freedom: int = 0
    chi2_limit: float | None = None
    moved: tuple[Moved, ...] = ()
    notes: tuple[Said, ...] = ()
    without_model: tuple[WithoutModel, ...] = ()
    heights: tuple[AdjustedHeight, ...] = ()
    largest_change_m: float | None = None
