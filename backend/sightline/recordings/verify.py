"""Holding the recordings of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import Cells
from sightline.infra.csv_package.verify import says
from sightline.messages.said import Said
from sightline.recordings.csv import RECORDINGS, drift_cells, drift_of, started_text
from sightline.recordings.drift import DriftDecision, DriftFigures, SpanTold, flag_of_frames, undecided

_MAKES = ("create", "update", "ingest")
#: What no event names is in no cell either.
_NOTHING = dict.fromkeys(RECORDINGS.header)


@dataclass(eq=False)
class RecordingEvents:
    """What the events say of recordings, by number; `drift`, `spans`: what was found of the camera, by pose
    too.
    """

    facts: dict[int, dict[str, Any]] = field(default_factory=dict)
    drift: dict[int, dict[int, DriftFigures]] = field(default_factory=dict)
    spans: dict[int, dict[int, list[SpanTold]]] = field(default_factory=dict)
    decisions: dict[int, DriftDecision | None] = field(default_factory=dict)

    def add(self, action: str, number: int, after: dict[str, Any]) -> None:
        """An event of a recording."""
        if action in _MAKES:
            self.facts.setdefault(number, {}).update(after)
        elif action == "delete":
            self.facts.pop(number, None)
        elif action == "check_drift":
            self.drift.setdefault(number, {})[int(after["pose_id"])] = after["found"]
            self.spans.setdefault(number, {})[int(after["pose_id"])] = after["spans"]
        elif "drift_decision" in after:
            self.decisions[number] = after["drift_decision"]

    def attach(self, number: int, pose_id: int) -> None:
        """A road pose came into force."""
        self.facts.setdefault(number, {})["pose_id"] = pose_id

    def pose_in_force(self, number: int) -> int | None:
        """The road pose of a recording; None where it has none or was deleted."""
        pose_id = self.facts.get(number, {}).get("pose_id")
        return None if pose_id is None else int(pose_id)

    def drift_flag(self, number: int, pose_id: int, frames: Sequence[int]) -> Said | None:
        """What is said of a height on these frames where the camera had moved since the pose."""
        spans = self.spans.get(number, {}).get(pose_id)
        if not spans:
            return None
        floor_px = self.drift[number][pose_id]["floor_px"]
        return flag_of_frames(undecided(spans, self.decisions.get(number), pose_id, floor_px), frames)


def check_recordings(files: Files, events: RecordingEvents) -> None:
    """Recordings are what their events made of them, and none is missing. Raises Damaged."""
    left = set(events.facts)
    for row in read_rows(files, RECORDINGS.path):
        number = int(row["id"])
        made = events.facts.get(number)
        if made is None or not says(RECORDINGS, row, _cells(events, number, made, row["pose_id"])):
            raise Damaged("recordings-recordings-csv-not-what-audit-events", id=row["id"])
        left.discard(number)
    if left:
        raise Damaged("recordings-recordings-csv-not-what-audit-events", id=min(left))


def _cells(events: RecordingEvents, number: int, made: Mapping[str, Any], pose: str) -> dict[str, Any]:
    told = {**_NOTHING, **made, "id": number, "variable_rate": made.get("vfr", False)}
    start = made.get("started_at")
    at = None if start is None else datetime.fromisoformat(start)
    told["started_at"] = started_text(at, made.get("time_zone"))
    return {**told, **_drift(events, number, pose)}


def _drift(events: RecordingEvents, number: int, pose: str) -> Cells:
    """The columns about a camera that moved, as the events tell them."""
    pose_id = int(pose) if pose else None
    found = None if pose_id is None else events.drift.get(number, {}).get(pose_id)
    return drift_cells(drift_of(found, events.decisions.get(number), pose_id))
