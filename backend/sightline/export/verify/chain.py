"""Checking the audit chain of an export, and what its events say of every row."""

import json
from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

from sightline.errors import Damaged
from sightline.export.seal import ENTITY, Seal
from sightline.infra.audit.hashing import GENESIS
from sightline.infra.csv_package.chain import Event, chain, stamp
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay
from sightline.measurements.again.verify import count_revisions
from sightline.measurements.verify import MeasurementEvents
from sightline.quality.repeats.csv import REPEATS
from sightline.recordings.verify import DriftEvents
from sightline.reviews.lots.verify import LotEvents
from sightline.scans.heights.verify import height_or_verdict
from sightline.scans.verify import WITHIN as SCANS_WITHIN

#: What is deleted with what it is part of: by which word of its events, and what that is.
_WITHIN = {"review": ("vehicle_id", "vehicle"), **SCANS_WITHIN}


@dataclass(eq=False)
class ReplayedState:
    """What the events of a chain say of the rows of a package.

    `computed`: how many revisions each computing made, by its number. `hashes`: of the events, that of none
    first. `line_revision_ids`: of heights of line scans, by measurement and revision.
    """

    measurements: MeasurementEvents
    survey_id: int
    replay: Replay = field(default_factory=lambda: Replay(_WITHIN))
    drift: DriftEvents = field(default_factory=DriftEvents)
    lots: LotEvents = field(default_factory=LotEvents)
    computed: Counter[int] = field(default_factory=Counter)
    line_revision_ids: dict[tuple[int, int], int] = field(default_factory=dict)
    hashes: list[str] = field(default_factory=lambda: [GENESIS])
    moment: str | None = None

    @property
    def count(self) -> int:
        """Of the events."""
        return len(self.hashes) - 1

    @property
    def survey(self) -> Mapping[str, Any]:
        """What is said of the survey itself."""
        return self.replay.row("survey", self.survey_id)

    def is_gone(self, vehicle_id: int) -> bool:
        """Whether a vehicle was deleted in the end; its measurements are then in no table."""
        return self.replay.is_gone("vehicle", vehicle_id)

    def pose_in_force(self, recording_id: int) -> int | None:
        """The road pose of a recording; None where it has none or was deleted."""
        told = self.replay.of("recording").get(recording_id, {"deleted": True})
        return None if told["deleted"] else told.get("pose_id")


def walk(files: Files, seal: Seal, headers: Mapping[str, Collection[str]]) -> ReplayedState:
    """Check every link of audit.csv and gather what its events say. Raises Damaged.

    What came into the chain while the package was made, no table tells of. headers: the columns that the
    package has, by the table's key.
    """
    state = ReplayedState(MeasurementEvents(REPEATS, headers), seal.survey_id)
    for event in chain(files):
        state.hashes.append(event["hash"])
        first = state.count == 1
        if event["survey_id"] != str(seal.survey_id) or (first and not _begins(event, seal)):
            raise Damaged("export-event-of-other", number=state.count)
        if state.count > seal.as_of or event["entity"] == ENTITY:
            continue
        state.moment = stamp(event["at"])
        after = json.loads(event["after"] or "{}")
        if event["entity"] in ("measurement", "line_height"):
            count_revisions(state.computed, after.get("row", after))
        if "scan_vehicle_id" in after:
            entity, number, after = height_or_verdict(
                event["entity"], int(event["entity_id"]), after, state.line_revision_ids
            )
            state.replay.add({**event, "entity": entity, "entity_id": str(number)}, after)
        elif after:
            _gather(state, event, after)
    return state


def _begins(event: Event, seal: Seal) -> bool:
    """A chain begins with the event that made the survey."""
    made = event["entity"], event["action"], event["entity_id"]
    return made == ("survey", "create", str(seal.survey_id))


def _gather(state: ReplayedState, event: Event, after: dict[str, Any]) -> None:
    """What one event says, also of other rows: a pose comes into force, photographs are put in order."""
    entity, number = event["entity"], int(event["entity_id"] or 0)
    if entity == "measurement":
        state.measurements.add(number, {**after, "by": event["actor_id"]})
        return
    if entity in ("lot", "lot_decision"):
        state.lots.add(entity, number, event, after)
        return
    if entity == "photograph" and event["action"] == "order":
        for position, one in enumerate(after["order"], start=1):
            state.replay.row(entity, int(one))["position"] = position
        return
    if entity == "recording" and state.drift.add(number, after):
        return
    if event["entity_id"]:
        state.replay.add(event, after)
    if entity == "standards":
        state.replay.row("survey", state.survey_id)["standards"] = after["standards"]
    elif entity == "calibration" and after.get("current"):
        state.replay.row("camera", int(after["camera_id"]))["current_calibration_id"] = number
    elif entity == "pose" and after["attached"]:
        state.replay.row("recording", int(after["recording_id"]))["pose_id"] = number
