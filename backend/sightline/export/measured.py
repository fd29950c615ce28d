"""From the rows of a package back to the columns that statistics are made of, and to the statistics.

An export and a check of it both go this way, so the statistics of a package are those of its own rows: of
heights to the micrometre, as the CSV carries them.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from datetime import date
from typing import Any, get_args

import numpy as np

from sightline.arrays import Ints
from sightline.enums import Correction, Rounding, Target
from sightline.export.scans import scan_heights_in, scanned_motions, scans_in
from sightline.export.traffic import seen_in, traffic_of_scans
from sightline.geometry.documents import camera_across_m
from sightline.infra.csv_package.files import (
    Files,
    columns_lacking,
    read_columns,
    read_integer,
    undo_safe_text,
)
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.forms import read_json
from sightline.linescan.traffic import MINUTES
from sightline.measurements.csv import MEASUREMENTS
from sightline.measurements.sheets.csv import counting_in
from sightline.poses.csv import pose_path
from sightline.recordings.filming import hour_filmed
from sightline.results.csv import selection_in
from sightline.results.measured_columns_query import (
    CATEGORIES,
    CLASS_SETS,
    LIGHTING,
    NONE,
    UNCERTAINTY,
    Measured,
    day_of,
    measured_of,
)
from sightline.results.survey_statistics import (
    Statistics,
    StatisticsOptions,
    filter_measured,
    filter_of,
    made_of,
)
from sightline.results.usual_standards import standards_in
from sightline.scans.statistics.heights import ScannedHeights
from sightline.scans.statistics.service import ScanStatistics
from sightline.scans.statistics.traffic import ScanTraffic
from sightline.statistics.corrections import CORRECTIONS
from sightline.statistics.summary import Grouping
from sightline.surveys.csv import class_sets_in
from sightline.vehicles.records import KNOWN, is_reference

_READ = (
    "id",
    "vehicle_id",
    "target",
    "height_m",
    "uncorrected_height_m",
    "withdrawn",
    "verdict",
    "created_by_id",
    "operator_id",
    "created_at",
    "clicked_at",
    "pose_id",
    "y_m",
    *UNCERTAINTY,
)


_OF_CAR = (
    "lighting",
    "filmed_hour",
    "lane",
    "category",
    "class_set",
    "by_size",
    "check_target",
    "counts",
)


_TO_CM: Rounding = "cm"
#: As the paper measures: insets of 0, whole centimetres.
AS_PAPER: tuple[Correction, Rounding] = ("none", _TO_CM)


@dataclass(frozen=True, eq=False)
class PackageStatistics:
    """The statistics of a package: `of` the accepted measurements by (correction, rounding), and of scans.

    `evaluated` (N,): the measurements that they are of, check targets among them, by number.
    """

    evaluated: Ints
    of: Mapping[tuple[Correction, Rounding], Statistics]
    scans: ScanStatistics
    scan_heights: tuple[ScannedHeights, ...]
    scan_traffic: tuple[ScanTraffic, ...]

    @property
    def headline(self) -> Statistics:
        return self.of[StatisticsOptions().correction, StatisticsOptions().rounding]


def statistics_of(files: Files) -> PackageStatistics:
    """Statistics of the accepted measurements of a package's selection, from its tables, by correction."""
    filter_ = filter_of(selection_in(files))
    measured, left_out = filter_measured(measured_in(files), filter_)
    groupings = _groupings(files, measured)
    wanted: list[tuple[Correction, Rounding]] = [(one, "none") for one in CORRECTIONS]
    wanted.append(AS_PAPER)
    table = standards_in(files)
    statistics = {}
    for correction, rounding in wanted:
        chosen = StatisticsOptions(rounding, correction, standards=table)
        # tables and report divide the headline's heights alone
        divided = groupings if correction == "inset" else {}
        statistics[correction, rounding] = made_of(measured, left_out, filter_, chosen, divided, {}, {})
    scanned = list(scanned_motions(files))
    return PackageStatistics(
        measured.measurement_id,
        statistics,
        scans_in(files, scanned),
        scan_heights_in(files),
        traffic_of_scans(seen_in(files, scanned), MINUTES),
    )


def measured_in(files: Files) -> Measured:
    """The standing measurements with a height, from measurements.csv, vehicles.csv and recordings.csv."""
    cars, cameras = _cars(files), _Cameras(files)
    columns: dict[str, list[Any]] = {one.name: [] for one in fields(Measured)}
    # before the columns, who restored a height was told as its operator, and when as its moment
    earlier = "operator_id" in columns_lacking(files, MEASUREMENTS.key)
    operator = "created_by_id" if earlier else "operator_id"
    for row in read_columns(files, "measurements.csv", _READ):
        of = dict(zip(_READ, row, strict=True))
        car = cars.get(of["vehicle_id"])
        if of["withdrawn"] == "true" or not of["height_m"] or car is None:
            continue
        known_m, u_known_m = car["known"][of["target"]]
        values = {
            **{name: car[name] for name in _OF_CAR},
            **{name: figure_of(of[name]) for name in ("height_m", "uncorrected_height_m", *UNCERTAINTY)},
            "measurement_id": int(of["id"]),
            "vehicle_id": int(of["vehicle_id"]),
            "survey_id": 0,
            "operator_id": read_integer(of[operator]),
            "day": _day(of["clicked_at"] or of["created_at"]),
            "target": of["target"],
            "verdict": of["verdict"],
            "known_m": known_m,
            "u_known_m": u_known_m,
            "pose_id": int(of["pose_id"]),
            "across_m": float(of["y_m"]) - cameras.across_m(int(of["pose_id"])) if of["y_m"] else None,
        }
        for name, column in columns.items():
            column.append(values[name])
    return measured_of(columns)


class _Cameras:
    """Where the cameras of a package's poses stand, each read once."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._across_m: dict[int, float] = {}

    def across_m(self, pose_id: int) -> float:
        if pose_id not in self._across_m:
            self._across_m[pose_id] = camera_across_m(read_json(self._files, pose_path(pose_id)))
        return self._across_m[pose_id]


def _cars(files: Files) -> dict[str, dict[str, Any]]:
    """What `Measured` says of the vehicles of a package, by number, with the height and u `known` of each
    target, metres; one without lighting has its recording's, as on the statistics page.
    """
    of_recording = dict(read_columns(files, "recordings.csv", ("id", "lighting")))
    known = [(target, KNOWN[target].height, KNOWN[target].u) for target in get_args(Target)]
    names = (
        *("id", "recording_id", "lighting", "filmed_at", "direction", "category", "check_target"),
        *("model_chosen_by", *(name for _, *both in known for name in both)),
    )
    sets, counts = class_sets_in(files), counting_in(files)
    cars: dict[str, dict[str, Any]] = {}
    for row in read_columns(files, "vehicles.csv", names):
        of = dict(zip(names, row, strict=True))
        reference = is_reference(of["model_chosen_by"])
        cars[of["id"]] = {
            "lighting": of["lighting"] or of_recording.get(of["recording_id"]) or None,
            "filmed_hour": hour_filmed(of["filmed_at"]),
            "lane": of["direction"] or None,
            "category": of["category"] or None,
            "class_set": sets[of["category"]] if of["category"] else None,
            "by_size": not reference,
            "check_target": of["check_target"] == "true",
            "counts": counts[of["id"]],
            "known": {
                target: tuple(figure_of(of[name]) if reference else None for name in both)
                for target, *both in known
            },
        }
    return cars


def _day(at: str) -> int:
    """Days since 1970-01-01 of an ISO 8601 time, as it is written."""
    return day_of(date.fromisoformat(at[:10]))


def _groupings(files: Files, measured: Measured) -> dict[str, Grouping]:
    """By lighting, category, set and operator; a package is of one site."""
    people = {
        int(id_): undo_safe_text(name) for id_, name in read_columns(files, "people.csv", ("id", "name"))
    }
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
