"""Reviews, a measurement's history and the queue."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import Lighting, ReviewSign
from sightline.infra.audit.records import Who
from sightline.measurements.records import Measurement, Review, ScanHeight
from sightline.reviews.lots.records import LotPlace


@dataclass(frozen=True, slots=True)
class MeasurementHistory:
    """Everything ever said about one measurement, oldest first."""

    revisions: tuple[Measurement | ScanHeight, ...]
    reviews: tuple[Review, ...]


@dataclass(frozen=True, slots=True)
class ReviewPlan:
    """Which measurements a reviewer clicks again before seeing them."""

    blind_one_in: Annotated[int, Field(description="One in so many, 1: all, 0: none.")]
    version: Annotated[int, Field(description="0: the usual plan; give it back with a change.")]


@dataclass(frozen=True, slots=True)
class ReviewWork:
    """The standing heights of a survey, by what was said of them."""

    to_review: Annotated[int, Field(description="By somebody else than the asker, who may judge them.")]
    own: Annotated[int, Field(description="The asker's own, which somebody else has to review.")]
    in_lots: Annotated[int, Field(description="Held by open lots, whose samples decide on them.")]
    accepted: Annotated[int, Field(description="Corrected ones too.")]
    rejected: int
    heights: Annotated[int, Field(description="All of them.")]


@dataclass(frozen=True, slots=True)
class Judged:
    """What is told of a measurement beside itself, to judge it by."""

    blind: Annotated[bool, Field(description="To be clicked again before it is shown: the survey's plan.")]
    signs: Annotated[tuple[ReviewSign, ...], Field(description="Why it may be wrong.")]
    clicked_at: Annotated[datetime, Field(description="When the points that stand were clicked.")]
    error_m: Annotated[float | None, Field(description="Of a roof: less the maker's height.")] = None
    U95_error_m: float | None = None
    operator: Annotated[Who | None, Field(description="Who clicked the points that stand.")] = None
    lot: Annotated[LotPlace | None, Field(description="The open lot that holds it.")] = None


@dataclass(frozen=True, slots=True)
class VehicleFacts:
    """What is told of a vehicle, filmed or scanned, to judge its heights by; `scan_name`: of a scanned."""

    id: int
    number: int
    make: str | None
    model: str | None
    year: int | None
    lighting: Lighting | None
    manufacturer_height_m: float | None = None
    scan_name: str | None = None


@dataclass(frozen=True, slots=True)
class QueueItem:
    """A height waiting for a reviewer, of either kind; `mine` when the asker made this revision."""

    measurement: Measurement | ScanHeight
    vehicle: VehicleFacts
    mine: bool
    judged: Judged
