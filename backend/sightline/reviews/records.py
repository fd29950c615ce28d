"""Reviews, a measurement's history and the queue."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import (
    ReviewVerdict,
)
from sightline.infra.audit.records import Who
from sightline.measurements.records import Measurement, VehicleSheet


@dataclass(frozen=True, slots=True)
class Review:
    """One verdict given; `revision` is the one that was looked at."""

    id: int
    measurement_id: int
    revision: int
    result_revision: int
    verdict: ReviewVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


@dataclass(frozen=True, slots=True)
class MeasurementHistory:
    """Everything ever said about one measurement, oldest first."""

    revisions: tuple[Measurement, ...]
    reviews: tuple[Review, ...]


@dataclass(frozen=True, slots=True)
class QueueItem:
    """A measurement waiting for a reviewer; `mine` when the asker made this revision."""

    measurement: Measurement
    vehicle: VehicleSheet
    mine: bool
