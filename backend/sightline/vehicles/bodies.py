"""What vehicle records take and answer."""

from typing import Annotated

from pydantic import Field

from sightline.infra.web.bodies import Finite, FrameNumber, In, Text, example, of_record
from sightline.infra.web.quantities import Word
from sightline.vehicles import records
from sightline.vehicles.records import MOST_HEIGHT_M

_GIVEN = {
    "*_frame": FrameNumber,
    "make": Word,
    "model": Word,
    "year": Annotated[int, Field(ge=1885, le=2100)],
    "model_sizes": Annotated[str, Field(max_length=100)],
    "u_*_m": Annotated[Finite, Field(ge=0, le=MOST_HEIGHT_M)],
    "*_m": Annotated[Finite, Field(gt=0, le=MOST_HEIGHT_M)],
    "*_source": Text,
    "notes": Text,
}


@of_record(records.VehicleFields, "origin", "detection", given=_GIVEN, optional=True)
class VehicleFields(In):
    """What people fill in of a vehicle record; keys left out stay as they are."""

    check_target: bool = False


class NewVehicle(VehicleFields):
    model_config = example(first_frame=2, last_frame=9, category="hatchback")

    first_frame: FrameNumber
    last_frame: FrameNumber


class ChangedVehicle(VehicleFields):
    version: Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]
