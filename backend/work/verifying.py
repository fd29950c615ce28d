"""Checking an export without the database: checksums, the audit chain, and every height computed again."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from backend.errors import BadInput, Damaged
from backend.geometry.documents import pose_from_dict
from backend.geometry.road_pose import RoadPose
from backend.storage.chain import event_hash, link_hash
from backend.storage.records import Target
from backend.work.answering import Answer, Clicks, answer
from backend.work.packaging import CHECKSUMS, sha256_hex

Files = Mapping[str, bytes]
_CHAINED = ("actor_id", "entity_id", "survey_id")
_TOLD = ("at", "action", "entity", "before", "after")
# Half of the last decimal that a CSV carries, and a hair for the rounding of the last binary digit.
_HEIGHT_TOLERANCE_M = 0.51e-6
_FURTHER = re.compile(r"(?:contact|target)(\d+)_[xy]_px")


@dataclass(frozen=True)
class PackageCheck:
    """What was checked; `problem` is one sentence, None when all is well."""

    ok: bool
    files: int
    checked: int
    heights: int
    head_hash: str
    problem: str | None


def read_package(place: Path) -> Files:
    """The files of an exported folder or ZIP by relative path. Raises BadInput for anything else."""
    try:
        if place.is_dir():
            paths = sorted(path for path in place.rglob("*") if path.is_file())
            return {path.relative_to(place).as_posix(): path.read_bytes() for path in paths}
        with zipfile.ZipFile(place) as archive:
            return {name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}
    except (OSError, zipfile.BadZipFile, RuntimeError) as error:
        raise BadInput(f"{place} cannot be read as an export; name its folder or ZIP.") from error


def verify_package(files: Files) -> PackageCheck:
    """Check everything; the first problem found is told."""
    checked = heights = 0
    head = ""
    try:
        checksums(files)
        events = list(chain(files))
        checked, head = len(events), events[-1]["hash"] if events else ""
        heights = recompute(files)
        told_alike(files, events)
    except (Damaged, BadInput) as error:
        return PackageCheck(False, len(files), checked, heights, head, error.message)
    except (KeyError, ValueError) as error:
        # Checksums agree, yet a column is missing or holds what it cannot: another version, or a forger's.
        problem = f"A table lacks or cannot hold {error}; export the survey again with this version."
        return PackageCheck(False, len(files), checked, heights, head, " ".join(problem.split()))
    return PackageCheck(True, len(files), checked, heights, head, None)


def checksums(files: Files) -> None:
    """Every file is there with the bytes it was written with, and no other. Raises Damaged."""
    if CHECKSUMS not in files:
        raise BadInput(f"There is no {CHECKSUMS}, so this is no whole export; export the survey again.")
    listed = {}
    for line in files[CHECKSUMS].decode("utf-8", "replace").splitlines():
        sum_, _, path = line.partition("  ")
        listed[path] = sum_
    for path, sum_ in listed.items():
        if path not in files:
            raise Damaged(f"{path} is missing; take the whole export again.")
        if sha256_hex(files[path]) != sum_:
            raise Damaged(f"{path} was changed after the export; take the whole export again.")
    strange = sorted(set(files) - set(listed) - {CHECKSUMS})
    if strange:
        raise Damaged(f"{strange[0]} does not belong to the export; take it out and check again.")


def table(files: Files, path: str) -> Iterator[dict[str, str]]:
    """The rows of one CSV. Raises Damaged where it is missing or no CSV."""
    if path not in files:
        raise Damaged(f"{path} is missing; take the whole export again.")
    try:
        yield from csv.DictReader(io.StringIO(files[path].decode("utf-8"), newline=""), strict=True)
    except (UnicodeDecodeError, csv.Error) as error:
        raise Damaged(f"{path} cannot be read as CSV; take the whole export again.") from error


def chain(files: Files) -> Iterator[dict[str, str]]:
    """The events of audit.csv, each checked against its hash and the one before. Raises Damaged.

    A withheld event's link is computed again like every other; only its content is taken by its hash.
    """
    before: dict[str, str] | None = None
    for row in table(files, "audit.csv"):
        if before is not None and (
            row["previous_hash"] != before["hash"] or int(row["id"]) != int(before["id"]) + 1
        ):
            raise Damaged(
                f"audit.csv: event {row['id']} does not follow from the one before; it was changed."
            )
        if link_hash(row["previous_hash"], row["content_sha256"]) != row["hash"] or not _content_holds(row):
            raise Damaged(f"audit.csv: event {row['id']} is not the one that was hashed; it was changed.")
        yield row
        before = row


def _content_holds(row: Mapping[str, str]) -> bool:
    """What a row tells is what was hashed; a withheld row tells nothing, for nothing would vouch for it."""
    if row["withheld"] == "true":
        return not any(row[name] for name in (*_TOLD, *_CHAINED))
    return event_hash(_hashed(row)) == row["content_sha256"]


def _hashed(row: Mapping[str, str]) -> dict[str, Any]:
    """The row as it was hashed: numbers as numbers, empty as nothing."""
    values: dict[str, Any] = {"id": int(row["id"]), **{name: row[name] or None for name in _TOLD}}
    values |= {name: int(row[name]) if row[name] else None for name in _CHAINED}
    return values


def recompute(files: Files) -> int:
    """Compute every height again from clicks and pose; how many were computed. Raises Damaged."""
    stored = {f"m{row['id']}": row for row in table(files, "measurements.csv")}
    poses: dict[str, RoadPose] = {}
    count = 0
    for row in table(files, "clicks.csv"):
        path = row["pose_file"]
        if path not in poses:
            poses[path] = _pose(files, path)
        if row["id"] not in stored:
            raise Damaged(f"clicks.csv: {row['id']} is not in measurements.csv; take the whole export again.")
        _same_clicks(row, stored[row["id"]])
        _same(row["id"], stored[row["id"]], answer(poses[path], _clicks(row)))
        count += 1
    return count


def _pose(files: Files, path: str) -> RoadPose:
    try:
        return pose_from_dict(json.loads(files[path]), path)
    except (KeyError, ValueError, BadInput) as error:
        raise Damaged(f"{path} is missing or is no road pose; take the whole export again.") from error


def _clicks(row: Mapping[str, str]) -> Clicks:
    number = {name: float(row[name]) for name in row if name.endswith(("_px", "inset_m")) and row[name]}
    return Clicks(
        target=cast(Target, row["target"]),
        contact=(number["contact_x_px"], number["contact_y_px"]),
        point=(number["target_x_px"], number["target_y_px"]),
        sigma_px=number["sigma_px"],
        inset_m=number["inset_m"],
        u_inset_m=number["u_inset_m"],
        more=tuple(_points(number, f"{k}") for k in _further(row)),
    )


def _further(row: Mapping[str, str]) -> list[int]:
    """Numbers of the frames, from 2, on which the points of a row were clicked too."""
    found = (_FURTHER.fullmatch(name) for name in row if row[name])
    return sorted({int(one[1]) for one in found if one})


def _points(number: Mapping[str, float], k: str) -> tuple[tuple[float, float], tuple[float, float]]:
    return (
        (number[f"contact{k}_x_px"], number[f"contact{k}_y_px"]),
        (number[f"target{k}_x_px"], number[f"target{k}_y_px"]),
    )


def _same_clicks(row: Mapping[str, str], measured: Mapping[str, str]) -> None:
    for name in row:
        if name.endswith(("x_px", "y_px", "sigma_px", "inset_m")) and row[name] != measured[name]:
            raise Damaged(f"clicks.csv: {row['id']} has another {name} than measurements.csv; one is wrong.")


def _same(name: str, row: Mapping[str, str], found: Answer) -> None:
    """Height and solved inset are those that the clicks give."""
    for word, told, value in (
        ("height", row["height_m"], found.height_m),
        ("solved inset", row.get("solved_inset_m", ""), found.solved_inset_m),
    ):
        if not told and value is None:
            continue
        if not told or value is None or math.fabs(float(told) - value) > _HEIGHT_TOLERANCE_M:
            computed = f"no {word}" if value is None else f"{value:.6f} m"
            raise Damaged(
                f"measurements.csv: {name} says {_said(word, told)}, its clicks give {computed}; "
                "one is wrong."
            )


def _said(word: str, told: str) -> str:
    if not told:
        return f"no {word}"
    return told if word == "height" else f"{word} {told}"


def told_alike(files: Files, events: list[dict[str, str]]) -> None:
    """Points and height of each current revision equal those in its audit event. Raises Damaged."""
    told = {}
    for event in events:
        if event["entity"] == "measurement" and event["after"]:
            after = json.loads(event["after"])
            told[event["entity_id"], str(after.get("revision"))] = after
    for row in table(files, "measurements.csv"):
        after = told.get((row["id"], row["revision"]))
        if after is None:
            raise Damaged(
                f"audit.csv: measurement {row['id']} has no event for its revision; it was left out."
            )
        height_m = after.get("height_m")
        same = (row["height_m"] or None) == (None if height_m is None else f"{height_m:.6f}")
        for word, column in (("contact", "contact"), ("point", "target")):
            same = same and [float(row[f"{column}_{axis}_px"]) for axis in "xy"] == list(after[word])
        same = same and _frames_told(row) == after.get("more_frames", [])
        if not same:
            raise Damaged(f"measurements.csv: {row['id']} differs from its audit event; it was changed.")


def _frames_told(row: Mapping[str, str]) -> list[list[Any]]:
    """The further frames of a row in the words of its audit event: [frame, contact, target] each."""
    told = []
    for k in _further(row):
        points = [[float(row[f"{word}{k}_{axis}_px"]) for axis in "xy"] for word in ("contact", "target")]
        told.append([int(row[f"frame{k}"]), *points])
    return told
