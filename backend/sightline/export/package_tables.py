"""The tables of a package, each once: their order, what fills them, what checks them.

The order is that of datapackage.json, of writing and of checking: what others are computed from comes first.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import chain
from operator import attrgetter
from typing import TypeVar

from sightline.cameras.calibrations.csv import CALIBRATIONS
from sightline.cameras.calibrations.verify import check_calibrations
from sightline.cameras.csv import CAMERAS
from sightline.cameras.store import list_cameras
from sightline.cameras.verify import check_cameras
from sightline.export import filling
from sightline.export.crops import CROPS
from sightline.export.exclusions import EXCLUSIONS
from sightline.export.filling import Filling
from sightline.export.query import review_pages
from sightline.export.response import RESPONSE
from sightline.export.statistics_csv import TABLES as STATISTICS
from sightline.export.verify import checking
from sightline.export.verify.checking import Checking
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.replay import Replay
from sightline.infra.csv_package.schema import AnyTable, Table
from sightline.measurements.again.csv import COMPUTINGS
from sightline.measurements.again.query import list_computings
from sightline.measurements.csv import (
    BUDGET,
    CLICKS,
    MEASUREMENTS,
    REVISIONS,
    clicks_with_frames,
    with_frames,
)
from sightline.measurements.sheets.csv import VEHICLES
from sightline.measurements.sheets.verify import check_vehicles
from sightline.measurements.verify import check_frames
from sightline.people.csv import PEOPLE
from sightline.poses.csv import POSES
from sightline.poses.verify import check_poses
from sightline.quality.checks.csv import WHEEL_PAIRS
from sightline.quality.checks.store import list_wheel_pairs
from sightline.quality.checks.verify import check_wheel_pairs
from sightline.quality.repeats.csv import REPEATS
from sightline.recordings.csv import RECORDINGS, describe_recording
from sightline.recordings.frames.csv import FRAMES
from sightline.recordings.store import list_recordings
from sightline.recordings.verify import check_recordings
from sightline.results.csv import SELECTION, STANDARDS, selection_rows
from sightline.results.standards_store import get_standards
from sightline.results.verify import check_standards
from sightline.reviews.csv import REVIEWS
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS
from sightline.reviews.lots.verify import check_lots
from sightline.reviews.verify import check_verdicts
from sightline.scans.csv import TABLES as SCANS
from sightline.scans.csv import fill_scans
from sightline.scans.verify import check_scans
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY
from sightline.surveys.photographs.csv import PHOTOGRAPHS
from sightline.surveys.photographs.verify import check_photographs
from sightline.surveys.verify import check_survey
from sightline.vehicles.catalogue.csv import CATALOGUE

Record = TypeVar("Record")
Tables = tuple[AnyTable, ...]


@dataclass(frozen=True)
class Part:
    """Tables that are filled in one pass and checked by one function; `check` raises Damaged.

    `check`: None where something else vouches for the rows: keys, the walk along the chain, the chains of
    people and of the catalogue that the seal names. `widened`: the tables for as many frames as a measurement
    has at most, where their columns depend on that.
    """

    tables: Tables
    fill: Callable[[Filling], object]
    check: Callable[[Checking], object] | None = None
    widened: Callable[[int], Tables] | None = None

    def of_frames(self, most: int) -> Tables:
        """The tables, with columns for as many frames as a measurement has at most."""
        return self.tables if self.widened is None else self.widened(most)


def _part_of_records(
    table: Table[Record],
    records: Callable[[Filling], Iterable[Record]],
    check: Callable[[Checking], object] | None = None,
) -> Part:
    """One table of records."""
    return Part((table,), lambda found: found.staging.fill(table, records(found)), check)


def _replayed(check: Callable[[Files, Replay], object]) -> Callable[[Checking], object]:
    return lambda c: check(c.files, c.told.replay)


def _with_frames(most: int) -> Tables:
    wide = (with_frames(table, most) for table in (MEASUREMENTS, REVISIONS))
    return (*wide, BUDGET, clicks_with_frames(most), REPEATS)


_SURVEY = (SURVEY, INSETS, CLASSES, SAMPLING, QUOTAS)
_MEASURED = (MEASUREMENTS, REVISIONS, BUDGET, CLICKS, REPEATS)
#: What is stored, held against the audit chain.
STORED = (
    Part(_SURVEY, filling.fill_survey, lambda c: check_survey(c.files, c.told.survey)),
    _part_of_records(
        STANDARDS,
        lambda f: f.of_survey(get_standards).standards,
        lambda c: check_standards(c.files, c.told.survey),
    ),
    _part_of_records(CAMERAS, lambda f: f.of_survey(list_cameras), _replayed(check_cameras)),
    Part((CALIBRATIONS,), filling.fill_calibrations, _replayed(check_calibrations)),
    Part((POSES,), filling.fill_poses, _replayed(check_poses)),
    Part(_MEASURED, filling.fill_measurements, checking.check_heights, _with_frames),
    Part(
        (VEHICLES, CATALOGUE),
        filling.fill_vehicles,
        lambda c: check_vehicles(c.files, c.told.replay, c.recomputing, c.described.program),
    ),
    _part_of_records(
        RECORDINGS,
        lambda f: map(describe_recording, f.of_survey(list_recordings)),
        lambda c: check_recordings(c.files, c.told.replay, c.told.drift),
    ),
    _part_of_records(
        WHEEL_PAIRS,
        lambda f: sorted(f.of_survey(list_wheel_pairs), key=attrgetter("id")),
        _replayed(check_wheel_pairs),
    ),
    _part_of_records(
        COMPUTINGS, lambda f: reversed(f.of_survey(list_computings)), checking.check_computed_again
    ),
    _part_of_records(
        REVIEWS, lambda f: chain.from_iterable(f.of_survey(review_pages)), _replayed(check_verdicts)
    ),
    Part(
        (LOTS, LOT_ITEMS),
        filling.fill_lots,
        lambda c: check_lots(c.files, c.told.lots, c.told.replay, c.told.measurements.of_vehicle),
    ),
    _part_of_records(FRAMES, filling.frames_clicked_on, lambda c: check_frames(c.files, c.told.measurements)),
    Part(
        SCANS,
        lambda f: fill_scans(f.staging, f.session, f.survey.id),
        lambda c: check_scans(c.files, c.told.replay, c.computings, c.recomputing, c.described.program),
    ),
    Part(
        (PHOTOGRAPHS,),
        filling.fill_photographs,
        lambda c: check_photographs(c.files, c.told.replay, c.written),
    ),
    Part((AUDIT,), filling.fill_audit),
    _part_of_records(PEOPLE, filling.people_named),
    _part_of_records(SELECTION, lambda f: selection_rows(f.selection)),
)
#: What is made of those, made again and compared.
MADE = (
    Part((CROPS,), filling.fill_crops, checking.check_pictures),
    Part((EXCLUSIONS, RESPONSE, *STATISTICS), filling.fill_statistics, checking.check_figures),
)
PACKAGE = (*STORED, *MADE)


def tables_of(most_frames: int) -> Tables:
    """Every table, with columns for as many frames as a measurement has at most."""
    return tuple(table for part in PACKAGE for table in part.of_frames(most_frames))
