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
from sightline.results.survey_statistics import filter_measured, filter_of
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS, ItemOfLot
from sightline.reviews.lots.query import items_of_deleted_vehicles, list_lots
from sightline.reviews.lots.service import lots_with_items
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY
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

    def mark(self, measurement: Measurement) -> None:
        """Note the frames that were clicked on."""
        for n in (measurement.values.frame, *(more.frame for more in measurement.values.more_frames)):
            marks = self.marks.setdefault(measurement.recording_id, bytearray())
            if len(marks) <= n:
                marks.extend(bytes(n + 1 - len(marks)))
            marks[n] = 1

    def part(self, start: float, end: float, words: Said) -> Callable[[float], None]:
        """Progress of a part as progress of the whole."""
        return lambda fraction: self.tell(start + (end - start) * min(max(fraction, 0.0), 1.0), words)


def fill_survey(filling: Filling) -> None:
    """The survey with its insets, classes and sample."""
    survey = filling.survey
    filling.staging.fill(SURVEY, (survey,))
    filling.staging.fill(INSETS, sorted(survey.insets.items()))
    filling.staging.fill(CLASSES, survey.classes)
    filling.staging.fill(SAMPLING, (survey,))
    filling.staging.fill(QUOTAS, survey.sampling.quotas)


def fill_calibrations(filling: Filling) -> None:
    """Calibrations: as a table, as files for the command line, and as the audit chain knows them."""
    names = {camera.id: camera.name for camera in filling.of_survey(list_cameras)}
    lenses = filling.of_survey(list_calibrations)
    filling.staging.fill(CALIBRATIONS, (NamedCalibration(lens, names.get(lens.camera_id)) for lens in lenses))
    for lens in lenses:
        filling.staging.add(calibration_path(lens.id), json_bytes(lens.document))
    _records(filling.staging, "calibration", filling.of_survey(calibration_contents))


def fill_poses(filling: Filling) -> None:
    """Road poses, in the same three ways."""
    poses = filling.of_survey(list_whole_poses)
    filling.staging.fill(POSES, poses)
    for pose in poses:
        filling.staging.add(pose_path(pose.id), json_bytes(pose.document))
    _records(filling.staging, "pose", filling.of_survey(pose_contents))


def _records(staging: Staging, kind: str, contents: Mapping[int, object]) -> None:
    for row_id, content in contents.items():
        staging.add(record_path(kind, row_id), json_bytes(content))


def fill_measurements(filling: Filling) -> None:
    """Everything that is told of measurements and repeats, in one pass over the revisions."""
    tick = filling.part(0.0, 0.35, Said("job-export-measurements"))
    done = 0
    stale = filling.of_survey(measurements_out_of_date).measurements
    measured = load_measured_columns(filling.session, [filling.survey.id])
    evaluated, _ = filter_measured(measured, filter_of(filling.selection))
    with ExitStack() as stack:
        out = _Writers(filling.staging, stack, filling.most, set(evaluated.measurement_id.tolist()))
        for page in filling.of_survey(revision_pages):
            current: list[Measurement] = []
            for _, group in groupby(page, key=lambda pair: pair[0].id):
                revisions = list(group)
                done += 1
                for one, _ in revisions:
                    filling.mark(one)
                newest, car = revisions[-1]
                if newest.repeat_of is not None:
                    out.repeats.add(replace(newest, out_of_date=stale.get(newest.id, ())))
                    continue
                out.measurement([one for one, _ in revisions], car, stale.get(newest.id, ()))
                filling.measurements += 1
                if not newest.withdrawn:
                    current.append(newest)
            if filling.with_crops:
                filling.spots.append(spots_of(current))
            tick(done / max(filling.count, 1))


class _Writers:
    """The open files of all tables that a pass over the measurements fills."""

    def __init__(self, staging: Staging, stack: ExitStack, most: int, evaluated: Set[int]) -> None:
        self._staging, self._stack, self._evaluated = staging, stack, evaluated
        self._clicks_table = clicks_with_frames(most)
        self._current = self._open_writer(with_frames(MEASUREMENTS, most))
        self._all = self._open_writer(with_frames(REVISIONS, most))
        self._budget, self._clicks = self._open_writer(BUDGET), self._open_writer(self._clicks_table)
        self._of_poses: dict[int, TableWriter[Clicked]] = {}
        self.repeats = self._open_writer(REPEATS)

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
            self._of_poses[pose_id] = self._open_writer(self._clicks_table, clicks_path(pose_id))
        return self._of_poses[pose_id]

    def _open_writer(self, table: Table[Record], path: str | None = None) -> TableWriter[Record]:
        return self._stack.enter_context(self._staging.table(table, path))


def fill_vehicles(filling: Filling) -> None:
    """Vehicles, and what the catalogue says of their models."""
    filling.tell(0.35, Said("job-export-vehicles"))
    with filling.staging.table(VEHICLES) as table:
        for page in filling.of_survey(vehicle_pages):
            for vehicle in page:
                table.add(vehicle)
                if vehicle.make and vehicle.model:
                    filling.models.add((vehicle.make, vehicle.model))
        filling.vehicles = table.rows
    filling.staging.fill(CATALOGUE, catalogue_of_models(filling.session, filling.models))


def fill_lots(filling: Filling) -> None:
    """Lots with their items; those of deleted vehicles are in no table."""
    lots = filling.of_survey(list_lots)
    filling.staging.fill(LOTS, lots)
    gone = filling.of_survey(items_of_deleted_vehicles)
    filling.staging.fill(
        LOT_ITEMS,
        (
            ItemOfLot(lot, item)
            for lot, items in lots_with_items(filling.session, lots)
            for item in items
            if item.measurement_id not in gone
        ),
    )


def frames_clicked_on(found: Filling) -> Iterator[ClickedFrame]:
    """Every frame that was clicked on, once, as the frame table has it."""
    for recording_id in sorted(found.marks):
        marked = np.flatnonzero(np.frombuffer(found.marks[recording_id], np.uint8))
        yield from clicked_frames(recording_id, get_frame_table(found.session, recording_id), marked)


def fill_photographs(filling: Filling) -> None:
    """Photographs of the set-up, with their pictures."""
    photographs = filling.of_survey(list_photographs)
    for one in photographs:
        filling.staging.add(photograph_path(one.id), photograph_content(filling.services, one))
    filling.staging.fill(PHOTOGRAPHS, enumerate(photographs, start=1))


def fill_audit(filling: Filling) -> None:
    """The survey's chain, without the seal."""
    with filling.staging.table(AUDIT) as table:
        filling.events = table
        for page in filling.of_survey(audit_pages):
            for event in page:
                table.add(event)
                filling.as_of = event["number"]
                if event["entity"] != ENTITY:
                    filling.moment = stamp(event["at"])
                if event["actor_id"] is not None:
                    filling.staging.named.add(str(event["actor_id"]))


def people_named(found: Filling) -> Iterator[Who]:
    """Who stands in the tables before, or did what the chain tells."""
    ids = sorted(int(one) for one in found.staging.named if one)
    known = names(found.session, ids)
    return (Who(id_, known.get(id_, "")) for id_ in ids)


def fill_crops(filling: Filling) -> None:
    """Pictures of the vehicles that the package is of."""
    tick = filling.part(0.45, 0.75, Said("job-export-crops"))
    spots = [page for page in filling.spots if len(page)]
    if spots and not filling.selection.is_all:
        chosen = np.array([int(one) for one in chosen_vehicles(filling.staging.files()).of], dtype=np.int64)
        spots = [kept for page in spots if len(kept := page[np.isin(page["vehicle"], chosen)])]
    if spots:
        filling.crops = take_crops(filling.staging, filling.services, np.concatenate(spots), tick)
    else:
        filling.staging.fill(CROPS, ())


def fill_statistics(found: Filling) -> None:
    """What follows from the tables: exclusions, response, statistics."""
    found.statistics = derive_tables(found.staging)
    found.part(0.75, 1.0, Said("job-export-figures"))(0.5)
