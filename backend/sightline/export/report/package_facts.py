"""What the report of an export shows, read from the export's own files: so a check can draw it again."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from datetime import date, datetime
from itertools import islice
from typing import Any

from sightline.export.measured import AS_PAPER, PackageStatistics
from sightline.export.report.facts import (
    CalibrationFacts,
    Checksum,
    Exclusion,
    ExpectedHeight,
    InsetFacts,
    LensParameter,
    PoseFacts,
    RecordingFacts,
    ReportFacts,
)
from sightline.export.report.said import said, spoken
from sightline.export.report.scan_facts import scan_facts
from sightline.export.report.units import decimal
from sightline.export.report.words import STATES, selection_words
from sightline.export.response import response_in
from sightline.export.seal import ENTITY
from sightline.export.verdicts import verdicts_in
from sightline.geometry.documents import pose_from_dict
from sightline.infra.csv_package.columns import code_in
from sightline.infra.csv_package.files import (
    Files,
    number,
    read_columns,
    read_rows,
    read_whole,
    record_in,
    unsafe,
    whole,
)
from sightline.infra.csv_package.schema import Written
from sightline.messages.said import Said
from sightline.results.csv import selection_in
from sightline.results.survey_statistics import StatisticsOptions
from sightline.surveys.csv import place_in, sampling_in
from sightline.surveys.photographs.csv import photos_in
from sightline.vehicles.records import NOT_VISIBLE

MOST_EXCLUSIONS = 300
Words = Mapping[str, Any]


def report_facts(files: Files, made: PackageStatistics, written: Mapping[str, Written]) -> ReportFacts:
    """Everything that the report shows. `written`: the files whose sums it lists."""
    found = made.headline
    survey = survey_words(files)
    head = _Head(files)
    recordings = {row["id"]: row for row in read_rows(files, "recordings.csv")}
    lenses = {row["id"]: row for row in read_rows(files, "calibrations.csv")}
    cameras = {row["camera_id"]: unsafe(row["camera_name"]) for row in lenses.values()}
    used = _Measurements(files)
    hidden, stale = _not_visible(files), _out_of_date(files)
    exclusions = sum(1 for _ in read_columns(files, "exclusions.csv", ("measurement_id",)))
    return ReportFacts(
        survey=str(survey.get("name", "")),
        site=str(survey.get("site", "")),
        statistics=found,
        choices=StatisticsOptions(),
        as_in_the_paper=made.of[AS_PAPER],
        not_visible=hidden,
        out_of_date=stale,
        description=str(survey.get("description", "")),
        selection=selection_words(selection_in(files)),
        as_of=head.moment,
        first_day=used.first_day,
        last_day=used.last_day,
        counts=(
            (said("report-count-recordings"), len(recordings)),
            (said("report-count-vehicles"), sum(1 for _ in read_columns(files, "vehicles.csv", ("id",)))),
            (said("report-count-measurements"), used.count),
            (said("report-count-not-visible"), hidden),
            (said("report-count-used"), found.counted.measurements),
            (said("report-count-left-out"), exclusions),
            *_timeless(found.counted.without_time + made.scans.counted["without_time"]),
            *(((said("report-count-out-of-date"), stale),) if stale else ()),
            *_scanned(made),
        ),
        place=place_in(files),
        photos=photos_in(files),
        recordings=tuple(_recording(row, cameras) for row in recordings.values()),
        calibrations=tuple(
            _calibration(files, row) for row in lenses.values() if row["id"] in used.calibrations
        ),
        poses=tuple(
            _pose(files, row, recordings, lenses)
            for row in read_rows(files, "poses.csv")
            if row["id"] in used.poses
        ),
        insets=tuple(record_in(InsetFacts, row) for row in read_rows(files, "insets.csv")),
        exclusions=tuple(islice(_exclusions(files), MOST_EXCLUSIONS)),
        exclusions_total=exclusions,
        scans=scan_facts(files, made.scans),
        sampling=sampling_in(files),
        response=tuple(response_in(files)),
        verdicts=verdicts_in(files),
        code_versions=tuple(sorted(used.code_versions)),
        audit_events=head.count,
        audit_head=head.hash,
        language=spoken(),
        checksums=tuple(Checksum(path, written[path].sha256) for path in sorted(written)),
    )


def _not_visible(files: Files) -> int:
    """How many targets were answered by a reason why they cannot be seen."""
    return sum(
        sum(map(bool, row)) for row in read_columns(files, "vehicles.csv", tuple(NOT_VISIBLE.values()))
    )


def _out_of_date(files: Files) -> int:
    """Heights that follow from facts that hold no longer."""
    tables = ("measurements.csv", "line_heights.csv")
    return sum(bool(cell) for path in tables for (cell,) in read_columns(files, path, ("out_of_date",)))


def _timeless(count: int) -> tuple[tuple[str, int], ...]:
    """Vehicles left out because it is not known when they were filmed, where a package is of a time."""
    return ((said("report-count-without-time"), count),) if count else ()


def _scanned(made: PackageStatistics) -> tuple[tuple[str, int], ...]:
    """Scanned vehicles, where there are any."""
    counted = made.scans.counted
    return (
        (
            (said("report-count-scanned"), counted["vehicles"]),
            (said("report-count-scanned-used"), counted["used"]),
        )
        if counted["vehicles"]
        else ()
    )


def survey_words(files: Files) -> dict[str, Any]:
    """Name, site, description and insets of the survey, as its audit events made them."""
    words: dict[str, Any] = {}
    for entity, after in read_columns(files, "audit.csv", ("entity", "after")):
        if entity == "survey" and after:
            words |= json.loads(after)
    return words


class _Head:
    """The survey's last event in its chain; seals of packages are not about the survey."""

    def __init__(self, files: Files) -> None:
        self.count, self.hash = 0, ""
        self.moment: datetime | None = None
        names = ("number", "hash", "at", "entity")
        for event, hash_, at, entity in read_columns(files, "audit.csv", names):
            if entity != ENTITY:
                self.count, self.hash = int(event), hash_
                self.moment = datetime.fromisoformat(at)


class _Measurements:
    """What the report says of all measurements together."""

    def __init__(self, files: Files) -> None:
        days: set[str] = set()
        self.count = 0
        self.poses: Counter[str] = Counter()
        self.calibrations: Counter[str] = Counter()
        self.code_versions: Counter[str] = Counter()
        names = ("created_at", "pose_id", "calibration_id", "code_version", "withdrawn")
        for at, pose, calibration, code, _ in read_columns(files, "measurements.csv", names):
            self.count += 1
            days.add(at[:10])
            self.poses[pose] += 1
            self.calibrations[calibration] += 1
            self.code_versions[code] += 1
        self.first_day = date.fromisoformat(min(days)) if days else None
        self.last_day = date.fromisoformat(max(days)) if days else None


def _recording(row: Mapping[str, str], cameras: Mapping[str, str]) -> RecordingFacts:
    camera, frames = cameras.get(row["camera_id"], ""), whole(row["frame_count"])
    return record_in(RecordingFacts, row, camera=camera, frames=frames)


def _record(files: Files, kind: str, id_: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(read_whole(files, f"records/{kind}-{id_}.json"))
    return found


def _calibration(files: Files, row: Mapping[str, str]) -> CalibrationFacts:
    record = _record(files, "calibration", row["id"])
    document = record["document"]
    views = record.get("views") or document.get("views") or []
    return record_in(
        CalibrationFacts,
        row,
        camera=unsafe(row["camera_name"]),
        number=int(row["id"]),
        made_on=date.fromisoformat(row["created_at"][:10]),
        views_used=sum(1 for view in views if view.get("used")),
        views_given=len(views),
        parameters=tuple(_parameters(document)),
        warnings=tuple(Said.read(one) for one in record.get("warnings") or ()),
    )


def _parameters(document: Words) -> Iterator[LensParameter]:
    """The numbers of a lens with their u, in the order of the covariance."""
    names = ("fx_px", "fy_px", "cx_px", "cy_px")
    values = [float(document[name]) for name in names] + [float(one) for one in document["distortion"]]
    given = document.get("parameters") or ()
    covariance = document.get("covariance")
    for place, value in enumerate(values):
        variance = float(covariance[place][place]) if covariance and place < len(covariance) else -1.0
        u = variance**0.5 if variance >= 0.0 else None
        name = given[place] if place < len(given) else (*names, *(f"d{k}" for k in range(1, 15)))[place]
        yield LensParameter(str(name), value, u)


def _pose(
    files: Files,
    row: Mapping[str, str],
    recordings: Mapping[str, Mapping[str, str]],
    lenses: Mapping[str, Mapping[str, str]],
) -> PoseFacts:
    record = _record(files, "pose", row["id"])
    pose = pose_from_dict(record["document"], row["document"])
    lens = lenses.get(row["calibration_id"], {})
    board = None
    if row["board_columns"] and row["square_m"]:
        millimetres = 1000 * float(row["square_m"])
        square = decimal(f"{millimetres:g}")
        board = said("report-board-of", columns=row["board_columns"], rows=row["board_rows"], square=square)
    return record_in(
        PoseFacts,
        row,
        number=int(row["id"]),
        recording=unsafe(recordings.get(row["recording_id"], {}).get("name", "")),
        camera=unsafe(lens.get("camera_name", "")),
        calibration=int(row["calibration_id"]),
        camera_height_m=float(pose.centre_m[2]),
        board=board,
        distance_m=number(row["board_distance_m"]),
        expected=tuple(
            ExpectedHeight(float(one["distance_m"]), one["U95_height_m"])
            for one in record.get("expected") or ()
        ),
        warnings=tuple(Said.read(one) for one in record.get("warnings") or ()),
    )


def _exclusions(files: Files) -> Iterator[Exclusion]:
    for row in read_rows(files, "exclusions.csv"):
        yield Exclusion(
            measurement=int(row["measurement_id"]),
            vehicle=row["vehicle_number"],
            target=row["target"],
            state=STATES.get(row["state"], row["state"].replace("_", " ")),
            reason=code_in(row["reason_code"]) or unsafe(row["reason"]),
        )
