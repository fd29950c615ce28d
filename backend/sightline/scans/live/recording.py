"""A recording that a stream makes, in the caller's transaction. All of it may be done again: a commit whose
answer was lost may have been one, and what is there is not stored twice.
"""

from collections.abc import Collection, Sequence

from sightline.enums import ScanMethod
from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.linescan.parts import Rig
from sightline.messages.said import Said
from sightline.scans.live.records import LiveHealth, SegmentFacts
from sightline.scans.live.store import (
    add_live_scan,
    end_live_scan,
    hear_live_scan,
    is_live,
    live_segments,
    passings_stored,
)
from sightline.scans.records import LiveSource, ScanValues, StripSource
from sightline.scans.service import queue_reading
from sightline.scans.store import create_scan, get_scan, note_reading_failed, note_scan_recorded
from sightline.scans.vehicles.find_job import run_values
from sightline.scans.vehicles.measurement_store import append_scan_measurements
from sightline.scans.vehicles.motion import motion_of
from sightline.scans.vehicles.run_store import add_scan_run
from sightline.scans.vehicles.store import create_scan_vehicles, list_scan_vehicles

NOT_KEPT = Said("scans-lines-not-stored")


def begin_recording(
    session: Session,
    survey_id: int,
    segment: SegmentFacts,
    rig: Rig,
    others: Collection[int],
    *,
    actor: int | None,
) -> int:
    """The number of a segment's recording, made unless it is there; `others`: those of other segments."""
    there = live_segments(session, survey_id, segment.stream, segment.began_at)
    own = (one.scan_id for one in there if not one.ended and one.scan_id not in others)
    if (scan_id := next(own, None)) is None:
        source = LiveSource()
        scan_id = create_scan(
            session, survey_id, name=segment.name, source=source, time_axis="height", rig=rig, actor=actor
        ).id
        add_live_scan(session, survey_id, scan_id, segment, rig.line_rate_hz)
    return scan_id


def add_to_recording(
    session: Session,
    scan_id: int,
    vehicles: Sequence[ScanValues],
    health: LiveHealth | None,
    *,
    actor: int | None,
) -> None:
    """Those of the vehicles that are not there, and how the stream is now. Raises NotFound, Conflict for a
    recording to which no stream adds.
    """
    if not is_live(session, scan_id):
        raise Conflict("scans-not-live", name=get_scan(session, scan_id).name)
    stored = passings_stored(session, scan_id, [one.front_line_1 for one in vehicles])
    by_lines = {(one.front_line_1, one.rear_line_1): one for one in vehicles}
    new = [one for lines, one in by_lines.items() if lines not in stored]
    if new:
        made = create_scan_vehicles(session, scan_id, len(new), origin="found", actor=actor)
        append_scan_measurements(session, scan_id, list(zip(made, new, strict=True)), actor=actor)
    if health is not None:
        hear_live_scan(session, scan_id, health)


def end_recording(
    session: Session,
    scan_id: int,
    strips: tuple[StripSource, StripSource] | None,
    rig: Rig,
    method: ScanMethod,
    notes: Sequence[Said],
    told: int,
    *,
    actor: int | None,
) -> None:
    """Its strips (None: not kept) are stored, unless it has ended before. Where fewer vehicles are stored
    than were told, as of a stream that was killed while they waited, they are looked for once the strips are
    read.
    """
    if not is_live(session, scan_id):
        return
    stored = list_scan_vehicles(session, scan_id, deleted=True)
    motions = [
        motion_of(one.measurement.values)
        for one in stored
        if one.origin == "found" and one.measurement is not None
    ]
    run = run_values(method, rig, motions, len(motions), notes)
    add_scan_run(session, scan_id, run, actor=actor)
    end_live_scan(session, scan_id)
    if strips is None:
        note_reading_failed(session, scan_id, NOT_KEPT, actor=actor)
    else:
        note_scan_recorded(session, scan_id, strips, actor=actor)
        find = method if len(motions) < told else None
        queue_reading(session, get_scan(session, scan_id), find, actor)
