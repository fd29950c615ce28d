"""What a recording tells of its measurements: when each was filmed, and which stand on frames where the
camera was not where its road pose says.

Derived whenever measurements are read, from what was found of the recording and what people said; no
revision is changed for it.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sqlalchemy import or_, select
from sqlalchemy.orm import Session

from sightline.infra.by_name import filled_from
from sightline.measurements.moved import drift_flags
from sightline.measurements.records import Clicks, Measurement
from sightline.measurements.road_poses import road_pose
from sightline.messages.said import Said
from sightline.recordings.drift import MovedSpan, open_spans
from sightline.recordings.filming import Filming, filming_of
from sightline.recordings.tables import recordings

#: What is read of a recording for it.
TELLING = (recordings.c.drift, recordings.c.drift_decision, recordings.c.started_at, recordings.c.time_zone)


def add_filming_and_drift(session: Session, revisions: tuple[Measurement, ...]) -> tuple[Measurement, ...]:
    """The measurements with when they were filmed, those on a frame after a bump with a sentence of it."""
    recording_rows = _told_by_recordings(session, {one.recording_id for one in revisions})
    if not recording_rows:
        return revisions
    spans = {
        (id_, pose): open_spans(recording_rows[id_]["drift"], recording_rows[id_]["drift_decision"], pose)
        for id_, pose in {(one.recording_id, one.values.pose_id) for one in revisions}
        if id_ in recording_rows
    }
    filmed = {id_: filming_of(row) for id_, row in recording_rows.items()}
    of_pose = defaultdict[tuple[int, int], list[int]](list)
    for at, one in enumerate(revisions):
        of_pose[one.recording_id, one.values.pose_id].append(at)
    flags: dict[int, Said | None] = {}
    for key, places in of_pose.items():
        flags |= zip(
            places, _flags(session, [revisions[at] for at in places], spans.get(key, [])), strict=True
        )
    return tuple(
        [_add_flag_and_time(one, flags[at], filmed.get(one.recording_id)) for at, one in enumerate(revisions)]
    )


def derived_from(session: Session, measurement: Measurement, row: Mapping[Any, Any]) -> Measurement:
    """`add_filming_and_drift` of one measurement with whose row the recording's `TELLING` was read."""
    spans = open_spans(row["drift"], row["drift_decision"], measurement.values.pose_id)
    (flag,) = _flags(session, [measurement], spans)
    return _add_flag_and_time(measurement, flag, filming_of(row))


def _told_by_recordings(session: Session, wanted: Iterable[int]) -> dict[int, Mapping[Any, Any]]:
    """Rows of recordings that tell anything, by number."""
    ids = sorted(wanted)
    if not ids:
        return {}
    query = select(recordings.c.id, *TELLING).where(
        recordings.c.id.in_(ids), or_(recordings.c.drift.is_not(None), recordings.c.started_at.is_not(None))
    )
    return {row["id"]: row for row in session.execute(query).mappings()}


def _flags(session: Session, revisions: Sequence[Measurement], spans: list[MovedSpan]) -> list[Said | None]:
    """What is said of measurements with one pose where the camera had moved in `spans`."""
    if not spans:
        return [None] * len(revisions)
    clicks = [filled_from(Clicks, one.values) for one in revisions]
    return drift_flags(road_pose(session, revisions[0].values.pose_id), clicks, spans)


def _add_flag_and_time(measurement: Measurement, flag: Said | None, filmed: Filming | None) -> Measurement:
    if flag == measurement.drift_flag and filmed is None:
        return measurement
    at = None if filmed is None else filmed.at(measurement.values.time_s)
    return replace(measurement, drift_flag=flag, filmed_at=at)
