"""Measurements: append-only revisions of a series. Nothing changes a row; the database refuses it too."""

from dataclasses import asdict
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.tables import calibrations
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.hashing import plain
from sightline.infra.database.rows import add_row, get_row, missing, name_of, stored_hash
from sightline.infra.database.types import now
from sightline.measurements.query import fetch_measurements, is_current, is_first, measurement_revision_rows
from sightline.measurements.records import Measurement, MeasurementValues
from sightline.measurements.tables import measurement_series, measurements
from sightline.poses.tables import road_poses
from sightline.recordings.frames.store import get_frame
from sightline.reviews.query import reviews_of_series
from sightline.reviews.records import MeasurementHistory
from sightline.vehicles.tables import vehicles

_TOLD = ("target", "frame", "contact", "point", "height_m", "U95_height_m", "status", "reason", "pose_id")


def add_measurement(
    session: Session,
    vehicle_id: int,
    *,
    client_key: str,
    values: MeasurementValues,
    repeat_of: int | None = None,
    actor: int | None,
) -> Measurement:
    """Store the first revision of a measurement; the same `client_key` again gives the same one back.

    `repeat_of`: the measurement of the same target and vehicle that this one repeats (for a repeat, the one
    that it repeats itself). Raises NotFound for a deleted vehicle, Conflict for a key used on another vehicle
    or a frame that is not the stored one.
    """
    known = select(measurement_series).where(measurement_series.c.client_key == client_key)
    series = session.execute(known).mappings().one_or_none()
    if series is not None:
        if series["vehicle_id"] != vehicle_id:
            raise Conflict("This measurement was stored for another vehicle already; click again.")
        return get_measurement(session, series["id"])
    vehicle = get_row(session, vehicles, vehicle_id, "vehicle", vehicles.c.deleted_at.is_(None))
    place = {key: vehicle[key] for key in ("survey_id", "recording_id")}
    _check(session, place, values)
    place |= {"vehicle_id": vehicle_id, "repeat_of": _repeated(session, vehicle_id, repeat_of, values.target)}
    series_id = add_row(session, measurement_series, {**place, "client_key": client_key})
    _append(session, series_id, 1, place, values, False, None, "create", actor)
    return get_measurement(session, series_id)


def revise_measurement(
    session: Session, series_id: int, *, seen_revision: int, values: MeasurementValues, actor: int | None
) -> Measurement:
    """A new revision with other content. Raises Conflict for one not current, or withdrawn."""
    before = require_measurement_revision(session, series_id, seen_revision)
    if before.withdrawn:
        raise Conflict("This measurement is withdrawn; restore it before you change it.")
    if before.repeat_of is not None:
        raise Conflict("A repeat stands as it was clicked; withdraw it and click it again.")
    append_measurement_revision(session, before, values, withdrawn=False, action="revise", actor=actor)
    return get_measurement(session, series_id)


def withdraw_measurement(
    session: Session, series_id: int, *, seen_revision: int, actor: int | None
) -> Measurement:
    """A new revision that takes the measurement out of all lists and counts."""
    before = require_measurement_revision(session, series_id, seen_revision)
    if before.withdrawn:
        raise Conflict("This measurement is withdrawn already; restore it to use it again.")
    append_measurement_revision(
        session, before, values_of(before), withdrawn=True, action="withdraw", actor=actor
    )
    return get_measurement(session, series_id)


def restore_measurement(
    session: Session, series_id: int, *, seen_revision: int, actor: int | None
) -> Measurement:
    """A new revision that brings a withdrawn measurement back."""
    before = require_measurement_revision(session, series_id, seen_revision)
    if not before.withdrawn:
        raise Conflict("This measurement is not withdrawn, so there is nothing to restore.")
    append_measurement_revision(
        session, before, values_of(before), withdrawn=False, action="restore", actor=actor
    )
    return get_measurement(session, series_id)


def get_measurement(session: Session, series_id: int) -> Measurement:
    """The current revision, withdrawn or not. Raises NotFound."""
    found = fetch_measurements(
        session, measurement_revision_rows().where(measurements.c.series_id == series_id, is_current)
    )
    if not found:
        raise missing("measurement", series_id)
    return found[0]


def measurement_revisions(session: Session, series_id: int) -> MeasurementHistory:
    """Every revision and every review, oldest first. Raises NotFound."""
    query = (
        measurement_revision_rows()
        .where(measurements.c.series_id == series_id)
        .order_by(measurements.c.revision)
    )
    found = fetch_measurements(session, query)
    if not found:
        raise missing("measurement", series_id)
    return MeasurementHistory(found, reviews_of_series(session, measurement_series.c.id == series_id))


def list_measurements(
    session: Session,
    survey_id: int,
    *,
    every_revision: bool = False,
    include_withdrawn: bool = False,
    include_repeats: bool = False,
) -> tuple[Measurement, ...]:
    """A survey's measurements of vehicles that were not deleted; current ones unless told otherwise."""
    query = measurement_revision_rows().join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
    query = query.where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
    if not every_revision:
        query = query.where(is_current)
    if not include_withdrawn and not every_revision:
        query = query.where(~measurements.c.withdrawn)
    if not include_repeats:
        query = query.where(is_first)
    return fetch_measurements(session, query.order_by(measurements.c.series_id, measurements.c.revision))


def require_measurement_revision(session: Session, series_id: int, revision: int) -> Measurement:
    """The current revision, if it is the one that the caller saw. Raises Conflict, naming who and when.

    Also for a vehicle that was deleted meanwhile: what is written to it, nobody would see.
    """
    current = get_measurement(session, series_id)
    vehicle = get_row(session, vehicles, current.vehicle_id, "vehicle")
    if vehicle["deleted_at"] is not None:
        name, when = name_of(session, vehicle["updated_by"]), f"{vehicle['updated_at']:%Y-%m-%d %H:%M:%S} UTC"
        raise Conflict(f"{name} deleted vehicle {vehicle['number']} at {when}; restore it first.")
    if current.revision != revision:
        name = current.created_by.name if current.created_by else "The system"
        raise Conflict(
            f"{name} changed this measurement at {current.created_at:%Y-%m-%d %H:%M:%S} UTC; look again."
        )
    return current


def values_of(one: Measurement) -> MeasurementValues:
    """The content of a revision, to be written again."""
    return MeasurementValues(**{name: getattr(one, name) for name in MeasurementValues.__slots__})


def append_measurement_revision(
    session: Session,
    before: Measurement,
    values: MeasurementValues,
    *,
    withdrawn: bool,
    action: str,
    actor: int | None,
) -> int:
    """Write the revision after `before` with its audit event; returns its number."""
    place: dict[str, Any] = {"survey_id": before.survey_id, "recording_id": before.recording_id}
    place |= {"vehicle_id": before.vehicle_id, "repeat_of": before.repeat_of}
    _check(session, place, values)
    then = {name: getattr(before, name) for name in _TOLD} | {"revision": before.revision}
    number = before.revision + 1
    _append(session, before.id, number, place, values, withdrawn, then, action, actor)
    return number


def _append(
    session: Session,
    series_id: int,
    revision: int,
    place: dict[str, Any],
    values: MeasurementValues,
    withdrawn: bool,
    before: dict[str, Any] | None,
    action: str,
    actor: int | None,
) -> None:
    row = asdict(values)
    (row["contact_x_px"], row["contact_y_px"]) = row.pop("contact")
    (row["point_x_px"], row["point_y_px"]) = row.pop("point")
    row["more_frames"] = [plain(one) for one in values.more_frames]
    stamps = {"series_id": series_id, "revision": revision, "withdrawn": withdrawn}
    moment = now()
    row_id = add_row(session, measurements, {**row, **stamps, "created_at": moment, "created_by": actor})
    after = {name: getattr(values, name) for name in _TOLD} | {
        "revision": revision,
        "revision_id": row_id,
        "vehicle_id": place["vehicle_id"],
        "withdrawn": withdrawn,
        "code_version": values.code_version,
        "created_at": moment,
        "content_sha256": stored_hash(session, measurements, row_id),
    }
    if place["repeat_of"] is not None:
        after["repeat_of"] = place["repeat_of"]
    if values.more_frames:
        after["more_frames"] = [[one.frame, one.contact, one.point] for one in values.more_frames]
    trail.record(session, actor, action, "measurement", series_id, place["survey_id"], before, after)


def _repeated(session: Session, vehicle_id: int, repeat_of: int | None, target: str) -> int | None:
    """The first measurement that a new one repeats. Raises BadInput for another vehicle's or target's."""
    if repeat_of is None:
        return None
    first = get_measurement(session, repeat_of)
    if (first.vehicle_id, first.target) != (vehicle_id, target):
        raise BadInput("A repeat needs the vehicle and the target of the measurement that it repeats.")
    return first.repeat_of or first.id


def _check(session: Session, place: dict[str, Any], values: MeasurementValues) -> None:
    clicked_on = [(values.frame, values.pts, values.frame_crc)]
    clicked_on += [(one.frame, one.pts, one.frame_crc) for one in values.more_frames]
    for n, pts, crc in clicked_on:
        frame = get_frame(session, place["recording_id"], n)
        if (frame.pts, frame.crc32) != (pts, crc):
            raise Conflict(f"Frame {n} is not the picture that was clicked on; load it again.")
    pose = get_row(session, road_poses, values.pose_id, "road pose")
    if pose["survey_id"] != place["survey_id"]:
        raise BadInput(f"Road pose {values.pose_id} belongs to another survey; choose one of this survey's.")
    get_row(session, calibrations, values.calibration_id, "calibration")
    if values.status == "ok" and values.height_m is None:
        raise BadInput("A measurement without a height needs the reason why; compute it again.")
    if values.status != "ok" and not values.reason:
        raise BadInput("A measurement that has no height needs the reason why; compute it again.")
