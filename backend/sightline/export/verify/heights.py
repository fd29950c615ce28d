"""Computing every height of an export again, and holding its rows against each other and their events."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from itertools import groupby
from typing import cast

from sightline.coverage import COVERAGE_95
from sightline.enums import Target
from sightline.errors import BadInput, Damaged
from sightline.export.verify.chain import ReplayedState, same_repeat, same_words
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.road_pose import RoadPose
from sightline.infra.csv_package.files import Files, read_rows, read_whole
from sightline.infra.csv_package.files import number as figure_of
from sightline.measurements.csv import clicks_path
from sightline.measurements.height_of_clicks import Answer, answer
from sightline.measurements.records import ClickedFrame, Clicks
from sightline.poses.csv import pose_path

Row = Mapping[str, str]
# Half of the last decimal that a CSV carries, and a hair for the rounding of the last binary digit.
_HEIGHT_TOLERANCE_M = 0.51e-6
_FURTHER = re.compile(r"(?:contact|target)(\d+)_[xy]_px")
_RECOMPUTED = ("height_m", "uncorrected_height_m", "distance_m", "solved_inset_m")
_ONLY_CURRENT = ("id", "verdict", "review_reason", "reviewer_id", "reviewed_at")


def check_heights(files: Files, told: ReplayedState) -> int:
    """Compute the height of every revision and repeat again; how many were. Raises Damaged."""
    shelf = _Shelf(files)
    count = 0
    revisions = groupby(read_rows(files, "revisions.csv"), key=lambda row: row["measurement_id"])
    clicks = _Lockstep(files, "clicks.csv", "id")
    of_poses: dict[str, _Lockstep] = {}
    budget = _Budget(files)
    for current in read_rows(files, "measurements.csv"):
        name, mine = next(revisions, ("", iter(())))
        rows = list(mine)
        if name != current["id"]:
            raise Damaged(f"revisions.csv: measurement {current['id']} has no revisions; one was taken out.")
        for row in rows:
            _same(f"revisions.csv: {name}", row, shelf.answer(row))
            _by_event(told, "revisions.csv", row, (int(name), int(row["revision"])))
            count += 1
        _is_newest(current, rows[-1])
        budget.check(current)
        if current["withdrawn"] != "true":
            path = clicks_path(int(current["pose_id"]))
            alone = of_poses.setdefault(path, _Lockstep(files, path, "id"))
            _same_clicks("clicks.csv", clicks.next(f"m{name}"), current)
            _same_clicks(path, alone.next(f"m{name}"), current)
    if next(revisions, None) is not None:
        raise Damaged("measurements.csv lacks a measurement that revisions.csv holds; one was taken out.")
    budget.end()
    for left in (clicks, *of_poses.values()):
        left.end()
    _nothing_left(told)
    return count + _repeats(files, told, shelf)


class _Shelf:
    """The poses of a package, read once."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._poses: dict[str, RoadPose] = {}

    def answer(self, row: Row) -> Answer:
        """What the clicks of a row give."""
        path = pose_path(int(row["pose_id"]))
        if path not in self._poses:
            self._poses[path] = _pose(self._files, path)
        return answer(self._poses[path], _clicks(row))


def _pose(files: Files, path: str) -> RoadPose:
    try:
        return pose_from_dict(json.loads(read_whole(files, path)), path)
    except (KeyError, ValueError, BadInput, Damaged) as error:
        raise Damaged(f"{path} is missing or is no road pose; take the whole export again.") from error


def _clicks(row: Row) -> Clicks:
    number = {name: float(row[name]) for name in row if name.endswith(("_px", "inset_m")) and row[name]}
    return Clicks(
        target=cast(Target, row["target"]),
        contact=(number["contact_x_px"], number["contact_y_px"]),
        target_point=(number["target_x_px"], number["target_y_px"]),
        sigma_px=number["sigma_px"],
        inset_m=number["inset_m"],
        u_inset_m=number["u_inset_m"],
        more_frames=tuple(_on_further(number, k) for k in further(row)),
    )


def further(row: Row) -> list[int]:
    """Numbers of the frames, from 2, on which the points of a row were clicked too."""
    found = (_FURTHER.fullmatch(name) for name in row if row[name])
    return sorted({int(one[1]) for one in found if one})


def _on_further(number: Mapping[str, float], k: int) -> ClickedFrame:
    return ClickedFrame(
        frame=k,
        contact=(number[f"contact{k}_x_px"], number[f"contact{k}_y_px"]),
        target_point=(number[f"target{k}_x_px"], number[f"target{k}_y_px"]),
    )


def _same(name: str, row: Row, found: Answer) -> None:
    """The figures of a row are those that its clicks give."""
    if row["status"] != found.status:
        raise Damaged(f"{name} says {row['status']}, its clicks give {found.status}; one is wrong.")
    for column in _RECOMPUTED:
        told, value = row.get(column), getattr(found, column)
        if told is None or (not told and value is None):
            continue
        if not told or value is None or math.fabs(float(told) - value) > _HEIGHT_TOLERANCE_M:
            words = column.removesuffix("_m").replace("_", " ")
            computed = f"no {words}" if value is None else f"{value:.6f} m"
            raise Damaged(f"{name} says {words} {told or 'none'}, its clicks give {computed}; one is wrong.")


def _is_newest(current: Row, newest: Row) -> None:
    """A measurement is its last revision, word for word."""
    for column, text in current.items():
        if column not in _ONLY_CURRENT and newest.get(column) != text:
            raise Damaged(f"measurements.csv: {current['id']} has another {column} than its last revision.")


def _same_clicks(path: str, row: Row, current: Row) -> None:
    for name in row:
        given = name.endswith(("x_px", "y_px", "sigma_px", "inset_m")) or name in ("pose_id", "target")
        if given and row[name] != current[name]:
            raise Damaged(f"{path}: {row['id']} has another {name} than measurements.csv; one is wrong.")
    if row["pose_file"] != pose_path(int(row["pose_id"])):
        raise Damaged(f"{path}: {row['id']} names another pose file than its pose; it was changed.")


class _Lockstep:
    """A table that goes along with measurements.csv, row by row."""

    def __init__(self, files: Files, path: str, key: str) -> None:
        self._path, self._key = path, key
        self._rows = read_rows(files, path)

    def next(self, name: str) -> Row:
        row = next(self._rows, None)
        if row is None or row[self._key] != name:
            found = "ends" if row is None else f"goes on with {row[self._key]}"
            raise Damaged(f"{self._path} {found} where {name} belongs; a row was taken out or put in.")
        return row

    def end(self) -> None:
        row = next(self._rows, None)
        if row is not None:
            raise Damaged(f"{self._path}: {row[self._key]} is not in measurements.csv; it was put in.")


class _Budget:
    """budget.csv along with measurements.csv."""

    def __init__(self, files: Files) -> None:
        rows = read_rows(files, "budget.csv")
        self._groups = groupby(rows, key=lambda row: row["measurement_id"])
        self._next = self._take()

    def _take(self) -> tuple[str, list[Row]] | None:
        found = next(self._groups, None)
        return None if found is None else (found[0], list(found[1]))

    def check(self, current: Row) -> None:
        """The root sum of squares of the contributions is the u of the height."""
        mine: list[Row] = []
        if self._next is not None and self._next[0] == current["id"]:
            mine = self._next[1]
            self._next = self._take()
        total = math.sqrt(sum(float(row["u_m"]) ** 2 for row in mine))
        told, u95 = (figure_of(current[name]) or 0.0 for name in ("u_height_m", "U95_height_m"))
        if math.fabs(u95 - COVERAGE_95 * told) > 2e-6:
            raise Damaged(f"measurements.csv: {current['id']} has a U95 that is not 1.96 u; one is wrong.")
        if math.fabs(total - told) > 1e-6 * max(2, len(mine)):
            raise Damaged(
                f"budget.csv: the contributions to {current['id']} give {total:.6f} m, measurements.csv says "
                f"{told:.6f} m; one is wrong."
            )

    def end(self) -> None:
        if self._next is not None:
            raise Damaged(f"budget.csv: {self._next[0]} is not in measurements.csv; it was put in.")


def _by_event(told: ReplayedState, path: str, row: Row, key: tuple[int, int]) -> None:
    digest = told.revisions.pop(key, None)
    if digest is None:
        raise Damaged(
            f"{path}: measurement {key[0]} has no audit event for revision {key[1]}; it was put in."
        )
    if not same_words(digest, row, further(row)):
        raise Damaged(f"{path}: measurement {key[0]} differs from its audit event; it was changed.")


def _nothing_left(told: ReplayedState) -> None:
    """Every measurement that the chain tells of is there, those of deleted vehicles excepted."""
    for number, revision in told.revisions:
        if not told.is_gone(told.of_vehicle[number]):
            raise Damaged(
                f"revisions.csv: revision {revision} of measurement {number} is missing, though its audit "
                "event is there; it was taken out."
            )


def _repeats(files: Files, told: ReplayedState, shelf: _Shelf) -> int:
    count = 0
    for row in read_rows(files, "repeats.csv"):
        number = int(row["id"])
        _same(f"repeats.csv: {number}", row, shelf.answer(row))
        digest = told.repeats.pop(number, None)
        if digest is None or not same_repeat(digest, row):
            raise Damaged(f"repeats.csv: {number} is not what its audit event says; it was changed.")
        count += 1
    left = [number for number in told.repeats if not told.is_gone(told.of_vehicle[number])]
    if left:
        raise Damaged(f"repeats.csv: repeat {left[0]} is missing, though its audit event is there.")
    return count
