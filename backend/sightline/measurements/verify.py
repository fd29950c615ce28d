"""Computing every height of a package again, and holding its rows against each other and their events."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import fields
from datetime import datetime
from itertools import groupby
from operator import itemgetter
from typing import Any, cast

from sightline.coverage import COVERAGE_95
from sightline.enums import DriverSide, InsetSource, SideBasis, Target
from sightline.errors import BadInput, Damaged
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.road_pose import RoadPose
from sightline.infra.audit.hashing import canonical_json, content_hash
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.files import Files, columns_lacking, read_columns, read_rows, read_whole
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.replay import Digests
from sightline.infra.csv_package.schema import CODE, AnyTable
from sightline.measurements.again.differences import Facts, facts_of
from sightline.measurements.csv import (
    BUDGET,
    CLICKS,
    REVISIONS,
    budget_entries,
    clicks_path,
    count_frames,
    with_frames,
)
from sightline.measurements.height_of_clicks import Answer, answer
from sightline.measurements.moved import drift_flag, earlier_drift_flag, errors_of_motion, spans_clicked_on
from sightline.measurements.records import (
    ClickedFrame,
    Clicks,
    FurtherFrame,
    HeightOfClicks,
    Measurement,
    MeasurementValues,
    ReviewState,
)
from sightline.messages.said import Said
from sightline.poses.csv import pose_path
from sightline.recordings.csv import filmings_in
from sightline.recordings.drift import MovedSpan
from sightline.recordings.filming import Filming
from sightline.vehicles.records import KNOWN, is_reference

#: The part of the program that computes heights from clicks, by its name in datapackage.json.
HEIGHTS = "heights"
Row = Mapping[str, str]
#: Where the camera had moved, by recording and pose.
OpenSpans = Callable[[int, int], list[MovedSpan]]
# Half of the last decimal that a CSV carries, and a hair for the rounding of the last binary digit.
_HEIGHT_TOLERANCE_M = 0.51e-6
_FURTHER = re.compile(r"(?:contact|target)(\d+)_[xy]_px")
# Lengths that the clicks give; an inset is given with them, uncertainties are held against their budget.
_RECOMPUTED = tuple(
    column.name
    for column in fields(HeightOfClicks)
    if (column.name.endswith("_m") and not column.name.startswith(("u_", "U95_", "inset")))
    or column.name in ("u_clicks_m", "u_by_inset_m")
)
_FIRST_CLICKS = ("frame", "contact_x_px", "contact_y_px", "target_x_px", "target_y_px")
_VERDICT = ("verdict", "review_reason", "reviewer_id", "reviewed_at", "verdict_by", "lot_id")
_ONLY_CURRENT = ("id", "filmed_at", "out_of_date", "operator_id", "clicked_at", *_VERDICT)


class MeasurementEvents:
    """What the events say of measurements: `revisions` by measurement and revision, `repeats` (as
    `table_of_repeats` has them) and `budgets` of the newest revision of each.

    `of_vehicle`: whose each measurement or repeat is; `follows_from`: target and facts of each, newest
    revision; `programs_of_repeats`: the version that computed each; `frames`: pts, time and CRC-32 of each
    frame clicked on, by (recording, frame). Of tables that the package has with other `headers` than this
    program, what both have is compared.
    """

    def __init__(self, table_of_repeats: AnyTable, headers: Mapping[str, Collection[str]]) -> None:
        self.headers = headers
        of_revisions = with_frames(REVISIONS, count_frames(headers.get(REVISIONS.key, ())))
        self.revisions = Digests(of_revisions, headers.get(REVISIONS.key, ()))
        self.repeats = Digests(table_of_repeats, headers.get(table_of_repeats.key, ()))
        self.budgets = Digests(BUDGET, BUDGET.header)
        self.of_vehicle: dict[int, int] = {}
        self.follows_from: dict[int, tuple[Target, Facts]] = {}
        self.frames: dict[tuple[int, int], list[str]] = {}
        self.programs_of_repeats: dict[int, str] = {}

    def add(self, number: int, after: Mapping[str, Any]) -> None:
        """An event of a measurement; `after` with the person who did it as `by`. Raises Damaged."""
        if content_hash(after["row"]) != after["content_sha256"]:
            raise Damaged("measurements-event-another-row", id=number)
        revision = _revision_of_event(number, after)
        self.of_vehicle[number] = revision.vehicle_id
        clicked_on: tuple[MeasurementValues | FurtherFrame, ...] = (
            revision.values,
            *revision.values.more_frames,
        )
        for on_frame in clicked_on:
            known = [str(on_frame.pts), repr(on_frame.time_s), str(on_frame.frame_crc32)]
            if self.frames.setdefault((revision.recording_id, on_frame.frame), known) != known:
                raise Damaged(
                    "measurements-events-two-frames", recording=revision.recording_id, frame=on_frame.frame
                )
        self.follows_from[number] = revision.values.target, facts_of(revision.values, revision.values.pose_id)
        if revision.repeat_of is not None:
            self.repeats.tell((number,), revision)
            self.programs_of_repeats[number] = revision.values.code_version
        else:
            self.revisions.tell((number, revision.revision), revision)
            self.budgets.tell((number,), *budget_entries(revision))


def _revision_of_event(number: int, after: Mapping[str, Any]) -> Measurement:
    """The revision as its event tells it."""
    row = {name: _as_stored(name, value) for name, value in after["row"].items()}
    points: dict[str, Any] = {
        "contact": (row["contact_x_px"], row["contact_y_px"]),
        "target_point": (row["target_x_px"], row["target_y_px"]),
        "more_frames": tuple(_told_frame(one) for one in row["more_frames"]),
    }
    # what an event of an earlier version does not tell has the value that says so
    values = {one.name: row[one.name] for one in fields(MeasurementValues) if one.name in {*row} - {*points}}
    values["reason"] = None if row["reason"] is None else Said.read(row["reason"])
    values["flags"] = [Said.read(flag) for flag in row["flags"]]
    by = row["created_by"]
    return Measurement(
        id=number,
        revision=row["revision"],
        revision_id=after["revision_id"],
        survey_id=0,
        vehicle_id=after["vehicle_id"],
        recording_id=after["recording_id"],
        repeat_of=after.get("repeat_of"),
        values=MeasurementValues(**values, **points),
        created_by=None if by is None else Who(by, ""),
        created_at=datetime.fromisoformat(row["created_at"]),
        withdrawn=row["withdrawn"],
        review=ReviewState("to_review"),
        computing_id=row["computing_id"],
        verdict_of_revision=row["verdict_of_revision"],
    )


def _told_frame(document: Mapping[str, Any]) -> FurtherFrame:
    told = {name: _as_stored(name, value) for name, value in document.items()}
    points: dict[str, Any] = {
        name: (float(told[name][0]), float(told[name][1])) for name in ("contact", "target_point")
    }
    return FurtherFrame(**{**told, **points})


def _as_stored(name: str, value: Any) -> Any:
    """A value of RFC 8785 text, which writes 3.0 as 3 and large whole numbers as text, as it was stored."""
    if name.endswith(("_px", "_m", "_s")) and value is not None:
        return float(value)
    return int(value) if name == "pts" else value


def check_measurements(
    files: Files,
    events: MeasurementEvents,
    is_gone: Callable[[int], bool],
    open_spans: OpenSpans,
    heights: Recomputed,
) -> None:
    """Compute the height of every revision again, and what the camera's motion in `open_spans` did to it.
    `is_gone`: whether a vehicle was deleted.

    Raises Damaged.
    """
    revisions = _Along(files, REVISIONS.key, "measurement_id")
    budgets = _Along(files, BUDGET.key, "measurement_id")
    clicks = {CLICKS.key: _Along(files, CLICKS.key, "id")}
    filmings, vehicles = filmings_in(files), _OfVehicles(files)
    untold = set(events.headers.get(BUDGET.key, ())) - set(BUDGET.header)  # columns that no event says
    for current in read_rows(files, "measurements.csv"):
        name = current["id"]
        rows = revisions.of(name)
        if not rows:
            raise Damaged("measurements-no-revisions", id=name)
        for row in rows:
            heights.check(f"revisions.csv: {name}", row, row["code_version"])
            stored = heights.without_drift(f"revisions.csv: {name}", row, open_spans)
            key = int(name), int(row["revision"])
            if key not in events.revisions:
                raise Damaged(
                    "measurements-revision-without-event", path=REVISIONS.key, key=key[0], key_2=key[1]
                )
            if not events.revisions.are_told(key, stored):
                raise Damaged("measurements-event-differs", path=REVISIONS.key, key=key[0])
        _is_newest(current, rows[-1])
        _is_of_clicks(current, rows)
        _is_filmed(current, filmings.get(current["recording_id"]))
        contributions = budgets.of(name)
        _is_sum(current, contributions)
        if not events.budgets.are_told((int(name),), *contributions) or (untold and contributions):
            raise Damaged("measurements-budget-differs", id=name)
        if current["withdrawn"] != "true":
            path = clicks_path(int(current["pose_id"]))
            clicks.setdefault(path, _Along(files, path, "id"))
            for at in (CLICKS.key, path):
                clicked, *others = clicks[at].of(f"m{name}") or ({},)
                if others or not clicked:
                    raise Damaged("measurements-row-misplaced", path=at, name=f"m{name}")
                _same_clicks(at, clicked, current)
                vehicles.check(at, clicked, current)
    for along in (revisions, budgets, *clicks.values()):
        along.require_end()
    events.revisions.require_none_left(lambda number: is_gone(events.of_vehicle[number]))


class Recomputed:
    """Heights computed again from the poses of a package, each read once; `program` wrote the package."""

    def __init__(self, files: Files, recomputing: Recomputing, program: str) -> None:
        self._files, self._recomputing, self._program = files, recomputing, program
        self._poses: dict[str, RoadPose] = {}

    def check(self, name: str, row: Row, by: str) -> None:
        """The figures of a row, computed by this version, are those that its clicks give. Raises Damaged."""
        with self._recomputing.of(HEIGHTS, by):
            _compare_figures(name, row, self._answer(row))

    def without_drift(self, name: str, row: Row, open_spans: OpenSpans) -> dict[str, str]:
        """The cells of a row that are not empty, its flags as they were stored.

        What is added to them where the camera had moved follows from events of the recording and from the
        row's own clicks. Raises Damaged where it is another.
        """
        cells = {name: text for name, text in row.items() if text}
        spans = open_spans(int(row["recording_id"]), int(row["pose_id"]))
        clicks = clicks_of_row(row)
        if not spans_clicked_on(clicks, spans):
            return cells
        (error_m,) = errors_of_motion(self._pose(row), [clicks], spans)
        flag = drift_flag(clicks, spans, error_m)
        code = f"flags{CODE}"
        if code not in row:  # its program had no codes, and other words
            return {**cells, "flags": cells.get("flags", "").partition("The camera moved ")[0].rstrip("; ")}
        *stored, last = json.loads(cells.pop(code, "[null]"))
        earlier = earlier_drift_flag(clicks, spans)
        same = _rounded_alike(last, flag, error_m) or (earlier is not None and last == earlier.document)
        if not same:
            with self._recomputing.of(HEIGHTS, self._program):
                raise Damaged("measurements-drift-differs", name=name, computed=flag)
        return {**cells, code: canonical_json(stored) if stored else ""}

    def _answer(self, row: Row) -> Answer:
        return answer(self._pose(row), clicks_of_row(row))

    def _pose(self, row: Row) -> RoadPose:
        path = pose_path(int(row["pose_id"]))
        if path not in self._poses:
            self._poses[path] = _pose(self._files, path)
        return self._poses[path]


def _rounded_alike(told: Any, flag: Said, error_m: float | None) -> bool:
    """Whether a flag is the one computed, whose error may have been rounded the other way elsewhere."""
    if error_m is None or not isinstance(told, dict) or told.get("code") != flag.code:
        return bool(told == flag.document)
    values = told["values"]
    near = math.fabs(values["error_m"] - math.fabs(error_m)) < 0.5e-3 + _HEIGHT_TOLERANCE_M
    return near and {**values, "error_m": flag.values["error_m"]} == dict(flag.values)


def _pose(files: Files, path: str) -> RoadPose:
    try:
        return pose_from_dict(json.loads(read_whole(files, path)), path)
    except (KeyError, ValueError, BadInput, Damaged) as error:
        raise Damaged("measurements-pose-missing", path=path) from error


def clicks_of_row(row: Row) -> Clicks:
    """The clicks that a row of measurements, revisions or repeats tells."""
    number = {name: float(row[name]) for name in row if name.endswith(("_px", "inset_m")) and row[name]}
    return Clicks(
        target=cast(Target, row["target"]),
        frame=int(row["frame"]),
        contact=(number["contact_x_px"], number["contact_y_px"]),
        target_point=(number["target_x_px"], number["target_y_px"]),
        sigma_px=number["sigma_px"],
        inset_m=number.get("inset_m"),
        u_inset_m=number.get("u_inset_m"),
        inset_from=cast(InsetSource | None, row.get("inset_from")),
        side=cast(DriverSide | None, row.get("side") or None),
        side_from=cast(SideBasis | None, row.get("side_from") or None),
        followed=row.get("followed") or None,
        more_frames=tuple(_on_further(row, number, k) for k in further_frame_numbers(row)),
    )


def further_frame_numbers(row: Row) -> list[int]:
    """Numbers of the frames, from 2, on which the points of a row were clicked too."""
    found = (_FURTHER.fullmatch(name) for name in row if row[name])
    return sorted({int(one[1]) for one in found if one})


def _on_further(row: Row, number: Mapping[str, float], k: int) -> ClickedFrame:
    return ClickedFrame(
        frame=int(row[f"frame{k}"]),
        contact=(number[f"contact{k}_x_px"], number[f"contact{k}_y_px"]),
        target_point=(number[f"target{k}_x_px"], number[f"target{k}_y_px"]),
    )


def _compare_figures(name: str, row: Row, answered: Answer) -> None:
    """The figures of a row are those that its clicks give."""
    if row["status"] != answered.status:
        raise Damaged(
            "measurements-status-differs", name=name, status=row["status"], status_2=answered.status
        )
    for column in _RECOMPUTED:
        stored, value = row.get(column), getattr(answered, column)
        if stored is None or (not stored and value is None):
            continue
        if not stored or value is None or math.fabs(float(stored) - value) > _HEIGHT_TOLERANCE_M:
            words = column.removesuffix("_m").replace("_", " ")
            computed = f"no {words}" if value is None else f"{value:.6f} m"
            raise Damaged(
                "measurements-result-differs",
                name=name,
                words=words,
                told=stored or "none",
                computed=computed,
            )


def _is_newest(current: Row, newest: Row) -> None:
    """A measurement is its last revision, word for word."""
    for column, text in current.items():
        if column not in _ONLY_CURRENT and newest.get(column) != text:
            raise Damaged("measurements-last-revision-differs", id=current["id"], column=column)


def _is_of_clicks(current: Row, revisions: Sequence[Row]) -> None:
    """Who clicked, and when: of the first revision with the points that stand (`revision_of_clicks`)."""
    first = next(row for row in revisions if all(row[name] == current[name] for name in _FIRST_CLICKS))
    if current.get("operator_id", first["created_by_id"]) != first["created_by_id"]:
        raise Damaged("measurements-operator-differs", id=current["id"])
    if current.get("clicked_at", first["created_at"]) != first["created_at"]:
        raise Damaged("measurements-clicked-at-differs", id=current["id"])


def _is_filmed(row: Row, filming: Filming | None) -> None:
    """When a frame was filmed follows from its recording's start; that is held against its events."""
    if row["filmed_at"] != ("" if filming is None else filming.at(float(row["time_s"]))):
        raise Damaged("measurements-filmed-time", id=row["id"])


def _is_sum(current: Row, contributions: Sequence[Row]) -> None:
    """The root sum of squares of the contributions is the u of the height, and its U95 that expanded."""
    total = math.sqrt(sum(float(row["u_m"]) ** 2 for row in contributions))
    u_m, u95 = (figure_of(current[name]) or 0.0 for name in ("u_height_m", "U95_height_m"))
    if math.fabs(u95 - COVERAGE_95 * u_m) > 2e-6:
        raise Damaged("measurements-u95-wrong", id=current["id"])
    if math.fabs(total - u_m) > 1e-6 * max(2, len(contributions)):
        raise Damaged("measurements-budget-sum", id=current["id"], total=total, told=u_m)


def _same_clicks(path: str, row: Row, current: Row) -> None:
    """What a row of clicks has in common with its measurement is the same."""
    expected = {**current, "id": row["id"], "pose_file": pose_path(int(current["pose_id"]))}
    for name in row:
        if (name in expected or name.endswith("_px")) and row[name] != expected.get(name, ""):
            raise Damaged("measurements-value-differs", path=path, id=row["id"], name=name)


class _OfVehicles:
    """What a row of clicks repeats of its vehicle; vehicles.csv is held against its events. Columns that an
    earlier package lacks are not compared.
    """

    def __init__(self, files: Files) -> None:
        lacking = columns_lacking(files, "vehicles.csv") | columns_lacking(files, CLICKS.key)
        lit = dict(read_columns(files, "recordings.csv", ("id", "lighting")))
        # before `error_counts`, `counts` was the vehicle's; since then the statistics' check holds it
        counts = ("counts",) if "error_counts" in lacking else ()
        self._names = [one for one in ("lighting", "category", "check_target", *counts) if one not in lacking]
        self._told: dict[str, dict[str, str]] = {}
        for row in read_rows(files, "vehicles.csv"):
            lighting = row["lighting"] or lit.get(row["recording_id"], "")
            told = {**{name: row.get(name, "") for name in self._names}, "lighting": lighting}
            if is_reference(row.get("model_chosen_by")):
                told |= {names.height: row.get(names.height, "") for names in KNOWN.values()}
            self._told[row["id"]] = told

    def check(self, path: str, row: Row, current: Row) -> None:
        """Raises Damaged where a row of clicks says something else of the vehicle than vehicles.csv."""
        told = self._told.get(current["vehicle_id"])
        if told is None:
            raise Damaged("measurements-vehicle-missing", path=path, id=row["id"])
        known = told.get(KNOWN[cast(Target, row["target"])].height, "")
        for name, value in (*((one, told[one]) for one in self._names), ("reference_height_m", known)):
            if row.get(name, "") != value:
                raise Damaged("measurements-vehicle-differs", path=path, id=row["id"], name=name)


class _Along:
    """The rows of a table that goes along with measurements.csv, by what they name it by."""

    def __init__(self, files: Files, path: str, key: str) -> None:
        self._path = path
        self._name: str | None = None
        self._groups = groupby(read_rows(files, path), key=itemgetter(key))
        self._take()

    def _take(self) -> None:
        self._name, rows = next(self._groups, (None, iter(())))
        self._rows = list(rows)

    def of(self, name: str) -> list[Row]:
        """The rows of one; none where others come first."""
        if name != self._name:
            return []
        rows: list[Row] = [*self._rows]
        self._take()
        return rows

    def require_end(self) -> None:
        """No row is left. Raises Damaged."""
        if self._name is not None:
            raise Damaged("measurements-row-added", path=self._path, row=self._name)


def check_frames(files: Files, events: MeasurementEvents) -> None:
    """What frames.csv says of a frame is what the events of the measurements clicked on it say, and what each
    of their rows says is what frames.csv says of it.
    """
    names = ("pts", "time_s", "crc32")
    known = {
        (row["recording_id"], row["frame"]): [row[name] for name in names]
        for row in read_rows(files, "frames.csv")
    }
    for (recording, frame), said in known.items():
        if events.frames.get((int(recording), int(frame))) != said:
            raise Damaged("measurements-frame-table-differs", recording=recording, frame=frame)
    columns = ("id", "recording_id", "frame", "pts", "time_s", "frame_crc32")
    for path in ("measurements.csv", "repeats.csv"):
        for id_, recording, frame, *said in read_columns(files, path, columns):
            if known.get((recording, frame)) != said:
                raise Damaged("measurements-frame-differs", path=path, id=id_)
