"""Filling the tables of an export, each in one pass over what is stored; `package_tables.py` has the order.

Rows are written as they are read; what is held is a page of rows, one byte for each frame of each video, and
what statistics need of a measurement (some 100 bytes).
"""

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import TypeVar

import numpy as np

from sightline.cameras.calibrations.csv import CALIBRATIONS, NamedCalibration, calibration_path
from sightline.cameras.calibrations.store import list_calibrations
from sightline.cameras.store import list_cameras
from sightline.enums import ComputingCause
from sightline.export.chosen import chosen_vehicles
from sightline.export.crops import CROPS, Spots, spots_of, take_crops
from sightline.export.derived import derive_tables
from sightline.export.measured import PackageStatistics
from sightline.export.query import (
    audit_pages,
    calibration_contents,
    pose_contents,
    revision_pages,
    vehicle_pages,
)
from sightline.export.seal import ENTITY
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Staging, TableWriter
from sightline.infra.csv_package.schema import Row, Table, json_bytes, record_path
from sightline.infra.database import Session
from sightline.infra.database.rows import names
from sightline.infra.services import Services
from sightline.measurements.again.service import measurements_out_of_date
from sightline.measurements.csv import (
    BUDGET,
    MEASUREMENTS,
    REVISIONS,
    Clicked,
    OfVehicle,
    budget_entries,
    clicks_path,
    clicks_with_frames,
    with_frames,
)
from sightline.measurements.records import Measurement, revision_of_clicks
from sightline.measurements.sheets.csv import VEHICLES
from sightline.messages.said import Said
from sightline.poses.csv import POSES, pose_path
from sightline.poses.store import list_whole_poses
from sightline.quality.repeats.csv import REPEATS
from sightline.recordings.frames.csv import ClickedFrame, clicked_frames
from sightline.recordings.frames.store import get_frame_table
from sightline.results.measured_columns_query import load_measured_columns
from sightline.results.selection import Selection
from sightline.results.survey_statistics import filter_of, filtered
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS, ItemOfLot
from sightline.reviews.lots.query import items_of_deleted_vehicles, list_lots
from sightline.reviews.lots.service import lots_with_items
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY, insets_in_force
from sightline.surveys.photographs.csv import PHOTOGRAPHS, photograph_path
from sightline.surveys.photographs.service import photograph_content
from sightline.surveys.photographs.store import list_photographs
from sightline.surveys.records import Survey
from sightline.vehicles.catalogue.csv import CATALOGUE
from sightline.vehicles.catalogue.store import catalogue_of_models

Record = TypeVar("Record")
Found = TypeVar("Found")
Tell = Callable[[float, Said], None]


@dataclass(eq=False)
class Filling:
    """What the tables of a package are filled from, and what is gathered on the way: frames clicked on,
    places to crop, models of vehicles, the survey's chain as written so far.

    `most`: as many frames as a measurement has at most; `count`: how many measurements there are.
    """

    staging: Staging
    session: Session
    survey: Survey
    services: Services
    tell: Tell
    selection: Selection
    most: int
    count: int
    with_crops: bool
    marks: dict[int, bytearray] = field(default_factory=dict)
    spots: list[Spots] = field(default_factory=list)
    models: set[tuple[str, str]] = field(default_factory=set)
    measurements: int = 0
    vehicles: int = 0
    crops: int = 0
    events: TableWriter[Row] = field(init=False)
    as_of: int = 0
    moment: str | None = None
    statistics: PackageStatistics = field(init=False)

    def of_survey(self, read: Callable[[Session, int], Found]) -> Found:
        """What a store has of the survey."""
        return read(self.session, self.survey.id)

    def mark(self, one: Measurement) -> None:
        """Note the frames that were clicked on."""
        for n in (one.values.frame, *(more.frame for more in one.values.more_frames)):
            marks = self.marks.setdefault(one.recording_id, bytearray())
            if len(marks) <= n:
                marks.extend(bytes(n + 1 - len(marks)))
            marks[n] = 1

    def part(self, start: float, end: float, words: Said) -> Callable[[float], None]:
        """Progress of a part as progress of the whole."""
        return lambda fraction: self.tell(start + (end - start) * min(max(fraction, 0.0), 1.0), words)


def fill_survey(found: Filling) -> None:
    """The survey with its insets, classes and sample."""
    survey = found.survey
    found.staging.fill(SURVEY, (survey,))
    found.staging.fill(INSETS, insets_in_force(survey))
    found.staging.fill(CLASSES, survey.classes)
    found.staging.fill(SAMPLING, (survey,))
    found.staging.fill(QUOTAS, survey.sampling.quotas)


def fill_calibrations(found: Filling) -> None:
    """Calibrations: as a table, as files for the command line, and as the audit chain knows them."""
    names = {camera.id: camera.name for camera in found.of_survey(list_cameras)}
    lenses = found.of_survey(list_calibrations)
    found.staging.fill(CALIBRATIONS, (NamedCalibration(lens, names.get(lens.camera_id)) for lens in lenses))
    for lens in lenses:
        found.staging.add(calibration_path(lens.id), json_bytes(lens.document))
    _records(found.staging, "calibration", found.of_survey(calibration_contents))


def fill_poses(found: Filling) -> None:
    """Road poses, in the same three ways."""
    poses = found.of_survey(list_whole_poses)
    found.staging.fill(POSES, poses)
    for pose in poses:
        found.staging.add(pose_path(pose.id), json_bytes(pose.document))
    _records(found.staging, "pose", found.of_survey(pose_contents))


def _records(staging: Staging, kind: str, contents: Mapping[int, object]) -> None:
    for row_id, content in contents.items():
        staging.add(record_path(kind, row_id), json_bytes(content))


def fill_measurements(found: Filling) -> None:
    """Everything that is told of measurements and repeats, in one pass over the revisions."""
    tick = found.part(0.0, 0.35, Said("job-export-measurements"))
    done = 0
    stale = found.of_survey(measurements_out_of_date).measurements
    measured = load_measured_columns(found.session, [found.survey.id])
    evaluated, _ = filtered(measured, filter_of(found.selection))
    with ExitStack() as stack:
        out = _Writers(found.staging, stack, found.most, set(evaluated.measurement_id.tolist()))
        for page in found.of_survey(revision_pages):
            current: list[Measurement] = []
            for _, group in groupby(page, key=lambda pair: pair[0].id):
                revisions = list(group)
                done += 1
                for one, _ in revisions:
                    found.mark(one)
                newest, car = revisions[-1]
                if newest.repeat_of is not None:
                    out.repeats.add(replace(newest, out_of_date=stale.get(newest.id, ())))
                    continue
                out.measurement([one for one, _ in revisions], car, stale.get(newest.id, ()))
                found.measurements += 1
                if not newest.withdrawn:
                    current.append(newest)
            if found.with_crops:
                found.spots.append(spots_of(current))
            tick(done / max(found.count, 1))


class _Writers:
    """The open files of all tables that a pass over the measurements fills."""

    def __init__(self, staging: Staging, stack: ExitStack, most: int, evaluated: Set[int]) -> None:
        self._staging, self._stack, self._evaluated = staging, stack, evaluated
        self._clicks_table = clicks_with_frames(most)
        self._current = self._opened(with_frames(MEASUREMENTS, most))
        self._all = self._opened(with_frames(REVISIONS, most))
        self._budget, self._clicks = self._opened(BUDGET), self._opened(self._clicks_table)
        self._of_poses: dict[int, TableWriter[Clicked]] = {}
        self.repeats = self._opened(REPEATS)

    def measurement(
        self, revisions: Sequence[Measurement], car: OfVehicle, out_of_date: tuple[ComputingCause, ...]
    ) -> None:
        """One measurement with all its revisions, the newest last, and why that is out of date."""
        for one in revisions:
            self._all.add(one)
        newest = revisions[-1]
        clicking = revision_of_clicks(revisions, newest)
        self._current.add(
            replace(
                newest,
                out_of_date=out_of_date,
                operator=clicking.created_by,
                clicked_at=clicking.created_at,
            )
        )
        for entry in budget_entries(newest):
            self._budget.add(entry)
        if not newest.withdrawn:
            clicked = Clicked(newest, car, newest.id in self._evaluated)
            self._clicks.add(clicked)
            self._of_pose(newest.values.pose_id).add(clicked)

    def _of_pose(self, pose_id: int) -> TableWriter[Clicked]:
        if pose_id not in self._of_poses:
            self._of_poses[pose_id] = self._opened(self._clicks_table, clicks_path(pose_id))
        return self._of_poses[pose_id]

    def _opened(self, table: Table[Record], path: str | None = None) -> TableWriter[Record]:
        return self._stack.enter_context(self._staging.table(table, path))


def fill_vehicles(found: Filling) -> None:
    """Vehicles, and what the catalogue says of their models."""
    found.tell(0.35, Said("job-export-vehicles"))
    with found.staging.table(VEHICLES) as table:
        for page in found.of_survey(vehicle_pages):
            for vehicle in page:
                table.add(vehicle)
                if vehicle.make and vehicle.model:
                    found.models.add((vehicle.make, vehicle.model))
        found.vehicles = table.rows
    found.staging.fill(CATALOGUE, catalogue_of_models(found.session, found.models))


def fill_lots(found: Filling) -> None:
    """Lots with their items; those of deleted vehicles are in no table."""
    lots = found.of_survey(list_lots)
    found.staging.fill(LOTS, lots)
    gone = found.of_survey(items_of_deleted_vehicles)
    found.staging.fill(
        LOT_ITEMS,
        (
            ItemOfLot(lot, item)
            for lot, items in lots_with_items(found.session, lots)
            for item in items
            if item.measurement_id not in gone
        ),
    )


def frames_clicked_on(found: Filling) -> Iterator[ClickedFrame]:
    """Every frame that was clicked on, once, as the frame table has it."""
    for recording_id in sorted(found.marks):
        marked = np.flatnonzero(np.frombuffer(found.marks[recording_id], np.uint8))
        yield from clicked_frames(recording_id, get_frame_table(found.session, recording_id), marked)


def fill_photographs(found: Filling) -> None:
    """Photographs of the set-up, with their pictures."""
    photographs = found.of_survey(list_photographs)
    for one in photographs:
        found.staging.add(photograph_path(one.id), photograph_content(found.services, one))
    found.staging.fill(PHOTOGRAPHS, enumerate(photographs, start=1))


def fill_audit(found: Filling) -> None:
    """The survey's chain, without the seal."""
    with found.staging.table(AUDIT) as table:
        found.events = table
        for page in found.of_survey(audit_pages):
            for event in page:
                table.add(event)
                found.as_of = event["number"]
                if event["entity"] != ENTITY:
                    found.moment = stamp(event["at"])
                if event["actor_id"] is not None:
                    found.staging.named.add(str(event["actor_id"]))


def people_named(found: Filling) -> Iterator[Who]:
    """Who stands in the tables before, or did what the chain tells."""
    ids = sorted(int(one) for one in found.staging.named if one)
    known = names(found.session, ids)
    return (Who(id_, known.get(id_, "")) for id_ in ids)


def fill_crops(found: Filling) -> None:
    """Pictures of the vehicles that the package is of."""
    tick = found.part(0.45, 0.75, Said("job-export-crops"))
    spots = [page for page in found.spots if len(page)]
    if spots and not found.selection.is_all:
        chosen = np.array([int(one) for one in chosen_vehicles(found.staging.files()).of], dtype=np.int64)
        spots = [kept for page in spots if len(kept := page[np.isin(page["vehicle"], chosen)])]
    if spots:
        found.crops = take_crops(found.staging, found.services, np.concatenate(spots), tick)
    else:
        found.staging.fill(CROPS, ())


def fill_statistics(found: Filling) -> None:
    """What follows from the tables: exclusions, response, statistics."""
    found.statistics = derive_tables(found.staging)
    found.part(0.75, 1.0, Said("job-export-figures"))(0.5)
