"""From the rows of a package back to the columns that statistics are made of, and to the statistics.

An export and a check of it both go this way, so the statistics of a package are those of its own rows: of
heights to the micrometre, as the CSV carries them.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from dataclasses import dataclass, fields
from datetime import date
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.enums import Correction, Rounding, Target
from sightline.export.scans import scan_heights_in, scans_in
from sightline.export.traffic import traffic_in
from sightline.geometry.documents import camera_across_m
from sightline.infra.csv_package.files import Files, read_columns, unsafe
from sightline.infra.csv_package.forms import read_json
from sightline.measurements.sheets.csv import counting_in
from sightline.poses.csv import pose_path
from sightline.results.csv import selection_in, standards_in
from sightline.results.measured_columns_query import (
    CATEGORIES,
    CLASS_SETS,
    LANES,
    LIGHTING,
    NONE,
    TARGETS,
    UNCERTAINTY,
    VERDICTS,
    Measured,
)
from sightline.results.survey_statistics import Filter, Statistics, StatisticsOptions, filtered, made_of
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import ScanStatistics
from sightline.scans.statistics.traffic import ScanTraffic
from sightline.statistics.corrections import CORRECTIONS
from sightline.statistics.summary import Grouping
from sightline.surveys.csv import class_sets_in
from sightline.vehicles.records import KNOWN, is_reference

_EPOCH = date(1970, 1, 1).toordinal()
_READ = (
    "id",
    "vehicle_id",
    "target",
    "height_m",
    "uncorrected_height_m",
    "withdrawn",
    "verdict",
    "created_by_id",
    "created_at",
    "pose_id",
    "y_m",
    *UNCERTAINTY,
)


_OF_CAR = (
    "lighting",
    "filmed_day",
    "lane",
    "category",
    "class_set",
    "by_size",
    "check_target",
    "counts",
)


@dataclass(frozen=True, eq=False)
class Cars:
    """What the vehicles of a package are, by id: lighting, category and set as indices; `known`: height and
    u of each target in the order of TARGETS, metres."""

    lighting: dict[str, int]
    filmed_day: dict[str, int]
    lane: dict[str, int]
    category: dict[str, int]
    class_set: dict[str, int]
    by_size: dict[str, bool]
    check_target: dict[str, bool]
    counts: dict[str, bool]
    known: dict[str, tuple[float, ...]]


_TO_CM: Rounding = "cm"
#: As the paper measures: insets of 0, whole centimetres.
AS_PAPER: tuple[Correction, Rounding] = ("none", _TO_CM)


@dataclass(frozen=True, eq=False)
class PackageStatistics:
    """The statistics of a package: `of` the accepted measurements by (correction, rounding), and of scans."""

    of: Mapping[tuple[Correction, Rounding], Statistics]
    scans: ScanStatistics
    scan_heights: tuple[ScannedHeights, ...]
    scan_traffic: tuple[ScanTraffic, ...]

    @property
    def headline(self) -> Statistics:
        return self.of[StatisticsOptions().correction, StatisticsOptions().rounding]


def statistics_of(files: Files, choices: StatisticsOptions = StatisticsOptions()) -> PackageStatistics:
    """The statistics of the accepted measurements of a package that it is of, from its tables, under every
    correction.
    """
    chosen_of = selection_in(files)
    filter_ = Filter(
        lighting=chosen_of.lighting,
        categories=chosen_of.categories,
        class_sets=chosen_of.class_sets,
        filmed_from=chosen_of.filmed_from,
        filmed_to=chosen_of.filmed_to,
    )
    measured, left_out = filtered(measured_of(files), filter_)
    groupings = _groupings(files, measured)
    wanted: list[tuple[Correction, Rounding]] = [(one, "none") for one in CORRECTIONS]
    wanted.append(AS_PAPER)
    table = standards_in(files)
    found = {}
    for correction, rounding in wanted:
        chosen = StatisticsOptions(rounding, correction, choices.u_reference_m, choices.own_standards, table)
        found[correction, rounding] = made_of(measured, left_out, chosen, groupings, {}, {})
    return PackageStatistics(found, scans_in(files), scan_heights_in(files), traffic_in(files))


def measured_of(files: Files) -> Measured:
    """The standing measurements with a height, from measurements.csv, vehicles.csv and recordings.csv."""
    cars = _cars(files)
    whole = {name: array("q") for name in ("id", "vehicle", "operator", "day", "target", "verdict", "pose")}
    of_car = {name: array("q") for name in _OF_CAR}
    lengths = {name: array("d") for name in ("height", "paper", "known", "u_known", "across", *UNCERTAINTY)}
    cameras = _Cameras(files)
    for id_, car, target, height, paper, withdrawn, verdict, maker, at, pose, y, *parts in read_columns(
        files, "measurements.csv", _READ
    ):
        if withdrawn == "true" or not height or car not in cars.lighting:
            continue
        whole["id"].append(int(id_))
        whole["vehicle"].append(int(car))
        whole["operator"].append(int(maker) if maker else NONE)
        whole["day"].append(_day(at))
        whole["target"].append(TARGETS.index(target))
        whole["verdict"].append(VERDICTS.index(verdict))
        for name in _OF_CAR:
            of_car[name].append(getattr(cars, name)[car])
        lengths["height"].append(float(height))
        lengths["paper"].append(float(paper) if paper else np.nan)
        at_target = 2 * TARGETS.index(target)
        lengths["known"].append(cars.known[car][at_target])
        lengths["u_known"].append(cars.known[car][at_target + 1])
        whole["pose"].append(int(pose))
        lengths["across"].append(float(y) - cameras.across_m(int(pose)) if y else np.nan)
        for name, cell in zip(UNCERTAINTY, parts, strict=True):
            lengths[name].append(float(cell) if cell else np.nan)
    return Measured(
        measurement_id=_ints(whole["id"]),
        vehicle_id=_ints(whole["vehicle"]),
        survey_id=np.zeros(len(whole["id"]), dtype=np.int64),
        operator_id=_ints(whole["operator"]),
        day=_ints(whole["day"]),
        target=_ints(whole["target"]),
        filmed_day=_ints(of_car["filmed_day"]),
        lighting=_ints(of_car["lighting"]),
        lane=_ints(of_car["lane"]),
        category=_ints(of_car["category"]),
        class_set=_ints(of_car["class_set"]),
        verdict=_ints(whole["verdict"]),
        height_m=np.frombuffer(lengths["height"], np.float64),
        uncorrected_height_m=np.frombuffer(lengths["paper"], np.float64),
        known_m=np.frombuffer(lengths["known"], np.float64),
        u_known_m=np.frombuffer(lengths["u_known"], np.float64),
        by_size=_ints(of_car["by_size"]).astype(np.bool_),
        check_target=_ints(of_car["check_target"]).astype(np.bool_),
        counts=_ints(of_car["counts"]).astype(np.bool_),
        pose_id=_ints(whole["pose"]),
        across_m=np.frombuffer(lengths["across"], np.float64),
        **{name: np.frombuffer(lengths[name], np.float64) for name in UNCERTAINTY},
    )


class _Cameras:
    """Where the cameras of a package's poses stand, each read once."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._across_m: dict[int, float] = {}

    def across_m(self, pose_id: int) -> float:
        if pose_id not in self._across_m:
            self._across_m[pose_id] = camera_across_m(read_json(self._files, pose_path(pose_id)))
        return self._across_m[pose_id]


def _ints(values: array[int]) -> NDArray[np.int64]:
    return np.frombuffer(values, np.int64)


def _cars(files: Files) -> Cars:
    """A vehicle without lighting has its recording's, as on the statistics page."""
    of_recording = dict(read_columns(files, "recordings.csv", ("id", "lighting")))
    names = (
        "id",
        "recording_id",
        "lighting",
        "filmed_at",
        "direction",
        "category",
        "check_target",
        "model_chosen_by",
        *(name for target in get_args(Target) for name in (KNOWN[target].height, KNOWN[target].u)),
    )
    cars, sets = Cars(**{one.name: {} for one in fields(Cars)}), class_sets_in(files)
    counts = counting_in(files)
    for id_, recording, lighting, filmed_at, direction, category, check, chosen_by, *cells in read_columns(
        files, "vehicles.csv", names
    ):
        cars.lighting[id_] = _code(lighting or of_recording.get(recording, ""), LIGHTING)
        cars.filmed_day[id_] = _day(filmed_at) if filmed_at else NONE
        cars.lane[id_] = _code(direction, LANES)
        cars.category[id_] = _code(category, CATEGORIES)
        cars.class_set[id_] = _code(sets[category] if category else "", CLASS_SETS)
        cars.check_target[id_], cars.counts[id_] = check == "true", counts[id_]
        known = is_reference(chosen_by)
        cars.by_size[id_] = not known
        cars.known[id_] = tuple(float(cell) if cell and known else np.nan for cell in cells)
    return cars


def _day(at: str) -> int:
    """Days since 1970-01-01 of an ISO 8601 time, as it is written."""
    return date.fromisoformat(at[:10]).toordinal() - _EPOCH


def _code(word: str, words: tuple[str, ...]) -> int:
    return words.index(word) if word else NONE


def _groupings(files: Files, measured: Measured) -> dict[str, Grouping]:
    """By lighting, category, set and operator; a package is of one site."""
    people = {int(id_): unsafe(name) for id_, name in read_columns(files, "people.csv", ("id", "name"))}
    ids, at = np.unique(measured.operator_id, return_inverse=True)
    named = [f"{people[int(one)]} ({one})" if int(one) in people else "" for one in ids]
    words = sorted({name for name in named if name})
    code = np.array([words.index(name) if name else NONE for name in named], dtype=np.int64)
    return {
        "lighting": Grouping(measured.lighting, LIGHTING),
        "category": Grouping(measured.category, CATEGORIES),
        "class_set": Grouping(measured.class_set, CLASS_SETS),
        "operator": Grouping(code[at], words),
    }
