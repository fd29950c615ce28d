"""What a recording tells of its measurements: when each was filmed, and which stand on frames where the
camera was not where its road pose says.

Derived whenever measurements are read, from what was found of the recording and what people said; no
revision is changed for it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from sqlalchemy import or_, select
from sqlalchemy.orm import Session

from sightline.infra.by_name import filled_from
from sightline.measurements.moved import drift_flag
from sightline.measurements.records import Clicks, Measurement
from sightline.measurements.road_poses import road_pose
from sightline.recordings.drift import MovedSpan, open_spans
from sightline.recordings.filming import Filming, filming_of
from sightline.recordings.tables import recordings

#: What is read of a recording for it.
TELLING = (recordings.c.drift, recordings.c.drift_decision, recordings.c.started_at, recordings.c.time_zone)


def derived(session: Session, found: tuple[Measurement, ...]) -> tuple[Measurement, ...]:
    """The measurements with when they were filmed, those on a frame after a bump with the sentence that says
    so.
    """
    told = _told_by_recordings(session, {one.recording_id for one in found})
    if not told:
        return found
    spans = {
        (id_, pose): open_spans(told[id_]["drift"], told[id_]["drift_decision"], pose)
        for id_, pose in {(one.recording_id, one.values.pose_id) for one in found}
        if id_ in told
    }
    filmed = {id_: filming_of(row) for id_, row in told.items()}
    return tuple(
        [
            _with(
                *(session, one, spans.get((one.recording_id, one.values.pose_id), [])),
                filmed.get(one.recording_id),
            )
            for one in found
        ]
    )


def derived_from(session: Session, one: Measurement, row: Mapping[Any, Any]) -> Measurement:
    """`derived` of one measurement with whose row the recording's `TELLING` was read."""
    spans = open_spans(row["drift"], row["drift_decision"], one.values.pose_id)
    return _with(session, one, spans, filming_of(row))


def _told_by_recordings(session: Session, wanted: Iterable[int]) -> dict[int, Mapping[Any, Any]]:
    """Rows of recordings that tell anything, by number."""
    ids = sorted(wanted)
    if not ids:
        return {}
    query = select(recordings.c.id, *TELLING).where(
        recordings.c.id.in_(ids), or_(recordings.c.drift.is_not(None), recordings.c.started_at.is_not(None))
    )
    return {row["id"]: row for row in session.execute(query).mappings()}


def _with(session: Session, one: Measurement, spans: list[MovedSpan], filmed: Filming | None) -> Measurement:
    flag = None
    if spans:
        flag = drift_flag(road_pose(session, one.values.pose_id), filled_from(Clicks, one.values), spans)
    if flag == one.drift_flag and filmed is None:
        return one
    at = None if filmed is None else filmed.at(one.values.time_s)
    return replace(one, drift_flag=flag, filmed_at=at)
