"""What a new revision of a measurement is checked against, of one in one query, of hundreds in a few."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from sqlalchemy import Select, and_, bindparam, exists, func, select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.errors import BadInput, Conflict
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import missing
from sightline.measurements.click_context_query import frames_by_number
from sightline.measurements.derived_query import TELLING
from sightline.measurements.query import is_current, is_first, is_last
from sightline.measurements.records import FurtherFrame, MeasurementValues
from sightline.measurements.tables import measurement_series, measurements, reviews
from sightline.poses.tables import road_poses
from sightline.recordings.frames.store import missing_frame
from sightline.recordings.frames.tables import frames
from sightline.recordings.tables import recordings
from sightline.vehicles.tables import vehicles


@dataclass(frozen=True, slots=True, kw_only=True)
class NewMeasurement:
    """The first revision of a measurement to come."""

    vehicle_id: int
    client_key: str
    values: MeasurementValues


@cache
def standing_measurement() -> Select[Any]:
    """The measurement of `of_vehicle`'s `of_target` that counts (the oldest), `but` and repeats left out."""
    series = measurement_series.c
    return (
        select(func.min(series.id))
        .join(measurements, measurements.c.series_id == series.id)
        .where(series.vehicle_id == bindparam("of_vehicle"), is_first, is_last)
        .where(series.id != bindparam("but", 0))
        .where(measurements.c.target == bindparam("of_target"), ~measurements.c.withdrawn)
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Ground:
    """What a revision is checked against. `known_*`: the measurement stored with the same client key;
    `judged`: whether a verdict was ever given to the measurement that is revised. The name of who writes it
    and what the recording tells are not of several at once.
    """

    survey_id: int
    recording_id: int
    vehicle_deleted: bool
    known_id: int | None
    known_vehicle_id: int | None
    standing_id: int | None
    judged: bool
    pose_survey_id: int | None
    has_calibration: bool
    frames: dict[int, tuple[int, int]]  # pts and crc32
    actor_name: str | None = None
    telling: Mapping[Any, Any] = field(default_factory=dict)  # of the recording: `TELLING`


@cache
def _ground_query() -> Select[Any]:
    known = measurement_series.alias("known")
    clicked_on = and_(
        frames.c.recording_id == vehicles.c.recording_id, frames.c.n.in_(bindparam("clicked", expanding=True))
    )
    return (
        select(
            *(vehicles.c.survey_id, vehicles.c.recording_id, vehicles.c.deleted_at),
            *(known.c.id.label("known_id"), known.c.vehicle_id.label("known_vehicle_id")),
            standing_measurement().scalar_subquery().label("standing_id"),
            exists().where(reviews.c.series_id == bindparam("of_series")).label("judged"),
            road_poses.c.survey_id.label("pose_survey_id"),
            calibrations.c.id.label("calibration_id"),
            *(people.c.name.label("actor_name"), *TELLING),
            *(frames.c.n, frames.c.pts, frames.c.crc32),
        )
        .select_from(vehicles)
        .join(recordings, recordings.c.id == vehicles.c.recording_id)
        .outerjoin(people, people.c.id == bindparam("of_actor"))
        .outerjoin(known, known.c.client_key == bindparam("of_key"))
        .outerjoin(road_poses, road_poses.c.id == bindparam("of_pose"))
        .outerjoin(calibrations, calibrations.c.id == bindparam("of_calibration"))
        .outerjoin(frames, clicked_on)
        .where(vehicles.c.id == bindparam("of_vehicle"))
    )


def ground_of(
    session: Session,
    vehicle_id: int,
    values: MeasurementValues,
    client_key: str | None = None,
    *,
    series_id: int = 0,
    actor: int | None,
) -> Ground:
    """All of it in one query; `series_id`: what is revised. Raises NotFound for a vehicle that never was."""
    asked = {
        "of_vehicle": vehicle_id,
        "of_target": values.target,
        "of_actor": actor,
        "of_key": client_key,
        "of_series": series_id,
        "of_pose": values.pose_id,
        "of_calibration": values.calibration_id,
        "clicked": values.frames,
    }
    rows = session.execute(_ground_query(), asked).all()
    if not rows:
        raise missing("vehicle", vehicle_id)
    row = rows[0]
    return record_of(
        Ground,
        row._mapping,
        vehicle_deleted=row.deleted_at is not None,
        has_calibration=row.calibration_id is not None,
        frames={of.n: (of.pts, of.crc32) for of in rows if of.n is not None},
        telling=row._mapping,
    )


def grounds_of(session: Session, survey_id: int, fresh: Sequence[NewMeasurement]) -> list[Ground]:
    """`ground_of` each of some hundred in a survey. Raises NotFound for a vehicle that is not in it."""
    ids = {measurement.vehicle_id for measurement in fresh}
    cars = select(vehicles.c.id, vehicles.c.recording_id).where(
        vehicles.c.id.in_(ids), vehicles.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None)
    )
    recording_of = {row.id: row.recording_id for row in session.execute(cars)}
    if lost := ids - set(recording_of):
        raise missing("vehicle", min(lost))
    series = measurement_series.c
    keys = select(series.client_key, series.id, series.vehicle_id).where(
        series.client_key.in_({measurement.client_key for measurement in fresh})
    )
    known = {row.client_key: (row.id, row.vehicle_id) for row in session.execute(keys)}
    standing = (
        select(series.vehicle_id, measurements.c.target, func.min(series.id).label("id"))
        .join(measurements, measurements.c.series_id == series.id)
        .where(series.vehicle_id.in_(ids), is_first, is_current, ~measurements.c.withdrawn)
        .group_by(series.vehicle_id, measurements.c.target)
    )
    stands = {(row.vehicle_id, row.target): row.id for row in session.execute(standing)}
    of_poses = select(road_poses.c.id, road_poses.c.survey_id).where(
        road_poses.c.id.in_({measurement.values.pose_id for measurement in fresh})
    )
    poses = {row.id: row.survey_id for row in session.execute(of_poses)}
    of_lenses = select(calibrations.c.id).where(
        calibrations.c.id.in_({measurement.values.calibration_id for measurement in fresh})
    )
    lenses = set(session.execute(of_lenses).scalars())
    frames_of = _frames_of(session, fresh, recording_of)
    return [
        Ground(
            survey_id=survey_id,
            recording_id=recording_of[measurement.vehicle_id],
            vehicle_deleted=False,
            known_id=known.get(measurement.client_key, (None, None))[0],
            known_vehicle_id=known.get(measurement.client_key, (None, None))[1],
            standing_id=stands.get((measurement.vehicle_id, measurement.values.target)),
            judged=False,
            pose_survey_id=poses.get(measurement.values.pose_id),
            has_calibration=measurement.values.calibration_id in lenses,
            frames=frames_of[recording_of[measurement.vehicle_id]],
        )
        for measurement in fresh
    ]


def _frames_of(
    session: Session, fresh: Sequence[NewMeasurement], recording_of: Mapping[int, int]
) -> dict[int, dict[int, tuple[int, int]]]:
    """(pts, CRC-32) of the frames clicked on, by recording and number."""
    numbers: dict[int, set[int]] = defaultdict(set)
    for one in fresh:
        numbers[recording_of[one.vehicle_id]] |= set(one.values.frames)
    return {
        id_: {n: (one.pts, one.crc32) for n, one in frames_by_number(session, id_, sorted(wanted)).items()}
        for id_, wanted in numbers.items()
    }


def check_ground(ground: Ground, values: MeasurementValues) -> None:
    """Raises NotFound for a frame, pose or calibration that is not there, Conflict for another frame than was
    clicked, and BadInput for a pose of another survey and a content that says neither height nor reason.
    """
    clicked_on: tuple[MeasurementValues | FurtherFrame, ...] = (values, *values.more_frames)
    for clicked in clicked_on:
        if clicked.frame not in ground.frames:
            raise missing_frame(ground.recording_id, clicked.frame)
        if ground.frames[clicked.frame] != (clicked.pts, clicked.frame_crc32):
            raise Conflict("measurements-frame-not-clicked", frame=clicked.frame)
    if ground.pose_survey_id is None:
        raise missing("camera pose", values.pose_id)
    if ground.pose_survey_id != ground.survey_id:
        raise BadInput("measurements-pose-other-survey", pose_id=values.pose_id)
    if not ground.has_calibration:
        raise missing("calibration", values.calibration_id)
    if values.status == "ok" and values.height_m is None:
        raise BadInput("measurements-empty-without-reason")
    if values.status != "ok" and not values.reason:
        raise BadInput("measurements-no-height-reason")
