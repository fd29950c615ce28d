"""Statistics of a survey's line scans."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import Out
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.infra.web.figures import DensityBody, EcdfBody, FigureBody, ReasonBody
from sightline.linescan.rig import RigEstimate
from sightline.messages.said import Said
from sightline.recordings.bodies import FilmedAsked
from sightline.scans.statistics.figures import scan_height_statistics, scan_statistics
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.paper import TABLE_I, PaperCar
from sightline.scans.statistics.service import CarRuns, ReferenceGroup, ScanRow, ScanStatistics, Spread
from sightline.statistics.distributions import Density, Ecdf, Percentile
from sightline.statistics.errors import ErrorGroup
from sightline.surveys.store import get_survey

router = APIRouter()
_RATIO = "Measured over true, by weighted mean: 1.01 says that the baseline is 1 % too long."


class ScanErrorGroupBody(Out):
    """Errors of one lighting, metres: measured minus the maker's; Pearson's against the maker's value."""

    group: str
    n: int
    figures: dict[str, FigureBody]
    reason: Said | None


class ScanSpreadBody(Out):
    """The distribution of one quantity over the vehicles, in its unit."""

    quantity: str
    unit: str
    n: int
    mean: float | None
    sd: float | None
    ecdf: EcdfBody | ReasonBody
    density: DensityBody | ReasonBody
    percentiles: list[Percentile]


@dataclass(frozen=True)
class PaperCarBody(PaperCar):
    """A row of Table I with the error of its length, size minus true length, which is not printed there."""

    length_error_m: float


class ScanStatisticsBody(Out):
    scans: int
    counted: dict[str, int]
    length_errors: list[ScanErrorGroupBody]
    wheelbase_errors: list[ScanErrorGroupBody]
    length_ratio: RigEstimate = Field(description=_RATIO)
    wheelbase_ratio: RigEstimate = Field(description=_RATIO)
    spreads: list[ScanSpreadBody] = Field(description="Speed, length, time gap, distance gap, headway.")
    table: tuple[ScanRow, ...]
    references: list[ReferenceGroup]
    cars: tuple[CarRuns, ...]
    heights: list[ScannedHeights]
    paper: list[PaperCarBody]


@router.get("/surveys/{survey_id}/scan-statistics")
def get_scan_statistics(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    filmed: FilmedAsked,
    accepted_only: Annotated[bool, Query(description="false: those that wait for a review too.")] = True,
) -> ScanStatisticsBody:
    """Errors of length and wheelbase, distributions of speed and gaps, the paper's Table I beside it."""
    get_survey(session, survey_id)
    heights = scan_height_statistics(session, survey_id, accepted_only=accepted_only, filmed=filmed)
    found = scan_statistics(session, survey_id, accepted_only=accepted_only, filmed=filmed)
    return _body(found, heights)


def _body(found: ScanStatistics, heights: tuple[ScannedHeights, ...]) -> ScanStatisticsBody:
    return ScanStatisticsBody(
        scans=found.scans,
        counted=found.counted,
        length_errors=_errors(found.length_errors),
        wheelbase_errors=_errors(found.wheelbase_errors),
        length_ratio=found.length_ratio,
        wheelbase_ratio=found.wheelbase_ratio,
        spreads=[_spread(one) for one in found.spreads],
        table=found.table,
        references=list(found.references),
        cars=found.cars,
        heights=list(heights),
        paper=[
            filled_from(PaperCarBody, one, length_error_m=one.size_m - one.true_length_m) for one in TABLE_I
        ],
    )


def _errors(groups: dict[str, ErrorGroup]) -> list[ScanErrorGroupBody]:
    return [
        ScanErrorGroupBody(
            group=name, n=one.n, reason=one.reason, figures={key: _figure(one, key) for key in one.figures}
        )
        for name, one in groups.items()
    ]


def _figure(group: ErrorGroup, name: str) -> FigureBody:
    return FigureBody(value=group.figures[name], ci95=group.ci95[name], reason=group.reason)


def _spread(one: Spread) -> ScanSpreadBody:
    return ScanSpreadBody(
        quantity=one.quantity,
        unit=one.unit,
        n=one.n,
        mean=one.mean,
        sd=one.sd,
        ecdf=_ecdf(one.ecdf),
        density=_density(one.density),
        percentiles=one.percentiles,
    )


def _ecdf(found: Ecdf | None) -> EcdfBody | ReasonBody:
    if found is None:
        return ReasonBody(reason=Said("stat-no-value"))
    columns = {name: getattr(found, name).tolist() for name in ("value", "share", "low", "high")}
    return EcdfBody(n=found.n, **columns)


def _density(found: Density | Said) -> DensityBody | ReasonBody:
    if isinstance(found, Said):
        return ReasonBody(reason=found)
    columns = {name: getattr(found, name).tolist() for name in ("value", "density", "low", "high")}
    return DensityBody(n=found.n, bandwidth=found.bandwidth, **columns)
