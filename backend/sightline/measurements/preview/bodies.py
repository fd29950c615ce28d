"""What the live axes and heights take and answer."""

from pydantic import Field

from sightline.enums import MeasurementStatus, Target
from sightline.infra.web.bodies import FrameNumber, In, Out, Point
from sightline.infra.web.quantities import BudgetEntryBody, InsetM, UInsetM
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


class SingleFrameBody(Out):
    """What the first frame alone would give, with the inset assumed."""

    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None


class HeightAnswer(Out):
    """One height with its uncertainty; where there is none, why."""

    status: MeasurementStatus
    reason: str | None
    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    uncorrected_height_m: float | None
    inset_m: float
    u_inset_m: float
    x_m: float | None
    y_m: float | None
    distance_m: float | None
    budget: list[BudgetEntryBody]
    flags: list[str]
    frames: int
    solved_inset_m: float | None
    u_solved_inset_m: float | None
    heading_rad: float | None
    u_heading_rad: float | None
    travel_m: float | None
    single: SingleFrameBody | None = Field(description="Beside a height from several frames.")
