"""Building an export: one pass over each stored table, then what is made of the tables written.

Rows are written as they are read; what is held is a page of rows, one byte for each frame of each video, and
what statistics need of a measurement (some 100 bytes).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import TypeVar

import numpy as np

from sightline.cameras.calibrations.csv import CALIBRATIONS, NamedCalibration, calibration_path
from sightline.cameras.calibrations.store import list_calibrations
from sightline.cameras.csv import CAMERAS
from sightline.cameras.store import list_cameras
from sightline.enums import ComputingCause
from sightline.export.chosen import chosen_vehicles
from sightline.export.contents import about_of, described, tables_of
from sightline.export.crops import CROPS, Spots, spots_of, take_crops
from sightline.export.derived import derive
from sightline.export.page import write_audit_script, write_page
from sightline.export.query import (
    audit_pages,
    calibration_contents,
    count_measurements,
    most_frames,
    pose_contents,
    review_pages,
    revision_pages,
    vehicle_pages,
)
from sightline.export.report.words import selection_words
from sightline.export.seal import CHECKPOINT, ENTITY, sealed
from sightline.export.store import seal_package
from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import checkpoint_of_chain, sign_checkpoint
from sightline.infra.audit.records import AuditHead, Who, survey_chain
from sightline.infra.audit.signing import signing_key
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Staging, TableWriter
from sightline.infra.csv_package.parquet import write_parquet
from sightline.infra.csv_package.schema import DESCRIPTION, Row, Table, json_bytes, record_path
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.measurements.again.csv import COMPUTINGS
from sightline.measurements.again.query import list_computings
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
from sightline.measurements.records import Measurement
from sightline.measurements.sheets.csv import VEHICLES
from sightline.media.store.local import check_room
from sightline.messages import SOURCE
from sightline.people.csv import PEOPLE
from sightline.poses.csv import POSES, pose_path
from sightline.poses.store import list_whole_poses
from sightline.quality.checks.csv import WHEEL_PAIRS
from sightline.quality.checks.store import list_wheel_pairs
from sightline.quality.repeats.csv import REPEATS
from sightline.recordings.csv import RECORDINGS
from sightline.recordings.csv import described as described_recording
from sightline.recordings.frames.csv import FRAMES, ClickedFrame, clicked_frames
from sightline.recordings.frames.store import get_frame_table
from sightline.recordings.store import list_recordings
from sightline.results.csv import SELECTION, STANDARDS, selection_rows
from sightline.results.selection import Selection
from sightline.results.standards_store import get_standards
from sightline.reviews.csv import REVIEWS
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS, ItemOfLot
from sightline.reviews.lots.query import items_of_deleted_vehicles, list_lots
from sightline.reviews.lots.service import lots_with_items
from sightline.scans.csv import fill_scans
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY, insets_in_force
from sightline.surveys.photographs.csv import PHOTOGRAPHS, photograph_path
from sightline.surveys.photographs.service import photograph_content
from sightline.surveys.photographs.store import list_photographs
from sightline.surveys.records import Survey
from sightline.surveys.store import get_survey
from sightline.vehicles.catalogue.csv import CATALOGUE
from sightline.vehicles.catalogue.store import catalogue_of_models

Record = TypeVar("Record")
Tell = Callable[[float, str], None]
# Of one measurement with its revisions, budget and audit events, uncompressed; of one crop.
_ROW_BYTES, _CROP_BYTES = 6_000, 60_000


def silent(_fraction: float, _words: str) -> None:
    """Progress that nobody follows."""


@dataclass(frozen=True)
class Built:
    """What was written; `head` is the end of the audit chain that the package carries."""

    head: AuditHead
    measurements: int
    vehicles: int
    crops: int


@dataclass(eq=False)
class _Seen:
    """What is gathered on the way: people named, frames clicked on, places to crop, models of vehicles."""

    people: dict[int, str] = field(default_factory=dict)
    marks: dict[int, bytearray] = field(default_factory=dict)
    spots: list[Spots] = field(default_factory=list)
    crops: bool = False
    models: set[tuple[str, str]] = field(default_factory=set)
    measurements: int = 0
    vehicles: int = 0

    def name(self, person: Who | None) -> None:
        if person is not None:
            self.people[person.id] = person.name

    def mark(self, one: Measurement) -> None:
        for n in (one.values.frame, *(more.frame for more in one.values.more_frames)):
            marks = self.marks.setdefault(one.recording_id, bytearray())
            if len(marks) <= n:
                marks.extend(bytes(n + 1 - len(marks)))
            marks[n] = 1


def build(
    staging: Staging,
    session: Session,
    survey_id: int,
    services: Services,
    tell: Tell = silent,
    *,
    crops: bool = True,
    selection: Selection = Selection(),
    language: str = SOURCE,
    actor: int | None = None,
) -> Built:
    """Write the whole package of a survey, as one transaction sees it, and seal it in the audit chain.

    Its tables are of the whole survey, statistics, figures and report of `selection`, the last
    two in `language`.

    `services` give photographs and, with `crops`, the pictures that were clicked on. Raises NotFound, NoRoom,
    Damaged for a photograph that is gone, and whatever `tell` raises to stop.
    """
    survey = get_survey(session, survey_id)
    count = count_measurements(session, survey_id)
    needed = count * (_ROW_BYTES + (_CROP_BYTES if crops else 0))
    check_room(staging.folder, needed, "this export")
    most = most_frames(session, survey_id)
    seen = _Seen(crops=crops)
    _measurements(
        staging, session, survey_id, most, seen, _part(tell, 0.0, 0.35, "Writing the measurements."), count
    )
    tell(0.35, "Writing vehicles, reviews and the audit chain.")
    _small_tables(staging, session, survey, seen)
    _photographs(staging, session, survey_id, services, seen)
    audit = _audit(staging, session, survey_id, seen)
    staging.fill(PEOPLE, (Who(id_, name) for id_, name in sorted(seen.people.items())))
    staging.fill(SELECTION, selection_rows(selection))
    tick = _part(tell, 0.45, 0.75, "Cutting out the pictures of each click.")
    taken = _crops(staging, services, seen, selection, tick)
    tick = _part(tell, 0.75, 1.0, "Computing statistics, drawing figures and the report.")
    derive(staging, language, tick)
    about = about_of(survey.name, survey.site, survey.description, audit.moment, selection_words(selection))
    tables = tables_of(most)
    write_parquet(staging, tables)
    write_page(staging, tables, language)
    staging.add(DESCRIPTION, json_bytes(described(about, language, tables, staging.written)))
    key = signing_key(services.settings)
    ends = {name: one for name, one in trail.heads(session).items() if name in ("people", "catalogue")}
    with services.writing() as writing:
        head = _seal(staging, writing, survey_id, audit, ends, actor)
        signed = sign_checkpoint(writing, key, actor=actor)
        chain = survey_chain(survey_id)
        staging.add(CHECKPOINT, json_bytes(checkpoint_of_chain(writing, signed, chain)))
    write_audit_script(staging)
    staging.add_checksums()
    return Built(head, seen.measurements, seen.vehicles, taken)


def _part(tell: Tell, start: float, end: float, words: str) -> Callable[[float], None]:
    """Progress of a part as progress of the whole."""
    return lambda fraction: tell(start + (end - start) * min(max(fraction, 0.0), 1.0), words)


def _measurements(
    staging: Staging,
    session: Session,
    survey_id: int,
    most: int,
    seen: _Seen,
    tick: Callable[[float], None],
    count: int,
) -> None:
    """Everything that is told of measurements, in one pass over the revisions."""
    done = 0
    stale = measurements_out_of_date(session, survey_id).measurements
    with ExitStack() as stack:
        out = _Writers(staging, stack, most)
        for page in revision_pages(session, survey_id):
            current: list[Measurement] = []
            for _, group in groupby(page, key=lambda pair: pair[0].id):
                revisions = list(group)
                done += 1
                for one, _ in revisions:
                    seen.name(one.created_by)
                    seen.mark(one)
                newest, car = revisions[-1]
                if newest.repeat_of is not None:
                    out.repeats.add(replace(newest, out_of_date=stale.get(newest.id, ())))
                    continue
                out.measurement([one for one, _ in revisions], car, stale.get(newest.id, ()))
                seen.name(newest.review.reviewer)
                seen.measurements += 1
                if not newest.withdrawn:
                    current.append(newest)
            if seen.crops:
                seen.spots.append(spots_of(current))
            tick(done / max(count, 1))


class _Writers:
    """The open files of all tables that a pass over the measurements fills."""

    def __init__(self, staging: Staging, stack: ExitStack, most: int) -> None:
        self._staging, self._stack = staging, stack
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
        self._current.add(replace(newest, out_of_date=out_of_date))
        for entry in budget_entries(newest):
            self._budget.add(entry)
        if not newest.withdrawn:
            clicked = Clicked(newest, car)
            self._clicks.add(clicked)
            self._of_pose(newest.values.pose_id).add(clicked)

    def _of_pose(self, pose_id: int) -> TableWriter[Clicked]:
        if pose_id not in self._of_poses:
            self._of_poses[pose_id] = self._opened(self._clicks_table, clicks_path(pose_id))
        return self._of_poses[pose_id]

    def _opened(self, table: Table[Record], path: str | None = None) -> TableWriter[Record]:
        return self._stack.enter_context(self._staging.table(table, path))


def _small_tables(staging: Staging, session: Session, survey: Survey, seen: _Seen) -> None:
    with staging.table(VEHICLES) as table:
        for page in vehicle_pages(session, survey.id):
            for vehicle in page:
                table.add(vehicle)
                if vehicle.make and vehicle.model:
                    seen.models.add((vehicle.make, vehicle.model))
        seen.vehicles = table.rows
    staging.fill(CATALOGUE, catalogue_of_models(session, seen.models))
    with staging.table(REVIEWS) as table_of_reviews:
        for reviews in review_pages(session, survey.id):
            for review in reviews:
                seen.name(review.reviewer)
                table_of_reviews.add(review)
    _lots(staging, session, survey.id, seen)
    computed = list_computings(session, survey.id)
    for one in computed:
        seen.name(one.created_by)
    staging.fill(COMPUTINGS, reversed(computed))
    staging.fill(RECORDINGS, map(described_recording, list_recordings(session, survey.id)))
    staging.fill(FRAMES, _frames(session, seen))
    staging.fill(SURVEY, (survey,))
    staging.fill(INSETS, insets_in_force(survey))
    staging.fill(CLASSES, survey.classes)
    staging.fill(SAMPLING, (survey,))
    staging.fill(QUOTAS, survey.sampling.quotas)
    staging.fill(STANDARDS, get_standards(session, survey.id).standards)
    pairs = list_wheel_pairs(session, survey.id)
    for pair in pairs:
        seen.name(pair.created_by)
    staging.fill(WHEEL_PAIRS, sorted(pairs, key=lambda pair: pair.id))
    seen.people.update(fill_scans(staging, session, survey.id))
    _set_up(staging, session, survey, seen)


def _lots(staging: Staging, session: Session, survey_id: int, seen: _Seen) -> None:
    """Lots with their items; those of deleted vehicles are in no table."""
    lots = list_lots(session, survey_id)
    for lot in lots:
        for who in (lot.created_by, lot.common.operator, *(one.created_by for one in lot.decisions)):
            seen.name(who)
    staging.fill(LOTS, lots)
    gone = items_of_deleted_vehicles(session, survey_id)
    staging.fill(
        LOT_ITEMS,
        (
            ItemOfLot(lot, item)
            for lot, items in lots_with_items(session, lots)
            for item in items
            if item.measurement_id not in gone
        ),
    )


def _photographs(staging: Staging, session: Session, survey_id: int, services: Services, seen: _Seen) -> None:
    found = list_photographs(session, survey_id)
    for one in found:
        seen.name(one.created_by)
        staging.add(photograph_path(one.id), photograph_content(services, one))
    staging.fill(PHOTOGRAPHS, enumerate(found, start=1))


def _set_up(staging: Staging, session: Session, survey: Survey, seen: _Seen) -> None:
    """Poses and calibrations: as tables, as files for the command line, and as the audit chain knows them."""
    found = list_whole_poses(session, survey.id)
    staging.fill(POSES, found)
    cameras = list_cameras(session, survey.id)
    staging.fill(CAMERAS, cameras)
    names = {camera.id: camera.name for camera in cameras}
    lenses = list_calibrations(session, survey.id)
    staging.fill(CALIBRATIONS, (NamedCalibration(lens, names.get(lens.camera_id)) for lens in lenses))
    for pose in found:
        seen.name(pose.created_by)
        staging.add(pose_path(pose.id), json_bytes(pose.document))
    for lens in lenses:
        seen.name(lens.created_by)
        staging.add(calibration_path(lens.id), json_bytes(lens.document))
    for kind, contents in (
        ("pose", pose_contents(session, survey.id)),
        ("calibration", calibration_contents(session, survey.id)),
    ):
        for row_id, content in contents.items():
            staging.add(record_path(kind, row_id), json_bytes(content))


def _frames(session: Session, seen: _Seen) -> Iterator[ClickedFrame]:
    """Every frame that was clicked on, once, as the frame table has it."""
    for recording_id in sorted(seen.marks):
        marked = np.flatnonzero(np.frombuffer(seen.marks[recording_id], np.uint8))
        yield from clicked_frames(recording_id, get_frame_table(session, recording_id), marked)


@dataclass(eq=False)
class _Audit:
    """The chain as it was written so far: its last event, and when this survey's last one happened."""

    table: TableWriter[Row]
    as_of: int = 0
    moment: str | None = None


def _audit(staging: Staging, session: Session, survey_id: int, seen: _Seen) -> _Audit:
    """The survey's chain, without the seal."""
    with staging.table(AUDIT) as table:
        written = _Audit(table)
        for page in audit_pages(session, survey_id):
            for event in page:
                table.add(event)
                written.as_of = event["number"]
                if event["entity"] != ENTITY:
                    written.moment = stamp(event["at"])
                if event["actor_id"] is not None:
                    seen.people[event["actor_id"]] = event["actor_name"] or ""
    return written


def _seal(
    staging: Staging,
    session: Session,
    survey_id: int,
    audit: _Audit,
    ends: dict[str, AuditHead],
    actor: int | None,
) -> AuditHead:
    """What came into the chain meanwhile, then the event that names every file; the chain's end.

    `ends`: those of the chains of people and of the catalogue, whose names and sizes the tables repeat.
    """
    files_before = dict(staging.written)
    with staging.continued(AUDIT, audit.table) as table:
        for page in audit_pages(session, survey_id, audit.as_of):
            for event in page:
                table.add(event)
        files = sealed(files_before, table.written().sha256)
        told = {"as_of": audit.as_of, "files": files, "chains": ends}
        number = seal_package(session, survey_id, told, actor=actor)
        ((event,),) = audit_pages(session, survey_id, number - 1)
        table.add(event)
    return AuditHead(number, str(event["hash"]))


def _crops(
    staging: Staging, services: Services, seen: _Seen, selection: Selection, tick: Callable[[float], None]
) -> int:
    """Pictures of the vehicles that the package is of."""
    spots = [page for page in seen.spots if len(page)]
    if spots and not selection.is_all:
        chosen = np.array([int(one) for one in chosen_vehicles(staging.files()).of], dtype=np.int64)
        spots = [kept for page in spots if len(kept := page[np.isin(page["vehicle"], chosen)])]
    if not spots:
        return staging.fill(CROPS, ())
    return take_crops(staging, services, np.concatenate(spots), tick)
