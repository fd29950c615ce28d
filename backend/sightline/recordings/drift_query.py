"""Which measurements stand on frames where the camera was not where its road pose says.

Derived whenever measurements are read, from what was found of the recording and what people decided; no
revision is changed for it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.measurements.records import Measurement
from sightline.recordings.tables import recordings


@dataclass(frozen=True, slots=True)
class MovedSpan:
    """Frames on which the camera had moved by `moved_px`; heights are then off by up to `change_m`."""

    first_frame: int
    last_frame: int
    moved_px: float
    change_m: float | None


def drift_check_of(drift: JsonObject | None, pose_id: int | None) -> JsonObject | None:
    """What was found against one road pose; None where nobody looked."""
    if drift is None or pose_id is None:
        return None
    found: JsonObject | None = drift["checks"].get(str(pose_id))
    return found


def drift_figures(check: JsonObject) -> JsonObject:
    """What a check found, in a few figures: the largest motion and the largest change of a height where the
    camera moved, None where it did not.
    """
    moved = [span for span in check["spans"] if span["moved"]]
    changes = [abs(span["change_m"]) for span in moved if span["change_m"] is not None]
    return {
        "state": check["state"],
        "floor_px": check.get("floor_px"),
        "moved_px": max((span["moved_px"] for span in moved), default=None),
        "height_m": max(changes, default=None),
        "checked_at": check.get("checked_at"),
    }


def open_spans(drift: JsonObject | None, decision: JsonObject | None, pose_id: int | None) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    check = drift_check_of(drift, pose_id)
    if check is None:
        return []
    spans = [MovedSpan(**{name: one[name] for name in _NAMES}) for one in check["spans"] if one["moved"]]
    return [one for one in spans if not _decided(one, decision, pose_id, check["floor_px"])]


_NAMES = ("first_frame", "last_frame", "moved_px", "change_m")


def _decided(span: MovedSpan, decision: JsonObject | None, pose_id: int | None, floor_px: float) -> bool:
    """Whether somebody saw this very motion and let it stand; a larger one found since is another."""
    if decision is None or decision["pose_id"] != pose_id:
        return False
    return any(
        one["first_frame"] <= span.last_frame
        and span.first_frame <= one["last_frame"]
        and span.moved_px <= one["moved_px"] + floor_px
        for one in decision["spans"]
    )


def sentence(span: MovedSpan) -> str:
    """The flag of a measurement on such a frame."""
    off = "" if span.change_m is None else f", heights are off by up to {abs(span.change_m) * 1000:.0f} mm"
    return (
        f"The camera had moved by {span.moved_px:.1f} px since its road pose{off}; take a new road pose for "
        "this part, or decide that the old one is still good."
    )


def flagged(session: Session, found: tuple[Measurement, ...]) -> tuple[Measurement, ...]:
    """The measurements, those on a frame after a bump with the sentence that says so."""
    spans = _spans_by_pose(session, {(one.recording_id, one.values.pose_id) for one in found})
    if not spans:
        return found
    return tuple([_with_flag(one, spans.get((one.recording_id, one.values.pose_id), [])) for one in found])


def flagged_by(one: Measurement, drift: JsonObject | None, decision: JsonObject | None) -> Measurement:
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
    frames = one.values.frames
    on = [span for span in spans if any(span.first_frame <= n <= span.last_frame for n in frames)]
    if not on:
        return one
    return replace(one, drift_flag=sentence(max(on, key=lambda span: span.moved_px)))
