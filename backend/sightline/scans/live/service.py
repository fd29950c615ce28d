"""The live page of a survey: each stream with its health, its last vehicles and its flow."""

from collections.abc import Sequence
from datetime import datetime, timedelta

from sightline.coverage import expanded
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.database.types import now
from sightline.scans.live.records import FlowMinute, LivePassing, LiveScan, LiveStream
from sightline.scans.live.state import live_state
from sightline.scans.live.store import fronts_of, list_live_scans
from sightline.scans.references.store import standing_references
from sightline.scans.store import get_scan
from sightline.scans.vehicles.listing import ShownVehicle, shown_vehicles
from sightline.scans.vehicles.store import last_scan_vehicles

LAST = 20
FLOW_MINUTES = 60
_STREAMS = 4


def live_streams(session: Session, survey_id: int) -> list[LiveStream]:
    """The streams of a survey, newest first; at most four."""
    by_stream: dict[str, list[LiveScan]] = {}
    for one in list_live_scans(session, survey_id):
        by_stream.setdefault(one.stream, []).append(one)
    return [_stream(session, scans) for scans in list(by_stream.values())[:_STREAMS]]


def flow_of(
    fronts: Sequence[datetime], watched: Sequence[tuple[datetime, datetime]]
) -> tuple[FlowMinute, ...]:
    """Vehicles a minute of the clock, the last hour of it. `watched`: from when to when, of each of the
    recordings.
    """
    stretches = list[tuple[datetime, datetime]]()
    for since, until in sorted(watched):
        if stretches and since <= stretches[-1][1]:
            since, before = stretches.pop()
            until = max(before, until)
        stretches.append((since, until))
    last = stretches[-1][1].replace(second=0, microsecond=0)
    begin = stretches[0][0].replace(second=0, microsecond=0)
    first = max(begin, last - timedelta(minutes=FLOW_MINUTES - 1))
    count = int((last - first) / timedelta(minutes=1)) + 1
    counted = [0] * count
    for front in fronts:
        at = int((front - first) // timedelta(minutes=1))
        if 0 <= at < count:
            counted[at] += 1
    minutes = [first + timedelta(minutes=k) for k in range(count)]
    return tuple(
        FlowMinute(
            minute,
            vehicles,
            any(since <= minute and minute + timedelta(minutes=1) <= until for since, until in stretches),
        )
        for minute, vehicles in zip(minutes, counted, strict=True)
    )


def _stream(session: Session, scans: list[LiveScan]) -> LiveStream:
    newest = scans[0]
    until = _until(newest)
    recent = [one for one in scans if _until(one) > until - timedelta(minutes=FLOW_MINUTES)]
    begun = {one.scan_id: one for one in recent}
    # in view where a later recording begins, one was told of the recording before
    fronts = [
        _time(begun[scan_id], line)
        for scan_id, line in fronts_of(session, list(begun))
        if line > 0 or scan_id == scans[-1].scan_id
    ]
    flow = flow_of(fronts, [(one.began_at, _until(one)) for one in recent])
    found = last_scan_vehicles(session, newest.scan_id, LAST + 1)
    references = standing_references(session, newest.scan_id)
    listed = shown_vehicles(get_scan(session, newest.scan_id), found, references)[-LAST:]
    return filled_from(
        LiveStream,
        newest,
        state=live_state(newest.heard_at, newest.ended_at, now()),
        until=until,
        vehicles=tuple(_passing(newest, one) for one in reversed(listed)),
        flow=flow,
        earlier=tuple(scans[1:13]),
    )


def _until(scan: LiveScan) -> datetime:
    return _time(scan, scan.health.lines if scan.health else 0)


def _passing(scan: LiveScan, shown_vehicle: ShownVehicle) -> LivePassing:
    vehicle = shown_vehicle.vehicle
    if vehicle.measurement is None:
        return LivePassing(id=vehicle.id, number=vehicle.number, front_at=scan.began_at)
    values = vehicle.measurement.values
    return filled_from(
        LivePassing,
        values,
        id=vehicle.id,
        number=vehicle.number,
        front_at=_time(scan, values.front_line_1),
        axles=values.axles,
        U95_speed_mps=expanded(values.u_speed_mps),
        U95_length_m=expanded(values.u_length_m),
        time_gap_s=shown_vehicle.gap and shown_vehicle.gap.time_gap_s,
    )


def _time(scan: LiveScan, line: float) -> datetime:
    return scan.began_at + timedelta(seconds=line / scan.line_rate_hz)
