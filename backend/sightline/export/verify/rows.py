"""Holding the tables of an export against the audit chain and against each other."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS, calibration_path
from sightline.errors import Damaged
from sightline.export.verify.chain import ReplayedState
from sightline.infra.audit.hashing import content_hash
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, number, read_columns, read_rows, read_whole
from sightline.infra.csv_package.schema import AnyTable, Cells, cell_text, record_path
from sightline.measurements.sheets.csv import VEHICLES
from sightline.poses.csv import POSES, pose_path
from sightline.quality.checks.csv import WHEEL_PAIRS
from sightline.recordings.csv import RECORDINGS, drift_cells, drift_of
from sightline.results.csv import standards_in
from sightline.reviews.csv import REVIEWS
from sightline.statistics.standards import STANDARDS, Standard
from sightline.surveys.csv import INSETS

_DEFAULT_VERDICT = "to_review"


def check_keys(files: Files, described: Sequence[AnyTable]) -> int:
    """Every key is there once and every foreign key leads somewhere; how many were followed."""
    wanted = {(table, columns) for one in described for _, table, columns in one.foreign}
    known = {key: _keys(files, _named(described, key[0]).path, key[1]) for key in wanted}
    followed = 0
    for one in described:
        if one.primary:
            _keys(files, one.path, one.primary)
        for mine, table, theirs in one.foreign:
            for values in read_columns(files, one.path, mine):
                if all(values) and tuple(values) not in known[table, theirs]:
                    raise Damaged(
                        f"{one.path}: {' '.join(mine)} {' '.join(values)} is not in {table}.csv; "
                        "a row was taken out or changed."
                    )
                followed += 1
    return followed


def _named(described: Sequence[AnyTable], name: str) -> AnyTable:
    return next(one for one in described if one.name == name)


def _keys(files: Files, path: str, columns: tuple[str, ...]) -> set[tuple[str, ...]]:
    found: set[tuple[str, ...]] = set()
    for values in read_columns(files, path, columns):
        key = tuple(values)
        if key in found:
            raise Damaged(f"{path}: {' '.join(columns)} {' '.join(values)} is there twice; one was put in.")
        found.add(key)
    return found


def check_set_up(files: Files, told: ReplayedState) -> None:
    """Poses, calibrations, insets and standards are the chain's; a pose's camera is its calibration's."""
    for kind, table, path_of in (
        ("pose", POSES, pose_path),
        ("calibration", CALIBRATIONS, calibration_path),
    ):
        expected = {id_: sum_ for (entity, id_), sum_ in told.contents.items() if entity == kind}
        _check_records(files, kind, table, path_of, expected)
    insets = told.survey.get("insets", {})
    rows = {row["target"]: row for row in read_rows(files, "insets.csv")}
    if set(rows) != set(insets) or any(not _says(INSETS, rows[one], insets[one]) for one in rows):
        raise Damaged("insets.csv is not what the survey's audit events say; it was changed.")
    chosen = STANDARDS if told.standards is None else [Standard(**one) for one in told.standards]
    if standards_in(files) != tuple(chosen):
        raise Damaged("standards.csv is not what the survey's audit events say; it was changed.")


def _check_records(
    files: Files, kind: str, table: AnyTable, path_of: Callable[[int], str], expected: Mapping[int, str]
) -> None:
    rows = {int(row["id"]): row for row in read_rows(files, table.path)}
    if set(rows) != set(expected):
        odd = min(set(rows) ^ set(expected))
        raise Damaged(f"{table.path}: {kind} {odd} is there without its audit event, or is missing.")
    for id_, row in rows.items():
        path = record_path(kind, id_)
        record = json.loads(read_whole(files, path))
        if content_hash(record) != expected[id_]:
            raise Damaged(f"{path} is not what its audit event says; it was changed.")
        if json.loads(read_whole(files, path_of(id_))) != record["document"]:
            raise Damaged(f"{path_of(id_)} is not the one that the audit chain vouches for; it was changed.")
        document = record["document"]
        told = {**document, **(document.get("board") or {}), **record}
        told["distortion"] = " ".join(repr(float(one)) for one in document.get("distortion", ()))
        told["board_distance_m"] = told.get("distance_m") if kind == "pose" else None
        names = [name for name in table.header if name in told and name not in _ELSEWHERE]
        stamped = [row["created_at"], row["created_by_id"]]
        if stamped != [stamp(record["created_at"]), str(record["created_by"] or "")]:
            raise Damaged(
                f"{table.path}: {kind} {id_} was made by others or at another time than {path} says."
            )
        if not _says(table, row, {name: told[name] for name in names if row[name]}):
            raise Damaged(f"{table.path}: {kind} {id_} differs from {path}; one was changed.")


_ELSEWHERE = ("id", "created_at", "document", "columns", "rows")


def _says(table: AnyTable, row: Mapping[str, str], values: Mapping[str, Any]) -> bool:
    """Whether a row's cells hold these values, as they would be written."""
    columns = {column.name: column for column in table.columns}
    for name, value in values.items():
        if name in columns and isinstance(value, str | int | float | bool | None):
            expected = cell_text(columns[name], value)
            if row[name] != expected and not _equal(row[name], expected):
                return False
    return True


def _equal(told: str, expected: str) -> bool:
    """3 and 3.0 are one number: JSON does not tell them apart, CSV does."""
    try:
        return float(told) == float(expected)
    except ValueError:
        return False


def check_people_s_work(files: Files, told: ReplayedState) -> None:
    """Vehicles, recordings, reviews and tyre contacts are what their events made of them."""
    _check_vehicles(files, told)
    for row in read_rows(files, "recordings.csv"):
        made = told.recordings.pop(int(row["id"]), None)
        if made is None or not _says(RECORDINGS, row, {**made, **_drift(told, row)}):
            raise Damaged(f"recordings.csv: {row['id']} is not what its audit events say; it was changed.")
    for row in read_rows(files, "wheel_pairs.csv"):
        pair = told.pairs.get(int(row["id"]))
        if pair is None or not _says(WHEEL_PAIRS, row, _of_pair(pair)):
            raise Damaged(f"wheel_pairs.csv: {row['id']} is not what its audit event says; it was changed.")


def _drift(told: ReplayedState, row: Mapping[str, str]) -> Cells:
    """The columns about a camera that moved, as the events tell them."""
    number, pose_id = int(row["id"]), int(row["pose_id"]) if row["pose_id"] else None
    found = None if pose_id is None else told.drift.get(number, {}).get(pose_id)
    return drift_cells(drift_of(found, told.decisions.get(number), pose_id))


def _of_pair(pair: Mapping[str, Any]) -> dict[str, Any]:
    return {**pair, "created_at": stamp(pair["created_at"]), "frame_crc32": pair["crc32"]}


def _check_vehicles(files: Files, told: ReplayedState) -> None:
    missing = {id_ for id_ in told.vehicles if not told.is_gone(id_)}
    for row in read_rows(files, "vehicles.csv"):
        id_ = int(row["id"])
        made = told.vehicles.get(id_)
        if made is None or told.is_gone(id_) or not _says(VEHICLES, row, made):
            raise Damaged(f"vehicles.csv: {id_} is not what its audit events say; it was changed.")
        missing.discard(id_)
    if missing:
        raise Damaged(f"vehicles.csv: {min(missing)} is missing, though its audit event is there.")


def check_verdicts(files: Files, told: ReplayedState) -> None:
    """Reviews are those of the chain, and each measurement's verdict is its newest review's."""
    newest: dict[tuple[str, str], Mapping[str, str]] = {}
    there: set[int] = set()
    for row in read_rows(files, "reviews.csv"):
        made = told.reviews.get(int(row["id"]))
        if made is None or not _says(REVIEWS, row, _of_review(made)):
            raise Damaged(f"reviews.csv: {row['id']} is not what its audit event says; it was changed.")
        there.add(int(row["id"]))
        newest[row["measurement_id"], row["result_revision"]] = row
    for id_, made in told.reviews.items():
        if id_ not in there and not told.is_gone(int(made["vehicle_id"])):
            raise Damaged(f"reviews.csv: {id_} is missing, though its audit event is there.")
    names = ("id", "revision", "verdict", "review_reason", "reviewer_id", "reviewed_at")
    for one, revision, *said in read_columns(files, "measurements.csv", names):
        review = newest.get((one, revision))
        wanted = [_DEFAULT_VERDICT, "", "", ""]
        if review is not None:
            wanted = [review[name] for name in ("verdict", "reason", "reviewer_id", "at")]
        if said != wanted:
            raise Damaged(
                f"measurements.csv: the verdict on {one} is not that of its newest review; one is wrong."
            )


def _of_review(made: Mapping[str, Any]) -> dict[str, Any]:
    named: dict[str, Any] = {
        "measurement_id": made["series_id"],
        "reviewer_id": int(made["actor_id"]) if made["actor_id"] else None,
        "at": stamp(made["created_at"]),
    }
    return {**made, **named}


def check_frames(files: Files) -> None:
    """What a measurement says of its frame is what frames.csv says of it."""
    names = ("pts", "time_s", "crc32")
    known = {
        (row["recording_id"], row["frame"]): [row[name] for name in names]
        for row in read_rows(files, "frames.csv")
    }
    columns = ("id", "recording_id", "frame", "pts", "time_s", "frame_crc32")
    for path in ("measurements.csv", "repeats.csv"):
        for id_, recording, frame, *said in read_columns(files, path, columns):
            found = known.get((recording, frame))
            if (
                found is None
                or found[0] != said[0]
                or found[2] != said[2]
                or number(found[1]) != number(said[1])
            ):
                raise Damaged(
                    f"{path}: {id_} was clicked on another frame than frames.csv tells; one is wrong."
                )
