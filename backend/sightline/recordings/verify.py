"""Holding the recordings of a package against the audit chain."""

from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from sightline.enums import JsonObject
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay, Told, hold_all
from sightline.recordings.csv import RECORDINGS, drift_cells, drift_of, started_text
from sightline.recordings.drift import DriftDecision, DriftFigures, MovedSpan, undecided_spans

#: What no event names is in no cell either.
_NOTHING = dict.fromkeys(RECORDINGS.header)


@dataclass(eq=False)
class DriftEvents:
    """What the events say of recordings' cameras that moved, by recording and pose, and what was decided."""

    found: dict[int, dict[int, DriftFigures]] = field(default_factory=dict)
    spans: dict[int, dict[int, list[JsonObject]]] = field(default_factory=dict)
    decisions: dict[int, DriftDecision | None] = field(default_factory=dict)

    def add(self, number: int, after: dict[str, Any]) -> bool:
        """An event of a recording; whether it says no more than that."""
        if "spans" in after:
            self.found.setdefault(number, {})[int(after["pose_id"])] = after["found"]
            self.spans.setdefault(number, {})[int(after["pose_id"])] = after["spans"]
        elif "drift_decision" in after:
            self.decisions[number] = after["drift_decision"]
        else:
            return False
        return True

    def open_spans(self, number: int, pose_id: int) -> list[MovedSpan]:
        """Where the camera had moved since the pose and nobody decided to keep it."""
        spans = self.spans.get(number, {}).get(pose_id)
        if not spans:
            return []
        floor_px = self.found[number][pose_id]["floor_px"]
        return undecided_spans(spans, self.decisions.get(number), pose_id, floor_px)

    def cells(self, recording: Told) -> dict[str, Any]:
        """The cells of a recording's row."""
        number, start, pose_id = recording["id"], recording.get("started_at"), recording.get("pose_id")
        at = None if start is None else datetime.fromisoformat(start)
        drift_check = None if pose_id is None else self.found.get(number, {}).get(int(pose_id))
        return {
            **_NOTHING,
            **recording,
            "variable_rate": recording.get("vfr", False),
            "started_at": started_text(at, recording.get("time_zone")),
            **drift_cells(drift_of(drift_check, self.decisions.get(number), pose_id)),
        }


def check_recordings(files: Files, replay: Replay, drift: DriftEvents) -> None:
    """Recordings are what their events made of them, and none is missing. Raises Damaged."""
    hold_all(files, RECORDINGS, map(drift.cells, replay.standing("recording")))
