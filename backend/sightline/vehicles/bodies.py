"""What vehicle records take and answer."""

from typing import Annotated

from pydantic import Field

from sightline.enums import Category, Direction, Discarded, DriverSide, Lighting, ModelChosenBy, NotVisible
from sightline.infra.web.bodies import Finite, FrameNumber, In, Text, example
from sightline.infra.web.quantities import Word
from sightline.vehicles.records import MOST_HEIGHT_M

Height = Annotated[Finite, Field(gt=0, le=MOST_HEIGHT_M)] | None
HeightU = Annotated[Finite, Field(ge=0, le=MOST_HEIGHT_M)] | None


class VehicleFields(In):
    """What people fill in of a vehicle record; keys left out stay as they are."""

    first_frame: FrameNumber | None = None
    last_frame: FrameNumber | None = None
    best_frame: FrameNumber | None = None
    make: Word | None = None
    model: Word | None = None
    year: Annotated[int, Field(ge=1885, le=2100)] | None = None
    model_chosen_by: ModelChosenBy | None = None
    model_sizes: Annotated[str, Field(max_length=100)] | None = None
    category: Category | None = None
    manufacturer_height_m: Height = None
    u_manufacturer_height_m: HeightU = None
    height_source: Text | None = None
    known_driver_eye_m: Height = None
    u_known_driver_eye_m: HeightU = None
    known_driver_eye_source: Text | None = None
    known_taillight_m: Height = None
    u_known_taillight_m: HeightU = None
    known_taillight_source: Text | None = None
    known_headlight_m: Height = None
    u_known_headlight_m: HeightU = None
    known_headlight_source: Text | None = None
    known_other_m: Height = None
    u_known_other_m: HeightU = None
    known_other_source: Text | None = None
    check_target: bool = False
    lighting: Lighting | None = None
    direction: Direction | None = None
    driver_side: DriverSide | None = None
    roof_not_visible: NotVisible | None = None
    driver_eye_not_visible: NotVisible | None = None
    taillight_not_visible: NotVisible | None = None
    headlight_not_visible: NotVisible | None = None
    discarded: Discarded | None = None
    notes: Text | None = None


class NewVehicle(VehicleFields):
    model_config = example(first_frame=2, last_frame=9, category="hatchback")

    first_frame: FrameNumber
    last_frame: FrameNumber


class ChangedVehicle(VehicleFields):
    version: Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]
