"""What reviews take and answer."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import ReviewVerdict
from sightline.infra.web.bodies import FrameNumber, In, Point, example
from sightline.infra.web.quantities import Revision
from sightline.measurements.bodies import MeasurementBody, VerdictIn
from sightline.measurements.records import Review
from sightline.reviews.records import Judged, VehicleFacts
from sightline.scans.heights.bodies import ScanHeightBody

HeightBody = MeasurementBody | ScanHeightBody


@dataclass(frozen=True, slots=True)
class HistoryBody:
    """Everything ever stored about a height, oldest first."""

    revisions: list[HeightBody]
    reviews: tuple[Review, ...]


class NewReview(VerdictIn):
    model_config = example(revision=1, verdict="accepted", seen="to_review")

    revision: Revision
    verdict: ReviewVerdict
    frame: FrameNumber | None = None
    contact: Point | None = None
    target_point: Point | None = None


@dataclass(frozen=True, slots=True)
class QueueItemBody:
    """A height, of a frame or of a line scan, and its vehicle, for a reviewer."""

    measurement: HeightBody
    vehicle: VehicleFacts
    mine: Annotated[
        bool, Field(description="Whether you made this revision: then somebody else has to review it.")
    ]
    judged: Judged


class PlanIn(In):
    blind_one_in: Annotated[int, Field(ge=0, le=100)]
    version: int = Field(description="Of the plan that it replaces.")
