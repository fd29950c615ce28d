"""What the report of an export shows, read from the export's own files: so a check can draw it again."""

import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from datetime import date, datetime
from itertools import islice
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS
from sightline.export.chosen import chosen_scanned, chosen_vehicles, counting_vehicles, is_accepted
from sightline.export.exclusions import EXCLUSIONS
from sightline.export.measured import AS_PAPER, PackageStatistics
from sightline.export.report.facts import ReportFacts, Row, ScanFacts
from sightline.export.report.said import sentence_of_key, spoken_language
from sightline.export.report.words import selection_words
from sightline.export.response import response_in
from sightline.export.scans import scan_heights_in
from sightline.export.seal import ENTITY
from sightline.export.verdicts import verdicts_in
from sightline.geometry.documents import pose_from_dict
from sightline.infra.csv_package.files import Files, read_columns, read_rows, read_whole, undo_safe_text
from sightline.infra.csv_package.schema import AnyTable, Written, record_path
from sightline.messages.said import Said
from sightline.poses.csv import POSES
from sightline.recordings.csv import RECORDINGS
from sightline.results.csv import selection_in
from sightline.results.survey_statistics import StatisticsOptions
from sightline.scans.csv import LINE_SCANS
from sightline.scans.heights.csv import LINE_HEIGHTS
from sightline.scans.statistics.service import ScanStatistics
from sightline.surveys.csv import INSETS, place_in, sampling_in
from sightline.surveys.photographs.csv import photos_in
from sightline.vehicles.records import NOT_VISIBLE

MOST_EXCLUSIONS = 300


def report_facts(files: Files, package: PackageStatistics, written: Mapping[str, Written]) -> ReportFacts:
    """Everything that the report shows. `written`: the files whose sums it lists."""
    headline = package.headline
    head = _Chain(files)
    survey = head.survey
    recordings = {row["id"]: row for row in table_rows(files, RECORDINGS)}
    lenses = {row["id"]: row for row in table_rows(files, CALIBRATIONS)}
    cameras = {row["camera_id"]: row["camera_name"] for row in lenses.values()}
    used = _Measurements(files)
    hidden, stale = _not_visible(files), _out_of_date(files)
    exclusions = sum(1 for _ in read_columns(files, "exclusions.csv", ("measurement_id",)))
    return ReportFacts(
        survey=str(survey.get("name", "")),
        site=str(survey.get("site", "")),
        statistics=headline,
        choices=StatisticsOptions(),
        as_in_the_paper=package.of[AS_PAPER],
        not_visible=hidden,
        out_of_date=stale,
        description=str(survey.get("description", "")),
        selection=selection_words(selection_in(files)),
        as_of=head.moment,
        first_day=used.first_day,
        last_day=used.last_day,
        counts=(
            (sentence_of_key("report-count-recordings"), len(recordings)),
            (
                sentence_of_key("report-count-vehicles"),
                sum(1 for _ in read_columns(files, "vehicles.csv", ("id",))),
            ),
            (sentence_of_key("report-count-measurements"), used.count),
            (sentence_of_key("report-count-not-visible"), hidden),
            (sentence_of_key("report-count-used"), headline.counted.measurements),
            (sentence_of_key("report-count-left-out"), exclusions),
            *_timeless(headline.counted.without_time + package.scans.counted["without_time"]),
            *(((sentence_of_key("report-count-out-of-date"), stale),) if stale else ()),
            *_scanned(package),
        ),
        place=place_in(files),
        photos=photos_in(files),
        recordings=tuple({**row, "camera": cameras.get(row["camera_id"])} for row in recordings.values()),
        calibrations=tuple(
            _calibration(files, row) for row in lenses.values() if str(row["id"]) in used.calibrations
        ),
        poses=tuple(
            _pose(files, row, recordings, lenses)
            for row in table_rows(files, POSES)
            if str(row["id"]) in used.poses
        ),
        insets=tuple(table_rows(files, INSETS)),
        exclusions=tuple(islice(table_rows(files, EXCLUSIONS), MOST_EXCLUSIONS)),
        exclusions_total=exclusions,
        scans=_scans(files, package.scans),
        sampling=sampling_in(files),
        response=tuple(response_in(files)),
        verdicts=verdicts_in(files),
        code_versions=tuple(sorted(used.code_versions)),
        audit_events=head.count,
        audit_head=head.hash,
        language=spoken_language(),
        checksums={path: written[path].sha256 for path in sorted(written)},
    )


def _not_visible(files: Files) -> int:
    """How many targets of the vehicles that count were answered by a reason why they cannot be seen."""
    counting = counting_vehicles(files)
    rows = read_columns(files, "vehicles.csv", ("id", *NOT_VISIBLE.values()))
    return sum(sum(map(bool, reasons)) for id_, *reasons in rows if id_ in counting)


def _out_of_date(files: Files) -> int:
    """Heights in the results that follow from facts that hold no longer."""
    tables = (("measurements.csv", counting_vehicles(files)), (LINE_HEIGHTS.key, chosen_scanned(files).of))
    names = ("vehicle_id", "withdrawn", "status", "verdict", "out_of_date")
    return sum(
        vehicle in counting and is_accepted(*cells) and stale != ""  # of an earlier revision it is empty
        for path, counting in tables
        for vehicle, *cells, stale in read_columns(files, path, names)
    )


def _timeless(count: int) -> tuple[tuple[str, int], ...]:
    """Vehicles left out because it is not known when they were filmed, where a package is of a time."""
    return ((sentence_of_key("report-count-without-time"), count),) if count else ()


def _scanned(made: PackageStatistics) -> tuple[tuple[str, int], ...]:
    """Scanned vehicles, where there are any."""
    counted = made.scans.counted
    return (
        (
            (sentence_of_key("report-count-scanned"), counted["vehicles"]),
            (sentence_of_key("report-count-scanned-used"), counted["used"]),
        )
        if counted["vehicles"]
        else ()
    )


class _Chain:
    """The survey's last event in its chain, for seals of packages are not about the survey; its name, site,
    description and insets, as its events made them.
    """

    def __init__(self, files: Files) -> None:
        self.survey: dict[str, Any] = {}
        last = ("0", "", "")
        names = ("number", "hash", "at", "entity", "after")
        for number, hash_, at, entity, after in read_columns(files, "audit.csv", names):
            if entity != ENTITY:
                last = (number, hash_, at)
            if entity == "survey" and after:
                self.survey |= json.loads(after)
        self.count, self.hash = int(last[0]), last[1]
        self.moment = datetime.fromisoformat(last[2]) if last[2] else None


class _Measurements:
    """What the report says of the measurements of the vehicles that its figures are of; `count`: of all."""

    def __init__(self, files: Files) -> None:
        days: set[str] = set()
        self.count = 0
        self.poses: Counter[str] = Counter()
        self.calibrations: Counter[str] = Counter()
        self.code_versions: Counter[str] = Counter()
        chosen = chosen_vehicles(files).of
        names = ("vehicle_id", "clicked_at", "created_at", "pose_id", "calibration_id", "code_version")
        for vehicle, clicked, made, pose, calibration, code in read_columns(files, "measurements.csv", names):
            self.count += 1
            if vehicle not in chosen:
                continue
            days.add((clicked or made)[:10])
            self.poses[pose] += 1
            self.calibrations[calibration] += 1
            self.code_versions[code] += 1
        self.first_day = date.fromisoformat(min(days)) if days else None
        self.last_day = date.fromisoformat(max(days)) if days else None


def table_rows(files: Files, table: AnyTable) -> Iterator[dict[str, Any]]:
    """The rows of a table by its columns, each cell as what the column holds; None where it is empty.

    Raises Damaged, and ValueError for a cell that is nothing of the kind.
    """
    for row in read_rows(files, table.path):
        yield {
            column.name: _READERS[column.type](row[column.name]) if row[column.name] else None
            for column in table.columns
        }


_READERS: dict[str, Callable[[str], Any]] = {
    "string": undo_safe_text,
    "integer": int,
    "number": float,
    "boolean": lambda cell: cell == "true",
    "datetime": datetime.fromisoformat,
}


def _record(files: Files, kind: str, id_: int) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(read_whole(files, record_path(kind, id_)))
    return found


def _calibration(files: Files, row: Row) -> Row:
    """The row with how many views were given and used, the lens by its parameters, and what was warned of."""
    record = _record(files, "calibration", row["id"])
    document = record["document"]
    views = record.get("views") or document.get("views") or []
    return {
        **row,
        "views_used": sum(1 for view in views if view.get("used")),
        "views_given": len(views),
        "parameters": tuple(_parameters(document)),
        "warnings": _warnings(record),
    }


def _warnings(record: Row) -> tuple[Said, ...]:
    return tuple(Said.read(one) for one in record.get("warnings") or ())


def _parameters(document: Row) -> Iterator[Row]:
    """The numbers of a lens with their u, None where it is not known, in the order of the covariance."""
    names = ("fx_px", "fy_px", "cx_px", "cy_px")
    values = [float(document[name]) for name in names] + [float(one) for one in document["distortion"]]
    given = document.get("parameters") or ()
    covariance = document.get("covariance")
    for place, value in enumerate(values):
        variance = float(covariance[place][place]) if covariance and place < len(covariance) else -1.0
        name = given[place] if place < len(given) else (*names, *(f"d{k}" for k in range(1, 15)))[place]
        yield {"name": str(name), "value": value, "u": variance**0.5 if variance >= 0.0 else None}


def _pose(files: Files, row: Row, recordings: Mapping[int, Row], lenses: Mapping[int, Row]) -> Row:
    """The row with the names of recording and camera, the camera's height, the U95 that is expected of a
    height by distance (None where the picture shows no road there), and what was warned of.
    """
    record = _record(files, "pose", row["id"])
    pose = pose_from_dict(record["document"], row["document"])
    return {
        **row,
        "first_frame": row["first_frame"] or 0,
        "last_frame": row["last_frame"] or 0,
        "recording": recordings.get(row["recording_id"], {}).get("name"),
        "camera": lenses.get(row["calibration_id"], {}).get("camera_name"),
        "camera_height_m": float(pose.centre_m[2]),
        "expected": [
            {"distance_m": float(one["distance_m"]), "U95_height_m": _number(one["U95_height_m"])}
            for one in record.get("expected") or ()
        ],
        "warnings": _warnings(record),
    }


def _scans(files: Files, statistics: ScanStatistics) -> ScanFacts | None:
    """Rigs and statistics of the line scans; None where the survey has none."""
    rigs = tuple(rig for row in table_rows(files, LINE_SCANS) for rig in _rigs(row))
    if not rigs:
        return None
    names, chosen = ("id", "method", "status", "verdict"), chosen_scanned(files).of
    used = Counter(
        method
        for id_, method, status, verdict in read_columns(files, "scan_vehicles.csv", names)
        if (status, verdict) == ("ok", "accepted") and id_ in chosen
    )
    return ScanFacts(rigs, statistics, tuple(sorted(used.items())), scan_heights_in(files))


def _number(value: Any) -> float | None:
    return None if value is None else float(value)


def _rigs(row: Row) -> list[Row]:
    """The rig of a line scan; one that has lanes is one line for each."""
    lanes = json.loads(row["lanes"] or "[]")
    return [
        {**row, "name": f"{row['name']}, {one['name']}", "distance_m": one["distance_m"]} for one in lanes
    ] or [row]
