"""Statistics and traffic of a survey's line scans."""

from dataclasses import dataclass
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import BeforeValidator, Field

from sightline.errors import BadInput
from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import Out, of_record
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.infra.web.figures import (
    DensityPart,
    EcdfBody,
    ErrorFiguresBody,
    ReasonBody,
    error_figures,
    part_body,
)
from sightline.linescan.rig import RigEstimate
from sightline.linescan.traffic import LENGTH_LIMITS_M, MINUTES
from sightline.messages.said import Said
from sightline.recordings.bodies import FilmedAsked
from sightline.scans.statistics.figures import scan_height_statistics, scan_statistics, scans_seen
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.paper import TABLE_I, PaperCar
from sightline.scans.statistics.service import ScanStatistics, Spread
from sightline.scans.statistics.traffic import ScanTraffic, notes_of_overlaps, traffic_of_seen

router = APIRouter()
NOTHING = Said("stat-no-value")
_RATIO = "Measured over true, by weighted mean: 1.01 says that the baseline is 1 % too long."
Ratio = Annotated[RigEstimate, Field(description=_RATIO)]
Errors = Annotated[
    list[ErrorFiguresBody],
    Field(description="By lighting, metres: measured minus the maker's; Pearson's against the latter."),
]


@of_record(Spread)
class ScanSpreadBody(Out):
    """The distribution of one quantity over the vehicles, in its unit."""

    ecdf: Annotated[EcdfBody | ReasonBody, BeforeValidator(partial(part_body, empty=NOTHING))]
    density: DensityPart


@dataclass(frozen=True)
class PaperCarBody(PaperCar):
    """A row of Table I with the error of its length, size minus true length, which is not printed there."""

    length_error_m: float


@of_record(ScanStatistics)
class ScanStatisticsBody(Out):
    length_errors: Errors
    wheelbase_errors: Errors
    length_ratio: Ratio
    wheelbase_ratio: Ratio
    spreads: list[ScanSpreadBody] = Field(description="Speed, length, time gap, distance gap, headway.")
    heights: tuple[ScannedHeights, ...]
    paper: list[PaperCarBody]


@dataclass(frozen=True)
class ScanFlows:
    """`length_limits_m` part the length classes; `notes`: which line scans overlap, so that a vehicle may
    count in two.
    """

    minutes: int
    length_limits_m: tuple[float, ...]
    scans: tuple[ScanTraffic, ...]
    notes: list[Said]


@router.get("/surveys/{survey_id}/scan-statistics")
def get_scan_statistics(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    filmed: FilmedAsked,
    accepted_only: Annotated[bool, Query(description="false: those that wait for a review too.")] = True,
) -> ScanStatisticsBody:
    """Errors of length and wheelbase, distributions of speed and gaps, the paper's Table I beside it."""
    heights = scan_height_statistics(session, survey_id, accepted_only=accepted_only, filmed=filmed)
    statistics = scan_statistics(session, survey_id, accepted_only=accepted_only, filmed=filmed)
    paper = [filled_from(PaperCarBody, one, length_error_m=one.size_m - one.true_length_m) for one in TABLE_I]
    return ScanStatisticsBody.model_validate(
        {
            **vars(statistics),
            "length_errors": [error_figures(*one) for one in statistics.length_errors.items()],
            "wheelbase_errors": [error_figures(*one) for one in statistics.wheelbase_errors.items()],
            "spreads": [vars(one) for one in statistics.spreads],
            "heights": heights,
            "paper": paper,
        }
    )


@router.get("/surveys/{survey_id}/scan-traffic")
def get_scan_traffic(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    filmed: FilmedAsked,
    minutes: Annotated[int, Query(description="Of an interval: 1, 5, 15 or 60.")] = 15,
    accepted_only: Annotated[bool, Query(description="false: speeds that wait for a review too.")] = True,
) -> ScanFlows:
    """Flow, headways, speeds, occupancy and length classes per interval, by scan, direction and lane."""
    if minutes not in MINUTES:
        raise BadInput("scans-traffic-other-minutes", minutes=minutes)
    seen = scans_seen(session, survey_id, filmed)
    found = traffic_of_seen(seen, minutes, accepted_only=accepted_only)
    return ScanFlows(minutes, LENGTH_LIMITS_M, found, notes_of_overlaps(seen))
