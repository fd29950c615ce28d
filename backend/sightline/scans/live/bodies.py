"""Bodies of the live page. Metres, seconds, times in UTC; U95 = 1.96 u."""

from datetime import datetime

from sightline.enums import LiveState, MeasurementStatus, ScanDirection
from sightline.infra.web.bodies import Out
from sightline.messages.said import Said
from sightline.scans.live.records import FlowMinute, LiveHealth


class LiveVehicleBody(Out):
    """One of the last vehicles; `front_at`: when its front reached camera 1."""

    id: int
    number: int
    front_at: datetime
    direction: ScanDirection | None
    lane: str | None
    axles: int | None
    speed_mps: float | None
    U95_speed_mps: float | None
    length_m: float | None
    U95_length_m: float | None
    time_gap_s: float | None
    status: MeasurementStatus | None
    reason: Said | None


class LiveScanBody(Out):
    """A recording of a stream."""

    scan_id: int
    name: str
    ready: bool
    began_at: datetime


class LiveStreamBody(LiveScanBody):
    """A stream by its newest recording."""

    state: LiveState
    source: str
    heard_at: datetime
    until: datetime
    line_rate_hz: float
    health: LiveHealth | None
    vehicles: list[LiveVehicleBody]
    flow: list[FlowMinute]
    earlier: list[LiveScanBody]
