"""What the live axes and heights take and answer."""

from sightline.enums import Target
from sightline.infra.web.bodies import FrameNumber, In, Out, Point
from sightline.infra.web.quantities import InsetM, UInsetM
from sightline.measurements.bodies import ClicksIn
from sightline.poses.bodies import AxesBody, Polyline


class AxesWanted(In):
    contact: Point
    target: Target = "roof"
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None


class RungBody(Out):
    height_m: float
    points: Polyline
    label: bool


class AxesAnswer(Out):
    """The road's axes and the ladder of heights through a contact click; where there are none, why."""

    ok: bool
    reason: str | None
    axes: AxesBody | None
    ladder: list[RungBody]
    x_m: float | None
    y_m: float | None
    distance_m: float | None


class HeightWanted(ClicksIn):
    target: Target
    frame: FrameNumber = 0
