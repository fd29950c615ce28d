"""What computing a survey's heights again needs to know, for thousands of them in a few queries."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from sqlalchemy import Text, cast, func, select, type_coerce
from sqlalchemy.orm import Session

from sightline.enums import Category, Target
from sightline.geometry.sides import FoundSide, driver_side
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import the_one, who
from sightline.measurements.again.differences import Facts
from sightline.measurements.again.records import Computing
from sightline.measurements.click_context_query import ClickContext, context_of_row
from sightline.measurements.query import fetch_measurements, is_current, measurement_revision_rows
from sightline.measurements.records import Measurement, ScanHeight
from sightline.measurements.tables import computings, measurement_series, measurements
from sightline.poses.tables import road_poses
from sightline.recordings.tables import recordings
from sightline.surveys.records import Inset
from sightline.surveys.store import get_survey
from sightline.vehicles.records import NOT_VISIBLE
from sightline.vehicles.tables import vehicles

_m = measurements.c
_undo = computings.alias("undo")


def contexts_of_survey(session: Session, survey_id: int) -> dict[int, ClickContext]:
    """What clicks on each living vehicle follow from now, by vehicle; without frames and a person's sigma.

    Raises NotFound.
    """
    survey = get_survey(session, survey_id)
    return {
        row.vehicle_id: context_of_row(row, survey.insets, survey.traffic)
        for row in _places(session, survey_id)
    }


def _places(session: Session, survey_id: int) -> Sequence[Any]:
    query = (
        select(
            *(vehicles.c.id.label("vehicle_id"), vehicles.c.direction, vehicles.c.driver_side),
            vehicles.c.category,
            *(vehicles.c.discarded, *(vehicles.c[name] for name in NOT_VISIBLE.values())),
            *(recordings.c.id.label("recording_id"), recordings.c.survey_id, recordings.c.name),
            recordings.c.pose_id,
            *(recordings.c.width_px, recordings.c.height_px, road_poses.c.calibration_id),
        )
        .join(recordings, recordings.c.id == vehicles.c.recording_id)
        .outerjoin(road_poses, road_poses.c.id == recordings.c.pose_id)
        .where(vehicles.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(recordings.c.deleted_at.is_(None))
    )
    return session.execute(query).all()


@dataclass(frozen=True, slots=True, kw_only=True)
class Alike:
    """So many standing heights with the same facts, and what holds now; `code_version` computed them.

    `named`: the ids of measurements, between commas.
    """

    count: int
    named: str = ""
    in_line_scan: bool = False
    target: Target
    facts: Facts
    has_height: bool = True
    code_version: str
    pose_id: int | None
    side: FoundSide | None
    category: Category | None
    insets: Mapping[str, Inset]


def group_alike(session: Session, survey_id: int) -> Iterator[Alike]:
    """The standing measurements and repeats of a survey, those with the same facts counted together."""
    survey = get_survey(session, survey_id)
    several = type_coerce(_m.more_frames, Text) != "[]"
    each = (
        select(
            *(
                _m.series_id,
                _m.target,
                _m.pose_id.label("of_pose"),
                _m.side,
                _m.side_from,
                _m.inset_m,
                _m.u_inset_m,
            ),
            *(_m.inset_from, several.label("solved"), _m.height_m.is_not(None).label("has_height")),
            *(_m.code_version, vehicles.c.direction, vehicles.c.driver_side, vehicles.c.category),
            recordings.c.pose_id,
        )
        .select_from(measurements)
        .join(measurement_series, measurement_series.c.id == _m.series_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .join(recordings, recordings.c.id == measurement_series.c.recording_id)
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, ~_m.withdrawn, recordings.c.pose_id.is_not(None))
        .where(recordings.c.deleted_at.is_(None))
        .subquery()
    )
    shared = [column for column in each.c if column.name != "series_id"]
    named = func.aggregate_strings(cast(each.c.series_id, Text), ",").label("named")
    query = select(func.count().label("count"), named, *shared).group_by(*shared)
    for row in session.execute(query):
        yield record_of(
            Alike,
            row._mapping,
            facts=record_of(Facts, row._mapping, pose_id=row.of_pose),
            in_line_scan=False,
            side=driver_side(row.driver_side, row.direction, survey.traffic),
            insets=survey.insets,
        )


def list_computings(session: Session, survey_id: int) -> tuple[Computing, ...]:
    """A survey's, newest first."""
    return _computings(session, computings.c.survey_id == survey_id)


def get_computing(session: Session, computing_id: int) -> Computing:
    """One of them. Raises NotFound."""
    return the_one(_computings(session, computings.c.id == computing_id), "computing", computing_id)


def _computings(session: Session, condition: Any) -> tuple[Computing, ...]:
    undone = select(func.max(_undo.c.id)).where(_undo.c.undoes == computings.c.id).scalar_subquery()
    query = (
        select(computings, people.c.name.label("maker"), undone.label("undone_by"))
        .outerjoin(people, people.c.id == computings.c.created_by)
        .where(condition)
        .order_by(computings.c.id.desc())
    )
    return tuple(
        record_of(Computing, row._mapping, created_by=who(row.created_by, row.maker))
        for row in session.execute(query)
    )


@dataclass(frozen=True, slots=True)
class Made:
    """A revision that a computing made, the one before it, and what stands now."""

    before: Measurement | ScanHeight
    made: Measurement | ScanHeight
    standing: Measurement | ScanHeight


def made_by(session: Session, computing_id: int) -> list[Made]:
    """The revisions of a computing on frames whose measurement still stands, in the order of measurements."""
    touched = select(_m.series_id).where(_m.computing_id == computing_id)
    query = (
        measurement_revision_rows()
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .where(measurement_series.c.id.in_(touched), vehicles.c.deleted_at.is_(None))
        .order_by(_m.series_id, _m.revision)
    )
    return made_among(fetch_measurements(session, query), computing_id)


def made_among(revisions: Iterable[Measurement | ScanHeight], computing_id: int) -> list[Made]:
    """Those that a computing made of heights that stand; of each height all revisions, oldest first."""
    by_height: dict[int, list[Measurement | ScanHeight]] = {}
    for revision in revisions:
        by_height.setdefault(revision.id, []).append(revision)
    return [
        Made(before, revision, all_[-1])
        for all_ in by_height.values()
        for before, revision in pairwise(all_)
        if revision.computing_id == computing_id and not all_[-1].withdrawn
    ]
