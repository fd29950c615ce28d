"""Line-scan tables of an export against the audit chain: motions, boundaries, facts, references, verdicts."""

from collections import defaultdict
from collections.abc import Callable, Mapping
from typing import Any

from sightline.coverage import expanded
from sightline.errors import Damaged
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.csv_package.columns import join_sentences
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.replay import Cells, Replay, Replayed, Told
from sightline.infra.csv_package.schema import AnyTable, cell_text
from sightline.linescan.parts import Crossings
from sightline.measurements.again.verify import verdict_gone_over
from sightline.scans.clock import Passing, clock_of, passing_of
from sightline.scans.csv import (
    LINE_SCANS,
    SCAN_MEASUREMENTS,
    SCAN_REVIEWS,
    SCAN_VEHICLES,
    axle_words,
    lanes_text,
)
from sightline.scans.heights.csv import LINE_HEIGHT_REVIEWS, LINE_HEIGHTS, LINE_POSES
from sightline.scans.heights.verify import check_line_heights, line_height_put_back
from sightline.scans.references.csv import SCAN_REFERENCES
from sightline.scans.references.verify import check_references
from sightline.scans.rig.csv import RIG_CALIBRATIONS
from sightline.scans.rig.verify import check_rig_calibrations
from sightline.scans.vehicles.verify import check_gaps


def _scan_cells(scan: Told) -> Cells:
    """A start is told in UTC and written by the clocks of its zone; lanes are one cell, notes another."""
    clock = clock_of(scan)
    start = {} if clock is None else {"started_at": clock.filming.at()}
    notes = scan.get("notes", ())  # none yet where it was not read
    cells = {**_UNTOLD, **scan, "lanes": lanes_text(scan.get("lanes")), **start}
    if any(isinstance(one, str) for one in notes):  # an event of an earlier program has words
        return {**cells, "notes": join_sentences(notes)}
    return {**cells, "notes_code": canonical_json(notes) if notes else None}


#: What the events of strips, or of a recording that was not read, do not tell: there is none.
_UNTOLD = dict.fromkeys(("recording_id", "rows_px", "lines", "bits", "first_sha256", "second_sha256"))
_WITH_U = ("speed_mps", "acceleration_mps2", "length_m", "wheelbase_m")


def _motion_cells(told: Told) -> Cells:
    lines, reason, warnings = told["axle_lines"], told["reason"], told.get("warnings")
    wide = {f"U95_{name}": expanded(told.get(f"u_{name}")) for name in _WITH_U}
    cells = {**told, **told.get("rig", {}), **wide}
    cells |= {"axle_lines": axle_words(lines), "axles": len(lines or ()) or None}
    if warnings is not None:
        cells["warnings_code"] = canonical_json(warnings) if warnings else None
    if not isinstance(reason, str):  # an event of an earlier program has words
        del cells["reason"]
        cells["reason_code"] = reason and canonical_json(reason)
    return cells


def _vehicle_cells(told: Told) -> Cells:
    """Who made the row and when is told of its motion, whose own row is held to its event."""
    return {name: one for name, one in told.items() if name not in ("created_by_id", "created_at")}


def _verdict_cells(told: Told) -> Cells:
    at = {"at": told["created_at"]} if "created_at" in told else {}
    return {**told, "reviewer_id": told["actor_id"], **at}


_SCAN, _VEHICLE = ("scan_id", "scan"), ("vehicle_id", "scan_vehicle")
_REPLAYED = (
    Replayed(LINE_SCANS, "scan", cells=_scan_cells),
    Replayed(SCAN_VEHICLES, "scan_vehicle", _SCAN, _vehicle_cells),
    Replayed(SCAN_MEASUREMENTS, "scan_measurement", _VEHICLE, _motion_cells),
    Replayed(SCAN_REVIEWS, "scan_review", _VEHICLE, _verdict_cells),
    Replayed(SCAN_REFERENCES, "scan_reference", _VEHICLE),
    Replayed(LINE_POSES, "line_pose", _SCAN),
    Replayed(LINE_HEIGHTS, "line_height", _VEHICLE),
    Replayed(LINE_HEIGHT_REVIEWS, "line_height_review", _VEHICLE, _verdict_cells),
    Replayed(RIG_CALIBRATIONS, "rig_calibration", _SCAN),
)
#: What is deleted with what it is part of, as `infra.csv_package.replay` asks.
WITHIN = {one.entity: one.within for one in _REPLAYED if one.within is not None}
# How the row that is judged calls what a verdict says.
_SAID = {"verdict": "verdict", "review_reason": "reason", "reviewer_id": "reviewer_id", "reviewed_at": "at"}
_LINES = ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
_RATES = ("line_rate_hz", "u_line_rate_ratio")
# Of a motion's revision, what may be another where it was put back: by whom, why, when, and its verdict.
_OF_PUTTING_BACK = (
    *("id", "revision", "cause", "code_version", "created_by_id", "created_at", "verdict_of_id"),
    *_SAID,
)


def check_scans(
    files: Files, replay: Replay, computings: Mapping[str, str], recomputing: Recomputing, program: str
) -> int:
    """Every row is what its events say, none is missing and none too many; how many were held against them.

    The current revision of a vehicle is its newest. `computings`: the kind of each, by its number; `program`:
    the version that made the package. Raises Damaged.
    """
    rows = {one.entity: {int(row["id"]): row for row in replay.hold(files, one)} for one in _REPLAYED}
    events = {one.entity: replay.of(one.entity) for one in _REPLAYED}
    _directions(rows["scan_measurement"])
    _current(rows["scan_vehicle"], rows["scan_measurement"])
    _passings(rows["scan_vehicle"], rows["scan_measurement"], events)
    check_gaps(rows["scan_vehicle"], events["scan"], events["scan_measurement"], recomputing, program)
    motions = SCAN_MEASUREMENTS, rows["scan_measurement"], "measurement_id", rows["scan_review"]
    heights = LINE_HEIGHTS, rows["line_height"], "height_id", rows["line_height_review"]
    _verdicts(*motions)
    _verdicts(*heights)
    check_references(rows["scan_reference"], rows["scan_vehicle"], events)
    check_verdicts_gone_over(*motions, {}, _motion_put_back)
    check_verdicts_gone_over(*heights, computings, line_height_put_back)
    check_line_heights(files, events["line_pose"], recomputing)
    check_rig_calibrations(files, events["rig_calibration"], recomputing)
    return sum(len(found) for found in rows.values())


def _directions(revisions: Mapping[int, Mapping[str, str]]) -> None:
    """Which camera a vehicle reached first follows from its lines."""
    for number, row in revisions.items():
        if row["direction"] != Crossings(*(float(row[name]) for name in _LINES)).direction:
            raise Damaged("scans-direction-differs", path=SCAN_MEASUREMENTS.key, number=number)


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
        measured = newest.get(str(number), {})
        if vehicle["measurement_id"] != measured.get("id", "") or any(
            vehicle[name] != measured.get(name, "") for name in shared
        ):
            raise Damaged("scans-vehicle-not-newest", path=SCAN_VEHICLES.key, number=number)


def _passings(
    vehicles: Mapping[int, Mapping[str, str]],
    revisions: Mapping[int, Mapping[str, str]],
    events: Mapping[str, Mapping[int, Mapping[str, Any]]],
) -> None:
    """When a vehicle passed follows from its recording's start, its front and the rig; each held before."""
    clocks = {number: clock_of(one) for number, one in events["scan"].items()}
    written = {column.name: column for column in SCAN_VEHICLES.columns}
    for number, row in vehicles.items():
        clock, passed = clocks[int(row["scan_id"])], None
        if clock is not None and row["measurement_id"]:
            motion = events["scan_measurement"][int(row["measurement_id"])]
            rig = {name: float(revisions[int(row["measurement_id"])][name]) for name in _RATES}
            speed, u_length = motion["speed_mps"], motion["u_length_m"]
            passed = passing_of(clock, motion["front_line_1"], speed, u_length, rig)
        for name in Passing.__slots__:
            if row[name] != cell_text(written[name], None if passed is None else getattr(passed, name)):
                raise Damaged("scans-vehicle-time-differs", path=SCAN_VEHICLES.key, number=number)


def _verdicts(
    judged: AnyTable,
    revisions: Mapping[int, Mapping[str, str]],
    of: str,
    reviews: Mapping[int, Mapping[str, str]],
) -> None:
    """A revision's verdict is the newest given on it, or on the one whose verdict holds for it too."""
    newest = {int(one[of]): (at, one) for at, one in sorted(reviews.items())}
    for number, row in revisions.items():
        known = [newest[one] for one in (number, int(row.get("verdict_of_id") or 0)) if one in newest]
        _, given = max(known, default=(0, {"verdict": "to_review"}))
        if any(row[name] != given.get(said, "") for name, said in _SAID.items()):
            raise Damaged("scans-verdict-differs", path=judged.path, number=number)


def check_verdicts_gone_over(
    judged: AnyTable,
    rows: Mapping[int, Mapping[str, str]],
    of: str,
    reviews: Mapping[int, Mapping[str, str]],
    computings: Mapping[str, str],
    put_back: Callable[[Mapping[str, str], Mapping[str, str]], bool],
) -> None:
    """A verdict went over only to a revision of the same thing that hardly moved, to one put back, or was a
    rejection. Raises Damaged.

    `computings`: the kind of each, by its number.
    """
    newest = {one[of]: one["verdict"] for _, one in sorted(reviews.items())}
    of_one: dict[tuple[str, str], list[Mapping[str, str]]] = defaultdict(list)
    for row in rows.values():
        of_one[row["vehicle_id"], row.get("target", "")].append(row)
    for revisions in of_one.values():
        revisions.sort(key=lambda row: int(row["revision"]))
        number = {row["id"]: int(row["revision"]) for row in revisions}
        # what no revision of it is comes after all of them, where no verdict can come from
        later = len(revisions) + 1
        told = [row.get("verdict_of_id") for row in revisions]
        from_revision = [number.get(one, later) if one else 0 for one in told]
        rejected = {number[row["id"]] for row in revisions if newest.get(row["id"]) == "rejected"}
        bad = verdict_gone_over(revisions, from_revision, computings, rejected, put_back)
        if bad is not None:
            raise Damaged("scans-verdict-went-over", path=judged.path, id=bad["id"])


def _motion_put_back(then: Mapping[str, str], row: Mapping[str, str]) -> bool:
    """Whether a motion has the very boundaries, wheels, rig and numbers of an earlier revision."""
    return all(then[name] == row[name] for name in row if name not in _OF_PUTTING_BACK)
