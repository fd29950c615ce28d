"""What the live axes and heights take and answer."""

from sightline.enums import Target
from sightline.infra.web.bodies import FrameNumber, In, Point, example
from sightline.infra.web.named import VehicleId
from sightline.infra.web.quantities import InsetM, UInsetM
from sightline.measurements.bodies import ClicksIn


class AxesWanted(In):
    contact: Point
    target: Target = "roof"
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None
    vehicle_id: VehicleId | None = None


class HeightWanted(ClicksIn):
    model_config = example(
        target="roof", frame=2, contact=[169.5, 194.5], target_point=[189.5, 134.5], inset_m=0.25
    )

    target: Target
    frame: FrameNumber = 0
    vehicle_id: VehicleId | None = None
