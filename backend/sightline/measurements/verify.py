"""Computing every height of a package again, and holding its rows against each other and their events."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from itertools import groupby
from typing import Any, cast

from sightline.coverage import COVERAGE_95
from sightline.enums import DriverSide, InsetSource, SideBasis, Target
from sightline.errors import BadInput, Damaged
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.road_pose import RoadPose
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_columns, read_rows, read_whole
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.schema import metres_text, safe_text
from sightline.measurements.csv import clicks_path
from sightline.measurements.height_of_clicks import Answer, answer
from sightline.measurements.records import ClickedFrame, Clicks, HeightOfClicks
from sightline.poses.csv import pose_path

Row = Mapping[str, str]
# Half of the last decimal that a CSV carries, and a hair for the rounding of the last binary digit.
_HEIGHT_TOLERANCE_M = 0.51e-6
_FURTHER = re.compile(r"(?:contact|target)(\d+)_[xy]_px")
# Lengths that the clicks give; an inset is given with them, uncertainties are held against their budget.
_RECOMPUTED = tuple(
    one.name
    for one in fields(HeightOfClicks)
    if (one.name.endswith("_m") and not one.name.startswith(("u_", "U95_", "inset")))
    or one.name in ("u_clicks_m", "u_by_inset_m")
)
_ONLY_CURRENT = ("id", "verdict", "review_reason", "reviewer_id", "reviewed_at")


@dataclass(eq=False)
class MeasurementEvents:
    """What the events say of measurements, as digests: `revisions` by (measurement, revision), `repeats` by
    repeat, of its newest revision; `of_vehicle`: whose each measurement is.
    """

    revisions: dict[tuple[int, int], bytes] = field(default_factory=dict)
    repeats: dict[int, bytes] = field(default_factory=dict)
    of_vehicle: dict[int, int] = field(default_factory=dict)

    def add(self, number: int, after: Mapping[str, Any]) -> None:
        """An event of a measurement; `after` with the person who did it as `by`."""
        self.of_vehicle[number] = int(after["vehicle_id"])
        if after.get("repeat_of") is not None:
            self.repeats[number] = _digest([*_short_of_event(after), stamp(after["created_at"])])
        else:
            stamps = [stamp(after["created_at"]), safe_text(after["code_version"])]
            self.revisions[number, int(after["revision"])] = _digest([*_words_of_event(after), *stamps])


def check_measurements(
    files: Files, events: MeasurementEvents, is_gone: Callable[[int], bool], heights: Recomputed
) -> int:
    """Compute the height of every revision again; how many were. `is_gone`: whether a vehicle was deleted.

    Raises Damaged.
    """
    count = 0
    revisions = groupby(read_rows(files, "revisions.csv"), key=lambda row: row["measurement_id"])
    clicks = _Lockstep(files, "clicks.csv", "id")
    of_poses: dict[str, _Lockstep] = {}
    budget = _Budget(files)
    for current in read_rows(files, "measurements.csv"):
        name, mine = next(revisions, ("", iter(())))
        rows = list(mine)
        if name != current["id"]:
            raise Damaged("measurements-revisions-csv-measurement-no-revisions-one", id=current["id"])
        for row in rows:
            heights.check(f"revisions.csv: {name}", row)
            _by_event(events, "revisions.csv", row, (int(name), int(row["revision"])))
            count += 1
        _is_newest(current, rows[-1])
        budget.check(current)
        if current["withdrawn"] != "true":
            path = clicks_path(int(current["pose_id"]))
            alone = of_poses.setdefault(path, _Lockstep(files, path, "id"))
            _same_clicks("clicks.csv", clicks.next(f"m{name}"), current)
            _same_clicks(path, alone.next(f"m{name}"), current)
    if next(revisions, None) is not None:
        raise Damaged("measurements-measurements-csv-lacks-measurement-revisions-csv")
    budget.end()
    for left in (clicks, *of_poses.values()):
        left.end()
    _nothing_left(events, is_gone)
    return count


class Recomputed:
    """Heights computed again from the poses of a package, each read once."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._poses: dict[str, RoadPose] = {}

    def check(self, name: str, row: Row) -> None:
        """The figures of a row are those that its clicks give. Raises Damaged."""
        _same(name, row, self._answer(row))

    def _answer(self, row: Row) -> Answer:
        path = pose_path(int(row["pose_id"]))
        if path not in self._poses:
            self._poses[path] = _pose(self._files, path)
        return answer(self._poses[path], clicks_of_row(row))


def _pose(files: Files, path: str) -> RoadPose:
    try:
        return pose_from_dict(json.loads(read_whole(files, path)), path)
    except (KeyError, ValueError, BadInput, Damaged) as error:
        raise Damaged("measurements-missing-no-road-pose-take-whole", path=path) from error


def clicks_of_row(row: Row) -> Clicks:
    """The clicks that a row of measurements, revisions or repeats tells."""
    number = {name: float(row[name]) for name in row if name.endswith(("_px", "inset_m")) and row[name]}
    return Clicks(
        target=cast(Target, row["target"]),
        contact=(number["contact_x_px"], number["contact_y_px"]),
        target_point=(number["target_x_px"], number["target_y_px"]),
        sigma_px=number["sigma_px"],
        inset_m=number.get("inset_m"),
        u_inset_m=number.get("u_inset_m"),
        inset_from=cast(InsetSource | None, row.get("inset_from")),
        side=cast(DriverSide | None, row.get("side") or None),
        side_from=cast(SideBasis | None, row.get("side_from") or None),
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
        raise Damaged(
            "measurements-says-clicks-give-one-wrong", name=name, status=row["status"], status_2=found.status
        )
    for column in _RECOMPUTED:
        told, value = row.get(column), getattr(found, column)
        if told is None or (not told and value is None):
            continue
        if not told or value is None or math.fabs(float(told) - value) > _HEIGHT_TOLERANCE_M:
            words = column.removesuffix("_m").replace("_", " ")
            computed = f"no {words}" if value is None else f"{value:.6f} m"
            raise Damaged(
                "measurements-says-clicks-give-one-wrong-2",
                name=name,
                words=words,
                told=told or "none",
                computed=computed,
            )


def _is_newest(current: Row, newest: Row) -> None:
    """A measurement is its last revision, word for word."""
    for column, text in current.items():
        if column not in _ONLY_CURRENT and newest.get(column) != text:
            raise Damaged(
                "measurements-measurements-csv-another-last-revision", id=current["id"], column=column
            )


def _same_clicks(path: str, row: Row, current: Row) -> None:
    for name in row:
        given = name.endswith(("x_px", "y_px", "sigma_px", "inset_m")) or name in (
            "pose_id",
            "target",
            "side",
        )
        if given and row[name] != current[name]:
            raise Damaged(
                "measurements-another-measurements-csv-one-wrong", path=path, id=row["id"], name=name
            )
    if row["pose_file"] != pose_path(int(row["pose_id"])):
        raise Damaged("measurements-names-another-pose-file-pose-changed", path=path, id=row["id"])


class _Lockstep:
    """A table that goes along with measurements.csv, row by row."""

    def __init__(self, files: Files, path: str, key: str) -> None:
        self._path, self._key = path, key
        self._rows = read_rows(files, path)

    def next(self, name: str) -> Row:
        row = next(self._rows, None)
        if row is None or row[self._key] != name:
            found = "ends" if row is None else f"goes on with {row[self._key]}"
            raise Damaged(
                "measurements-where-belongs-row-taken-out-put", path=self._path, found=found, name=name
            )
        return row

    def end(self) -> None:
        row = next(self._rows, None)
        if row is not None:
            raise Damaged("measurements-not-measurements-csv-put", path=self._path, row=row[self._key])


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
            raise Damaged("measurements-measurements-csv-u95-not-1-96", id=current["id"])
        if math.fabs(total - told) > 1e-6 * max(2, len(mine)):
            raise Damaged(
                "measurements-budget-csv-contributions-give-m-measurements",
                id=current["id"],
                total=total,
                told=told,
            )

    def end(self) -> None:
        if self._next is not None:
            raise Damaged("measurements-budget-csv-not-measurements-csv-put", next=self._next[0])


def _by_event(events: MeasurementEvents, path: str, row: Row, key: tuple[int, int]) -> None:
    digest = events.revisions.pop(key, None)
    if digest is None:
        raise Damaged(
            "measurements-measurement-no-audit-event-revision-put", path=path, key=key[0], key_2=key[1]
        )
    if not _same_words(digest, row, further(row)):
        raise Damaged("measurements-measurement-differs-audit-event-changed", path=path, key=key[0])


def _nothing_left(events: MeasurementEvents, is_gone: Callable[[int], bool]) -> None:
    """Every measurement that the chain tells of is there, those of deleted vehicles excepted."""
    for number, revision in events.revisions:
        if not is_gone(events.of_vehicle[number]):
            raise Damaged(
                "measurements-revisions-csv-revision-measurement-missing-though",
                revision=revision,
                number=number,
            )


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
                or figure_of(found[1]) != figure_of(said[1])
            ):
                raise Damaged("measurements-clicked-another-frame-frames-csv-tells", path=path, id=id_)


def _short_of_event(after: Mapping[str, Any]) -> list[Any]:
    plain = [after[name] for name in ("vehicle_id", "target", "frame", "pose_id", "status", "withdrawn")]
    points = [*after["contact"], *after["target_point"]]
    return [*plain, safe_text(after["reason"] or ""), _length(after["height_m"]), after["by"], points]


def _words_of_event(after: Mapping[str, Any]) -> list[Any]:
    more = [[n, *contact, *point] for n, contact, point in after.get("more_frames", [])]
    return [*_short_of_event(after), _length(after["U95_height_m"]), after["side"] or "", more]


def _length(value_m: float | None) -> str:
    return "" if value_m is None else metres_text(value_m)


def _short_of_row(row: Mapping[str, str]) -> list[Any]:
    plain = [int(row["vehicle_id"]), row["target"], int(row["frame"]), int(row["pose_id"])]
    said = [row["status"], row["withdrawn"] == "true", row["reason"], row["height_m"]]
    return [*plain, *said, row["created_by_id"], _points_of_row(row, "")]


def _words_of_row(row: Mapping[str, str], further: list[int]) -> list[Any]:
    """What a row says, in the form in which its event says it."""
    more = [[int(row[f"frame{k}"]), *_points_of_row(row, str(k))] for k in further]
    return [*_short_of_row(row), row["U95_height_m"], row["side"], more]


def _points_of_row(row: Mapping[str, str], k: str) -> list[float]:
    return [float(row[f"{word}{k}_{axis}_px"]) for word in ("contact", "target") for axis in "xy"]


def _same_words(told: bytes, row: Mapping[str, str], further: list[int]) -> bool:
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
