"""Checking the audit chain of an export, and what its events say of every row."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

from sightline.cameras.calibrations.verify import CalibrationEvents
from sightline.errors import Damaged
from sightline.export.seal import ENTITY, Seal
from sightline.infra.csv_package.chain import Event, chain, stamp
from sightline.infra.csv_package.files import Files
from sightline.measurements.again.verify import count_revisions
from sightline.measurements.verify import MeasurementEvents
from sightline.quality.repeats.csv import REPEATS
from sightline.recordings.verify import RecordingEvents
from sightline.reviews.lots.verify import LotEvents


@dataclass(eq=False)
class ReplayedState:
    """What the events of a chain say of the rows of a package, by number.

    `poses`: the hash of each one's content.
    """

    measurements: MeasurementEvents
    count: int = 0
    head: str = ""
    moment: str | None = None
    survey_head: str = ""
    survey: dict[str, Any] = field(default_factory=dict)
    standards: list[dict[str, Any]] | None = None
    vehicles: dict[int, dict[str, Any]] = field(default_factory=dict)
    recordings: RecordingEvents = field(default_factory=RecordingEvents)
    reviews: dict[int, dict[str, Any]] = field(default_factory=dict)
    lots: LotEvents = field(default_factory=LotEvents)
    poses: dict[int, str] = field(default_factory=dict)
    calibrations: CalibrationEvents = field(default_factory=CalibrationEvents)
    computings: dict[int, dict[str, Any]] = field(default_factory=dict)
    revisions_of_computings: Counter[int] = field(default_factory=Counter)
    pairs: dict[int, dict[str, Any]] = field(default_factory=dict)
    photographs: dict[int, dict[str, Any]] = field(default_factory=dict)
    cameras: dict[int, dict[str, Any]] = field(default_factory=dict)
    scans: int = 0

    def is_gone(self, vehicle_id: int) -> bool:
        """Whether a vehicle was deleted in the end; its measurements are then in no table."""
        return bool(self.vehicles.get(vehicle_id, {}).get("deleted", False))


def walk(files: Files, seal: Seal, headers: Mapping[str, Collection[str]]) -> ReplayedState:
    """Check every link of audit.csv and gather what its events say. Raises Damaged.

    What came into the chain while the package was made, no table tells of. headers: the columns that the
    package has, by table.
    """
    told = ReplayedState(MeasurementEvents(REPEATS, headers))
    for event in chain(files):
        told.count, told.head = int(event["number"]), event["hash"]
        first = told.count == 1
        if event["survey_id"] != str(seal.survey_id) or (first and not _begins(event, seal)):
            raise Damaged("export-event-of-another-survey-or-time", number=told.count)
        if told.count > seal.as_of or event["entity"] == ENTITY:
            continue
        told.moment, told.survey_head = stamp(event["at"]), event["hash"]
        after = json.loads(event["after"] or "{}")
        if event["entity"] in ("measurement", "line_height"):
            count_revisions(told.revisions_of_computings, after.get("row", after))
        if after and "scan_vehicle_id" not in after:  # heights of line scans are held with their tables
            _gather(told, event, after)
    return told


def _begins(event: Event, seal: Seal) -> bool:
    """A chain begins with the event that made the survey."""
    made = event["entity"], event["action"], event["entity_id"]
    return made == ("survey", "create", str(seal.survey_id))


def _gather(told: ReplayedState, event: Event, after: dict[str, Any]) -> None:
    entity, action, number = event["entity"], event["action"], int(event["entity_id"] or 0)
    if entity == "measurement":
        told.measurements.add(number, {**after, "by": event["actor_id"]})
    elif entity == "survey":
        told.survey |= after
    elif entity == "vehicle":
        told.vehicles.setdefault(number, {}).update(after)
    elif entity == "recording":
        told.recordings.add(action, number, after)
    elif entity in ("review", "computing"):
        rows = told.reviews if entity == "review" else told.computings
        rows[number] = {**after, "at": event["at"], "actor_id": event["actor_id"], "event": told.count}
    elif entity in ("lot", "lot_decision"):
        told.lots.add(entity, number, event, after)
    elif entity == "wheel_pair":
        told.pairs[number] = {**after, "created_by_id": _number(event["actor_id"])}
    elif entity == "photograph":
        _photographed(told, event, after)
    elif entity == "scan":
        told.scans += 1
    elif entity == "standards":
        told.standards = after["standards"]
    else:
        _gather_set_up(told, entity, number, after)


def _gather_set_up(told: ReplayedState, entity: str, number: int, after: dict[str, Any]) -> None:
    if entity == "calibration":
        told.calibrations.add(number, after)
        if after.get("current"):
            told.cameras[after["camera_id"]]["current_calibration_id"] = number
    elif entity == "calibration_image":
        told.calibrations.add_image(number, after)
    elif entity == "camera":
        told.cameras.setdefault(number, {}).update(after)
    elif entity == "pose":
        told.poses[number] = after["content_sha256"]
        if after["attached"]:
            told.recordings.attach(int(after["recording_id"]), number)


def _number(text: str) -> int | None:
    return int(text) if text else None


def _photographed(told: ReplayedState, event: Event, after: dict[str, Any]) -> None:
    if event["action"] == "order":
        for position, one in enumerate(after["order"], start=1):
            told.photographs[int(one)]["position"] = position
        return
    known = told.photographs.setdefault(int(event["entity_id"]), {})
    if event["action"] == "create":
        known["created_by_id"] = _number(event["actor_id"])
    known.update(after)
