"""Which measurements stand on frames where the camera was not where its road pose says.

Derived whenever measurements are read, from what was found of the recording and what people decided; no
revision is changed for it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.measurements.records import Measurement
from sightline.recordings.drift import DriftChecks, DriftDecision, MovedSpan, flag_of_frames, open_spans
from sightline.recordings.tables import recordings


def flagged(session: Session, found: tuple[Measurement, ...]) -> tuple[Measurement, ...]:
    """The measurements, those on a frame after a bump with the sentence that says so."""
    spans = _spans_by_pose(session, {(one.recording_id, one.values.pose_id) for one in found})
    if not spans:
        return found
    return tuple([_with_flag(one, spans.get((one.recording_id, one.values.pose_id), [])) for one in found])


def flagged_by(one: Measurement, drift: DriftChecks | None, decision: DriftDecision | None) -> Measurement:
    """`flagged` of one measurement whose recording's drift and decision were read with it."""
    return _with_flag(one, open_spans(drift, decision, one.values.pose_id))


def _spans_by_pose(
    session: Session, wanted: Iterable[tuple[int, int]]
) -> Mapping[tuple[int, int], list[MovedSpan]]:
    pairs = sorted(wanted)
    if not pairs:
        return {}
    chosen = (recordings.c.id, recordings.c.drift, recordings.c.drift_decision)
    query = select(*chosen).where(
        recordings.c.id.in_({recording for recording, _ in pairs}), recordings.c.drift.is_not(None)
    )
    documents: dict[int, Any] = {row.id: row for row in session.execute(query)}
    found = {}
    for recording_id, pose_id in pairs:
        if (row := documents.get(recording_id)) is not None:
            spans = open_spans(row.drift, row.drift_decision, pose_id)
            if spans:
                found[recording_id, pose_id] = spans
    return found


def _with_flag(one: Measurement, spans: list[MovedSpan]) -> Measurement:
    flag = flag_of_frames(spans, one.values.frames)
    return one if flag is None else replace(one, drift_flag=flag)
