"""Traffic of a survey's line scans."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.enums import ScanDirection
from sightline.errors import BadInput
from sightline.infra.web.bodies import Out
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.linescan.traffic import LENGTH_LIMITS_M, MINUTES, Figure, LengthClass
from sightline.messages.said import Said
from sightline.recordings.bodies import FilmedAsked
from sightline.scans.statistics.figures import scan_traffic
from sightline.scans.statistics.traffic import ScanTraffic, ShownInterval
from sightline.statistics.distributions import Percentile
from sightline.surveys.store import get_survey

router = APIRouter()
_EDGE = "Passed so near to an edge that the clock leaves it open on which side (95 %)."
_POISSON = "Ends of the exact 95 % interval for vehicles that come independently of each other."


class TrafficIntervalBody(Out):
    """Traffic past camera 1 from `begins_at` on; `partial`: the recording covers only a part of it.

    Every vehicle counts for flow and occupancy, the `measured` ones for speeds. `u`: standard uncertainties
    (k = 1); `reasons` say why a figure is missing.
    """

    begins_at: str = Field(description="By the clocks of the place, ISO 8601 with offset.")
    watched_s: float
    partial: bool
    vehicles: int
    near_edge: int = Field(description=_EDGE)
    refused: int = Field(description="Those whose motion could not be measured.")
    measured: int
    flow_per_hour: float
    flow_low: float = Field(description=_POISSON)
    flow_high: float
    mean_headway_s: float | None
    time_mean_speed_mps: Figure
    space_mean_speed_mps: Figure
    percentiles: list[Percentile]
    occupancy_percent: Figure
    density_per_km: Figure
    classes: list[LengthClass]
    unclassed: int
    reasons: list[Said]


class ScanTrafficBody(Out):
    """The traffic of one line scan in one direction and lane; `reason`: why it has no intervals."""

    scan_id: int
    name: str
    direction: ScanDirection = Field(description="Which camera its vehicles reached first.")
    lane: str | None = Field(description="Of the rig's lanes; null: not known, or the rig has none.")
    intervals: list[TrafficIntervalBody]
    unplaced: int = Field(description="Never measured, so in no interval.")
    reason: Said | None


class ScanFlows(Out):
    """`length_limits_m` part the length classes."""

    minutes: int
    length_limits_m: list[float]
    scans: list[ScanTrafficBody]


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
    get_survey(session, survey_id)
    if minutes not in MINUTES:
        raise BadInput("scans-traffic-other-minutes", minutes=minutes)
    found = scan_traffic(session, survey_id, minutes, accepted_only=accepted_only, filmed=filmed)
    return ScanFlows(
        minutes=minutes, length_limits_m=list(LENGTH_LIMITS_M), scans=[_body(one) for one in found]
    )


def _body(one: ScanTraffic) -> ScanTrafficBody:
    return ScanTrafficBody(
        scan_id=one.scan_id,
        name=one.name,
        direction=one.direction,
        lane=one.lane,
        intervals=[_interval(each) for each in one.intervals],
        unplaced=one.unplaced,
        reason=one.reason,
    )


def _interval(one: ShownInterval) -> TrafficIntervalBody:
    names = set(TrafficIntervalBody.model_fields) - {"begins_at", "percentiles"}
    values = {name: getattr(one.interval, name) for name in names}
    return TrafficIntervalBody.model_validate(
        {**values, "begins_at": one.begins_at, "percentiles": one.percentiles}
    )
