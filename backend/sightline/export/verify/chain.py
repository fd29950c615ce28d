"""Checking the audit chain of an export, and what its events say of every row."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sightline.infra.csv_package.chain import Event, chain, stamp
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.schema import metres_text, safe_text

_MAKES = ("create", "update", "ingest")


@dataclass(eq=False)
class ReplayedState:
    """What the events of a chain say of the rows of a package, by number.

    `revisions`: (measurement, revision) to a digest of what was told of it; `repeats` likewise, by repeat, of
    its newest revision. `drift`: by recording and pose. `contents`: hashes of rows that are written once, by
    (kind, number).
    """

    count: int = 0
    head: str = ""
    moment: str | None = None
    survey: dict[str, Any] = field(default_factory=dict)
    standards: list[dict[str, Any]] | None = None
    vehicles: dict[int, dict[str, Any]] = field(default_factory=dict)
    recordings: dict[int, dict[str, Any]] = field(default_factory=dict)
    reviews: dict[int, dict[str, Any]] = field(default_factory=dict)
    contents: dict[tuple[str, int], str] = field(default_factory=dict)
    drift: dict[int, dict[int, dict[str, Any]]] = field(default_factory=dict)
    decisions: dict[int, dict[str, Any] | None] = field(default_factory=dict)
    pairs: dict[int, dict[str, Any]] = field(default_factory=dict)
    revisions: dict[tuple[int, int], bytes] = field(default_factory=dict)
    of_vehicle: dict[int, int] = field(default_factory=dict)
    repeats: dict[int, bytes] = field(default_factory=dict)
    photographs: dict[int, dict[str, Any]] = field(default_factory=dict)
    scans: int = 0

    def is_gone(self, vehicle_id: int) -> bool:
        """Whether a vehicle was deleted in the end; its measurements are then in no table."""
        return bool(self.vehicles.get(vehicle_id, {}).get("deleted", False))


def walk(files: Files) -> ReplayedState:
    """Check every link of audit.csv and gather what its events say. Raises Damaged."""
    told = ReplayedState()
    for event in chain(files):
        told.count, told.head = int(event["id"]), event["hash"]
        if event["withheld"] == "true":
            continue
        told.moment = stamp(event["at"])
        if event["after"]:
            _gather(told, event, json.loads(event["after"]))
    return told


def _gather(told: ReplayedState, event: Event, after: dict[str, Any]) -> None:
    entity, action, number = event["entity"], event["action"], int(event["entity_id"] or 0)
    if entity == "measurement":
        _measured(told, number, {**after, "by": event["actor_id"]})
    elif entity == "survey":
        told.survey |= after
    elif entity == "vehicle":
        told.vehicles.setdefault(number, {}).update(after)
    elif entity == "recording":
        _recorded(told, action, number, after)
    elif entity == "review":
        told.reviews[number] = {**after, "at": event["at"], "actor_id": event["actor_id"]}
    elif entity == "wheel_pair":
        told.pairs[number] = {**after, "created_by_id": _number(event["actor_id"])}
    elif entity == "photograph":
        _photographed(told, event, after)
    elif entity == "scan":
        told.scans += 1
    elif entity == "standards":
        told.standards = after["standards"]
    if entity == "pose" and after.get("attached"):
        told.recordings.setdefault(int(after["recording_id"]), {})["pose_id"] = number
    if entity in ("pose", "calibration") and "content_sha256" in after:
        told.contents[entity, number] = after["content_sha256"]


def _recorded(told: ReplayedState, action: str, number: int, after: dict[str, Any]) -> None:
    """A recording's facts; what was found of its camera against each pose; the decision about that."""
    if action in _MAKES:
        told.recordings.setdefault(number, {"pose_id": None}).update(after)
    elif action == "check_drift":
        told.drift.setdefault(number, {})[int(after["pose_id"])] = after["found"]
    elif "drift_decision" in after:
        told.decisions[number] = after["drift_decision"]


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


def _measured(told: ReplayedState, number: int, after: Mapping[str, Any]) -> None:
    told.of_vehicle[number] = int(after["vehicle_id"])
    if after.get("repeat_of") is not None:
        told.repeats[number] = _digest([*_short_of_event(after), stamp(after["created_at"])])
    else:
        stamps = [stamp(after["created_at"]), safe_text(after["code_version"])]
        told.revisions[number, int(after["revision"])] = _digest([*_words_of_event(after), *stamps])


def _short_of_event(after: Mapping[str, Any]) -> list[Any]:
    plain = [after[name] for name in ("vehicle_id", "target", "frame", "pose_id", "status", "withdrawn")]
    points = [*after["contact"], *after["target_point"]]
    return [*plain, safe_text(after["reason"] or ""), _length(after["height_m"]), after["by"], points]


def _words_of_event(after: Mapping[str, Any]) -> list[Any]:
    more = [[n, *contact, *point] for n, contact, point in after.get("more_frames", [])]
    return [*_short_of_event(after), _length(after["U95_height_m"]), more]


def _length(value_m: float | None) -> str:
    return "" if value_m is None else metres_text(value_m)


def _short_of_row(row: Mapping[str, str]) -> list[Any]:
    plain = [int(row["vehicle_id"]), row["target"], int(row["frame"]), int(row["pose_id"])]
    said = [row["status"], row["withdrawn"] == "true", row["reason"], row["height_m"]]
    return [*plain, *said, row["created_by_id"], _points(row, "")]


def _words_of_row(row: Mapping[str, str], further: list[int]) -> list[Any]:
    """What a row says, in the form in which its event says it."""
    more = [[int(row[f"frame{k}"]), *_points(row, str(k))] for k in further]
    return [*_short_of_row(row), row["U95_height_m"], more]


def _points(row: Mapping[str, str], k: str) -> list[float]:
    return [float(row[f"{word}{k}_{axis}_px"]) for word in ("contact", "target") for axis in "xy"]


def same_words(told: bytes, row: Mapping[str, str], further: list[int]) -> bool:
    """Whether a row says what its event said."""
    return told == _digest([*_words_of_row(row, further), row["created_at"], row["code_version"]])


def same_repeat(told: bytes, row: Mapping[str, str]) -> bool:
    """The same for a row of repeats.csv."""
    return told == _digest([*_short_of_row(row), row["created_at"]])


def _digest(words: list[Any]) -> bytes:
    return hashlib.blake2b(_text(words).encode(), digest_size=12).digest()


def _text(words: Any) -> str:
    """One text for numbers that are equal, whether they came as 3 or as 3.0, as 0 or as -0.0."""
    if isinstance(words, list):
        return "[" + ",".join(_text(one) for one in words) + "]"
    return repr(float(words) + 0.0) if isinstance(words, float | int) else repr(words)
