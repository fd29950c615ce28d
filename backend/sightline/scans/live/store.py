"""Live streams in the database: their state, and what the live page asks for."""

from collections.abc import Sequence
from dataclasses import asdict, fields
from datetime import datetime

from sqlalchemy import select, update
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.infra.database.rows import add_row, get_row
from sightline.infra.database.types import now
from sightline.messages.said import Said
from sightline.scans.live.records import STANDARD_INPUT, LiveHealth, LiveScan, LiveSegment, SegmentFacts
from sightline.scans.live.tables import scan_live
from sightline.scans.tables import scan_measurements, scan_vehicles, scans


def add_live_scan(
    session: Session, survey_id: int, scan_id: int, segment: SegmentFacts, line_rate_hz: float
) -> None:
    """A recording that a stream has begun."""
    source = None if segment.source == STANDARD_INPUT else segment.source
    place = {"survey_id": survey_id, "scan_id": scan_id, "stream": segment.stream, "source": source}
    times = {"line_rate_hz": line_rate_hz, "began_at": segment.began_at, "heard_at": now()}
    add_row(session, scan_live, place | times)


def live_segments(session: Session, survey_id: int, stream: str, began_at: datetime) -> list[LiveSegment]:
    """The recordings of a segment's stream and moment, newest first: its own, and that of one that was taken
    up at its very beginning.
    """
    of = scan_live.c
    query = (
        select(of.scan_id, of.ended_at.is_not(None).label("ended"), scans.c.deleted_at)
        .join(scans, scans.c.id == of.scan_id)
        .where(of.survey_id == survey_id, of.stream == stream, of.began_at == began_at)
        .order_by(of.id.desc())
    )
    rows = session.execute(query)
    return [
        LiveSegment(scan_id=row.scan_id, ended=row.ended, deleted=row.deleted_at is not None) for row in rows
    ]


def is_live(session: Session, scan_id: int) -> bool:
    """Whether a stream still adds to a recording. Raises NotFound (also when it was deleted)."""
    row = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    return bool(row["state"] == "live")


def passings_stored(session: Session, scan_id: int, front_lines: Sequence[float]) -> set[tuple[float, float]]:
    """(front line, rear line at camera 1, as first measured) of a recording's vehicles with such fronts,
    deleted ones too.
    """
    of = scan_measurements.c
    query = select(of.front_line_1, of.rear_line_1).where(of.scan_id == scan_id, of.revision == 1)
    rows = session.execute(query.where(of.front_line_1.in_(front_lines)))
    return {(row.front_line_1, row.rear_line_1) for row in rows}


def hear_live_scan(session: Session, scan_id: int, health: LiveHealth) -> None:
    """How its stream is now."""
    values = {"heard_at": now(), "health": asdict(health)}
    session.execute(update(scan_live).where(scan_live.c.scan_id == scan_id).values(values))


def end_live_scan(session: Session, scan_id: int) -> None:
    """Its stream has ended."""
    ended = update(scan_live).where(scan_live.c.scan_id == scan_id).values(ended_at=now())
    session.execute(ended)


def list_live_scans(session: Session, survey_id: int) -> tuple[LiveScan, ...]:
    """The recordings of streams of a survey, newest first."""
    query = (
        select(scan_live, scans.c.name, scans.c.state)
        .join(scans, scans.c.id == scan_live.c.scan_id)
        .where(scan_live.c.survey_id == survey_id, scans.c.deleted_at.is_(None))
        .order_by(scan_live.c.id.desc())
    )
    return tuple(_live_scan(dict(row)) for row in session.execute(query).mappings())


def fronts_of(session: Session, scan_ids: Sequence[int]) -> list[tuple[int, float]]:
    """(scan, front line at camera 1), as first measured, of the vehicles that stand."""
    query = (
        select(scan_measurements.c.scan_id, scan_measurements.c.front_line_1)
        .join(scan_vehicles, scan_vehicles.c.id == scan_measurements.c.vehicle_id)
        .where(
            scan_measurements.c.scan_id.in_(scan_ids),
            scan_measurements.c.revision == 1,
            scan_vehicles.c.deleted_at.is_(None),
        )
    )
    return [(row.scan_id, row.front_line_1) for row in session.execute(query)]


def _live_scan(row: JsonObject) -> LiveScan:
    health = row["health"]
    pairs = ("lost_lines", "light_dn", "saturated")
    if health is not None:
        words = tuple(Said.read(one) for one in health["words"])
        health = LiveHealth(**{**health, **{name: tuple(health[name]) for name in pairs}, "words": words})
    apart = ("ready", "health")
    told = {one.name: row[one.name] for one in fields(LiveScan) if one.name not in apart}
    return LiveScan(**told, ready=row["state"] == "ready", health=health)
