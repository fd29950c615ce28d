"""Holding the recordings of a package against the audit chain."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import Cells
from sightline.infra.csv_package.verify import says
from sightline.recordings.csv import RECORDINGS, drift_cells, drift_of
from sightline.recordings.drift import DriftDecision, DriftFigures

_MAKES = ("create", "update", "ingest")


@dataclass(eq=False)
class RecordingEvents:
    """What the events say of recordings, by number; `drift`: what was found of the camera, by pose too."""

    facts: dict[int, dict[str, Any]] = field(default_factory=dict)
    drift: dict[int, dict[int, DriftFigures]] = field(default_factory=dict)
    decisions: dict[int, DriftDecision | None] = field(default_factory=dict)

    def add(self, action: str, number: int, after: dict[str, Any]) -> None:
        """An event of a recording."""
        if action in _MAKES:
            self.facts.setdefault(number, {"pose_id": None}).update(after)
        elif action == "check_drift":
            self.drift.setdefault(number, {})[int(after["pose_id"])] = after["found"]
        elif "drift_decision" in after:
            self.decisions[number] = after["drift_decision"]

    def attach(self, number: int, pose_id: int) -> None:
        """A road pose came into force."""
        self.facts.setdefault(number, {})["pose_id"] = pose_id


def check_recordings(files: Files, events: RecordingEvents) -> None:
    """Recordings are what their events made of them. Raises Damaged."""
    for row in read_rows(files, RECORDINGS.path):
        number = int(row["id"])
        made = events.facts.pop(number, None)
        if made is None or not says(RECORDINGS, row, {**made, **_drift(events, number, row["pose_id"])}):
            raise Damaged("recordings-recordings-csv-not-what-audit-events", id=row["id"])


def _drift(events: RecordingEvents, number: int, pose: str) -> Cells:
    """The columns about a camera that moved, as the events tell them."""
    pose_id = int(pose) if pose else None
    found = None if pose_id is None else events.drift.get(number, {}).get(pose_id)
    return drift_cells(drift_of(found, events.decisions.get(number), pose_id))
