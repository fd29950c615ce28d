"""Holding the line-scan tables of an export against the audit chain: motions, boundaries, facts, verdicts."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.chain import chain
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import AnyTable, cell_text
from sightline.scans.csv import LINE_SCANS, SCAN_MEASUREMENTS, SCAN_REVIEWS, SCAN_VEHICLES
from sightline.scans.heights.csv import LINE_HEIGHT_REVIEWS, LINE_HEIGHTS, LINE_POSES
from sightline.scans.heights.verify import check_line_heights

_ENTITIES: dict[str, AnyTable] = {
    "scan": LINE_SCANS,
    "scan_vehicle": SCAN_VEHICLES,
    "scan_measurement": SCAN_MEASUREMENTS,
    "scan_review": SCAN_REVIEWS,
    "line_pose": LINE_POSES,
    "line_height": LINE_HEIGHTS,
    "line_height_review": LINE_HEIGHT_REVIEWS,
}
# Verdicts, and how the row that is judged calls what they say.
_REVIEWS = ("scan_review", "line_height_review")
_SAID = {"verdict": "verdict", "review_reason": "reason", "reviewer_id": "reviewer_id", "reviewed_at": "at"}
# What an event says in other words than the table.
_OTHER_WORDS = ("notes", "created_at")


def check_scans(files: Files, events_of_scans: int) -> int:
    """Every row is what its events say, none is missing and none too many; how many were held against them.

    The current revision of a vehicle is its newest. Raises Damaged.
    """
    if not events_of_scans and not any(_rows(files, table) for table in _ENTITIES.values()):
        return 0
    told = _told(files)
    gone = _gone(told)
    rows = {entity: _rows(files, table) for entity, table in _ENTITIES.items()}
    for entity, table in _ENTITIES.items():
        expected = {number for number in told[entity] if number not in gone[entity]}
        if set(rows[entity]) != expected:
            odd = min(set(rows[entity]) ^ expected)
            raise Damaged("scans-row-without-audit-event-missing", path=table.path, odd=odd)
        for number, row in rows[entity].items():
            _same(table, row, told[entity][number])
    _current(rows["scan_vehicle"], rows["scan_measurement"])
    _verdicts(SCAN_MEASUREMENTS, rows["scan_measurement"], "measurement_id", rows["scan_review"])
    _verdicts(LINE_HEIGHTS, rows["line_height"], "height_id", rows["line_height_review"])
    check_line_heights(files, told["line_pose"])
    return sum(len(found) for found in rows.values())


def _told(files: Files) -> dict[str, dict[int, dict[str, Any]]]:
    told: dict[str, dict[int, dict[str, Any]]] = {entity: {} for entity in _ENTITIES}
    for event in chain(files):
        if event["entity"] in told and event["after"]:
            known = told[event["entity"]].setdefault(int(event["entity_id"]), {"deleted": False})
            known.update(json.loads(event["after"]))
            if event["entity"] in _REVIEWS:
                known["reviewer_id"] = event["actor_id"]
    return told


def _gone(told: Mapping[str, Mapping[int, Mapping[str, Any]]]) -> dict[str, set[int]]:
    """What is in no table since its recording or its vehicle was deleted."""
    scans = {number for number, one in told["scan"].items() if one["deleted"]}
    vehicles = {
        number
        for number, one in told["scan_vehicle"].items()
        if one["deleted"] or one.get("scan_id") in scans
    }
    measurements = {
        number for number, one in told["scan_measurement"].items() if one["vehicle_id"] in vehicles
    }
    reviews = {number for number, one in told["scan_review"].items() if one["vehicle_id"] in vehicles}
    return {
        "scan": scans,
        "scan_vehicle": vehicles,
        "scan_measurement": measurements,
        "scan_review": reviews,
        "line_pose": {number for number, one in told["line_pose"].items() if one["scan_id"] in scans},
        **{
            entity: {number for number, one in told[entity].items() if one["vehicle_id"] in vehicles}
            for entity in ("line_height", "line_height_review")
        },
    }


def _rows(files: Files, table: AnyTable) -> dict[int, dict[str, str]]:
    return {int(row["id"]): dict(row) for row in read_rows(files, table.path)}


def _same(table: AnyTable, row: Mapping[str, str], told: Mapping[str, Any]) -> None:
    """Raises Damaged where a cell is not what the events say."""
    for column in table.columns:
        name = column.name
        if name not in told or name in _OTHER_WORDS:
            continue
        value = told[name]
        if column.type == "number" and isinstance(value, int):
            value = float(value)
        if row[name] != cell_text(column, value):
            raise Damaged("scans-row-not-what-audit-event-says", path=table.path, name=name, id=row["id"])


def _current(vehicles: Mapping[int, Mapping[str, str]], revisions: Mapping[int, Mapping[str, str]]) -> None:
    """A vehicle's motion is that of its newest revision, cell by cell."""
    newest: dict[str, Mapping[str, str]] = {}
    for row in revisions.values():
        before = newest.get(row["vehicle_id"])
        if before is None or int(before["revision"]) < int(row["revision"]):
            newest[row["vehicle_id"]] = row
    skipped = {"id", "vehicle_id", "measurement_id"}
    shared = [
        name for name in SCAN_MEASUREMENTS.header if name in SCAN_VEHICLES.header and name not in skipped
    ]
    for number, vehicle in vehicles.items():
        measured = newest.get(str(number))
        if measured is None:
            continue
        if vehicle["measurement_id"] != measured["id"] or any(
            vehicle[name] != measured[name] for name in shared
        ):
            raise Damaged("scans-vehicle-not-newest-revision-changed", path=SCAN_VEHICLES.path, number=number)


def _verdicts(
    judged: AnyTable,
    revisions: Mapping[int, Mapping[str, str]],
    of: str,
    reviews: Mapping[int, Mapping[str, str]],
) -> None:
    """A revision's verdict, with its reason, reviewer and time, is the newest that was given on it."""
    newest = {int(one[of]): one for _, one in sorted(reviews.items())}
    for number, row in revisions.items():
        given = newest.get(number, {"verdict": "to_review"})
        if any(row[name] != given.get(said, "") for name, said in _SAID.items()):
            raise Damaged("scans-verdict-row-not-one-given", path=judged.path, number=number)
