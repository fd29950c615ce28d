"""Reviews, a measurement's history and the queue."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import (
    ReviewSign,
    ReviewVerdict,
)
from sightline.infra.audit.records import Who
from sightline.measurements.records import Measurement, VehicleSheet
from sightline.reviews.lots.records import LotPlace


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
    lot_id: int | None = None


@dataclass(frozen=True, slots=True)
class MeasurementHistory:
    """Everything ever said about one measurement, oldest first."""

    revisions: tuple[Measurement, ...]
    reviews: tuple[Review, ...]


@dataclass(frozen=True, slots=True)
class ReviewPlan:
    """Which measurements a reviewer clicks again before seeing them."""

    blind_one_in: Annotated[int, Field(description="One in so many, 1: all, 0: none.")]
    version: Annotated[int, Field(description="0: the usual plan; give it back with a change.")]


@dataclass(frozen=True, slots=True)
class ReviewWork:
    """What waits for a verdict in a survey."""

    to_review: Annotated[int, Field(description="By somebody else than the asker, who may judge them.")]
    own: Annotated[int, Field(description="The asker's own, which somebody else has to review.")]
    in_lots: Annotated[int, Field(description="Held by open lots, whose samples decide on them.")] = 0


@dataclass(frozen=True, slots=True)
class Judged:
    """What is told of a measurement beside itself, to judge it by."""

    blind: Annotated[bool, Field(description="To be clicked again before it is shown: the survey's plan.")]
    signs: Annotated[tuple[ReviewSign, ...], Field(description="Why it may be wrong.")]
    error_m: Annotated[float | None, Field(description="Of a roof: less the maker's height.")] = None
    U95_error_m: float | None = None
    lot: Annotated[LotPlace | None, Field(description="The open lot that holds it.")] = None


@dataclass(frozen=True, slots=True)
class QueueItem:
    """A measurement waiting for a reviewer; `mine` when the asker made this revision."""

    measurement: Measurement
    vehicle: VehicleSheet
    mine: bool
    judged: Judged
