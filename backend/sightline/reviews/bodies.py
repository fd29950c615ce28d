"""What reviews take and answer."""

from datetime import datetime

from pydantic import Field

from sightline.enums import (
    ReviewVerdict,
)
from sightline.infra.web.bodies import FrameNumber, In, Out, Point, Text, WhoBody
from sightline.infra.web.quantities import Revision
from sightline.measurements.bodies import MeasurementBody
from sightline.vehicles.bodies import VehicleAlone


class VerdictGiven(Out):
    id: int
    revision: int
    result_revision: int
    verdict: ReviewVerdict
    reason: str | None
    reviewer: WhoBody | None
    at: datetime


class HistoryBody(Out):
    """Everything ever stored about a measurement, oldest first."""

    revisions: list[MeasurementBody]
    reviews: list[VerdictGiven]


class NewReview(In):
    revision: Revision
    verdict: ReviewVerdict
    reason: Text | None = None
    frame: FrameNumber | None = None
    contact: Point | None = None
    target_point: Point | None = None


class QueueItemBody(Out):
    measurement: MeasurementBody
    vehicle: VehicleAlone
    mine: bool = Field(description="Whether you made this revision: then somebody else has to review it.")
