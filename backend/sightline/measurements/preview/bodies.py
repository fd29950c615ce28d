"""What the live axes and heights take and answer."""

from sightline.enums import Target
from sightline.infra.web.bodies import FrameNumber, Id, In, Point
from sightline.infra.web.quantities import InsetM, UInsetM
from sightline.measurements.bodies import ClicksIn


class AxesWanted(In):
    contact: Point
    target: Target = "roof"
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None
    vehicle_id: Id | None = None


class HeightWanted(ClicksIn):
    target: Target
    frame: FrameNumber = 0
    vehicle_id: Id | None = None
