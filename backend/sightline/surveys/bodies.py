"""What surveys take, and what is said of one."""

from collections.abc import Mapping
from typing import Annotated, get_args

from pydantic import Field

from sightline.enums import (
    AskedTarget,
    CameraPlace,
    Category,
    ClassSet,
    EuClass,
    Hand,
    InsetName,
    InsetPlace,
    Lighting,
    SamplingMethod,
    StreetLamps,
)
from sightline.geometry.insets import INSET_CHOICES
from sightline.infra.web.bodies import In, Name, Out, Text, example
from sightline.statistics.sampling import MOST_HEADWAY_S, MOST_STEP, Quota, Sampling
from sightline.surveys.records import Inset

Metres = Annotated[float, Field(ge=-10, le=10, allow_inf_nan=False)]
Uncertainty = Annotated[float, Field(ge=0, le=10, allow_inf_nan=False)]


class InsetIn(In):
    inset_m: Metres
    u_inset_m: Uncertainty
    note: Annotated[str, Field(max_length=1000)] = ""
    code: Annotated[
        str | None,
        Field(max_length=100, description="The program's for its note; null once that is changed."),
    ] = None


class Insets(Out):
    """Of every target, by name."""

    __annotations__ = dict.fromkeys(get_args(InsetName), Inset)


class InsetChanges(In):
    """Targets left out keep their inset."""

    __annotations__ = dict.fromkeys(get_args(InsetName), Annotated[InsetIn | None, Field(default=None)])


class InsetChoice(Out):
    place: InsetPlace
    inset_m: float
    u_inset_m: float


def inset_choices(insets: Mapping[str, Inset]) -> dict[str, list[InsetChoice]]:
    """Per target what can be told apart by looking at the vehicle: a roof's spot, a driver's side."""
    choices = {
        str(target): [InsetChoice(place=place, inset_m=inset, u_inset_m=u) for place, inset, u in found]
        for target, found in INSET_CHOICES.items()
    }
    near, far = insets["driver_eye_near"], insets["driver_eye_far"]
    choices["driver_eye"] = [
        InsetChoice(place="near", inset_m=near.inset_m, u_inset_m=near.u_inset_m),
        InsetChoice(place="far", inset_m=far.inset_m, u_inset_m=far.u_inset_m),
    ]
    return choices


class TrafficIn(In):
    traffic_side: Hand | None = None
    steering_side: Hand | None = None
    camera_place: CameraPlace | None = None


Degrees = Annotated[float, Field(allow_inf_nan=False)]


class PlaceIn(In):
    latitude_deg: Degrees | None = None
    longitude_deg: Degrees | None = None
    road_class: Annotated[str, Field(max_length=100)] | None = None
    lane: Annotated[str, Field(max_length=100)] | None = None
    travel_direction: Annotated[str, Field(max_length=100)] | None = None
    speed_limit_mps: Annotated[float, Field(allow_inf_nan=False)] | None = None
    street_lamps: StreetLamps | None = None
    time_zone: Annotated[str, Field(max_length=60)] | None = None


AskedTargets = Annotated[tuple[AskedTarget, ...], Field(max_length=len(get_args(AskedTarget)))]


class AskedIn(In):
    daytime: AskedTargets
    low_light: AskedTargets


class VehicleClassIn(In):
    category: Category
    class_set: ClassSet | None = None
    eu: Annotated[tuple[EuClass, ...], Field(max_length=len(get_args(EuClass)))] = ()
    fhwa: Annotated[tuple[Annotated[int, Field(ge=1, le=13)], ...], Field(max_length=13)] = ()


class QuotaIn(In):
    lighting: Lighting
    class_set: ClassSet | None = None
    wanted: Annotated[int, Field(ge=1, le=1_000_000)]


class SamplingIn(In):
    method: SamplingMethod = "every"
    step: Annotated[int, Field(ge=1, le=MOST_STEP)] = 1
    start: Annotated[int, Field(ge=1, le=MOST_STEP)] = 1
    share_percent: Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)] = 100.0
    seed: Annotated[int, Field(ge=0, le=2**31 - 1)] = 1
    free_flowing_s: Annotated[float, Field(gt=0, le=MOST_HEADWAY_S, allow_inf_nan=False)] | None = None
    quotas: Annotated[tuple[QuotaIn, ...], Field(max_length=8)] = ()
    outside_counts: bool = False

    def record(self) -> Sampling:
        """As the store takes it."""
        quotas = tuple(Quota(**one.model_dump()) for one in self.quotas)
        return Sampling(**{**self.model_dump(exclude={"quotas"}), "quotas": quotas})


class NewSurvey(In):
    name: Name
    site: Annotated[str, Field(max_length=200)] = ""
    description: Text = ""
    traffic: TrafficIn | None = Field(default=None, description="Left out: as it is, at first not said.")
    place: PlaceIn | None = Field(default=None, description="Left out: as it is, at first not said.")
    asked: AskedIn | None = Field(default=None, description="Left out: as it is, at first the usual.")


class FirstSurvey(NewSurvey):
    model_config = example(name="Hill road, spring", site="lane 1", open_to_all=False)

    open_to_all: bool = Field(
        default=False, description="Everybody who signs in acts in it by the role of the account."
    )


class SurveyChange(NewSurvey):
    version: int = Field(
        description="The version that was changed; another's change in between is a conflict."
    )
    insets: InsetChanges | None = None
    sampling: Annotated[SamplingIn | None, Field(description="Left out: as it is.")] = None
    classes: Annotated[
        tuple[VehicleClassIn, ...] | None,
        Field(max_length=len(get_args(Category)), description="Classes left out stay as they are."),
    ] = None
