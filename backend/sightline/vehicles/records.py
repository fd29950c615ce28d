"""The facts of a vehicle, and what may be changed of them."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Any, NamedTuple, get_args

from pydantic import Field

from sightline.enums import (
    AskedTarget,
    Category,
    Direction,
    Discarded,
    DriverSide,
    JsonObject,
    KnownTarget,
    Lighting,
    ModelChosenBy,
    NotVisible,
    SideBasis,
    Target,
    VehicleOrigin,
)
from sightline.infra.audit.records import Who
from sightline.infra.meaning import explained_as
from sightline.statistics.agreement import U_MANUFACTURER_M

# The field that says why a target is not visible, by target.
NOT_VISIBLE: dict[AskedTarget, str] = {target: f"{target}_not_visible" for target in get_args(AskedTarget)}
MOST_HEIGHT_M = 10.0  # of a vehicle, and of its uncertainty; a height is more than 0
#: What is known of a target lies within these, metres, on any vehicle or check target; feet mostly do not.
KNOWN_WITHIN_M: dict[Target, tuple[float, float]] = {
    "roof": (0.3, 5.0),
    "driver_eye": (0.3, 3.5),
    "taillight": (0.1, 2.5),
    "headlight": (0.1, 2.5),
    "other": (0.0, MOST_HEIGHT_M),
}


class KnownFields(NamedTuple):
    """The fields of a height that was known before it was measured: metres, metres, words."""

    height: str
    u: str
    source: str


# A roof's known height is that of the maker, or the taped one of a check target.
KNOWN: dict[Target, KnownFields] = {
    "roof": KnownFields("manufacturer_height_m", "u_manufacturer_height_m", "height_source"),
    **{
        target: KnownFields(f"known_{target}_m", f"u_known_{target}_m", f"known_{target}_source")
        for target in get_args(KnownTarget)
    },
}


#: Who takes a model because it fits what was measured says so with this word.
BY_SIZE: ModelChosenBy = "size"


def is_reference(chosen_by: str | None) -> bool:
    """Whether known heights of a vehicle may be held against measured ones. Not where its model was chosen
    because it fits them: that would be a circle (DECISIONS.md, 86).
    """
    return chosen_by != BY_SIZE


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("vehicles")
class VehicleFields:
    """What people fill in of a vehicle, or the search for passes."""

    first_frame: int
    last_frame: int
    best_frame: int | None
    make: str | None
    model: str | None
    year: int | None
    model_chosen_by: Annotated[
        ModelChosenBy | None,
        Field(
            description="size: the model was taken because it fits what was measured, so no height known of "
            "it is a reference; seen: then it was recognised on the vehicle; null: neither."
        ),
    ]
    model_sizes: str | None
    category: Category | None
    manufacturer_height_m: float | None
    u_manufacturer_height_m: float | None
    height_source: str | None
    known_driver_eye_m: float | None
    u_known_driver_eye_m: float | None
    known_driver_eye_source: str | None
    known_taillight_m: float | None
    u_known_taillight_m: float | None
    known_taillight_source: str | None
    known_headlight_m: float | None
    u_known_headlight_m: float | None
    known_headlight_source: str | None
    known_other_m: float | None
    u_known_other_m: float | None
    known_other_source: str | None
    check_target: Annotated[
        bool,
        Field(
            description="A staff with marks, or a car with taped heights, to check the measuring: it has its "
            "own row among the errors and counts in no distribution, quota or response."
        ),
    ]
    lighting: Lighting | None
    notes: str
    origin: VehicleOrigin
    direction: Direction | None
    driver_side: DriverSide | None
    roof_not_visible: NotVisible | None
    driver_eye_not_visible: NotVisible | None
    taillight_not_visible: NotVisible | None
    headlight_not_visible: NotVisible | None
    discarded: Discarded | None
    detection: Annotated[JsonObject | None, Field(description="What the search for passes saw of it.")]


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("vehicles")
class Vehicle(VehicleFields):
    """The facts of a record; its measurements are on its sheet (`measurements`)."""

    id: int
    survey_id: int
    recording_id: int
    number: int
    version: int
    updated_by: Who | None
    updated_at: datetime
    deleted: bool
    side: Annotated[DriverSide | None, Field(description="Where the driver sits: said or derived.")]
    side_from: Annotated[SideBasis | None, Field(description="What `side` follows from.")]
    asked: Annotated[
        tuple[AskedTarget, ...], Field(description="What the survey asks for of it, by its lighting.")
    ]

    in_sample: Annotated[bool, Field(description="Whether the survey's rule takes it into the sample.")]
    counts: Annotated[
        bool,
        Field(
            description="Whether its heights count in results: no check target, and in the sample, unless "
            "the survey counts others too."
        ),
    ]
    first_s: float | None
    filmed_at: str | None

    @property
    def reference_m(self) -> float | None:
        """The known height of its roof, if it may be held against a measured one."""
        return self.manufacturer_height_m if is_reference(self.model_chosen_by) else None

    @property
    def u_reference_m(self) -> float:
        """Of `reference_m`: as it was said, 0 too; else what manufacturers' heights usually have."""
        u_m = self.u_manufacturer_height_m
        return float(U_MANUFACTURER_M) if u_m is None else u_m

    @property
    def not_visible(self) -> dict[AskedTarget, NotVisible]:
        """Why targets cannot be measured, of those of which somebody said so."""
        return {
            target: why for target, name in NOT_VISIBLE.items() if (why := getattr(self, name)) is not None
        }


#: `VehicleFields` by name; keys left out stay as they are.
VehicleChanges = Mapping[str, Any]
