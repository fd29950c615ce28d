"""Measurements: append-only revisions of a series. Nothing changes a row; the database refuses it too."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from datetime import datetime
from functools import cache, partial
from typing import Any, TypeVar

from sqlalchemy import Row, Select, bindparam, insert, select
from sqlalchemy.orm import Session
from sqlalchemy.sql.dml import ReturningInsert

from sightline.enums import AuditAction, JsonObject
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.hashing import content_hash, to_plain_json
from sightline.infra.audit.records import Who, name_or_somebody
from sightline.infra.database.rows import add_row, add_rows, missing, name_of, row_content, who
from sightline.infra.database.types import now
from sightline.measurements.again.differences import judged_alike, same_height
from sightline.measurements.derived_query import TELLING, derived_from
from sightline.measurements.ground_query import (
    Ground,
    NewMeasurement,
    check_ground,
    ground_of,
    grounds_of,
    standing_measurement,
)
from sightline.measurements.query import (
    OF_FRAMES,
    Reader,
    fetch_measurements,
    is_current,
    is_first,
    is_last,
    measurement_of_row,
    measurement_revision_rows,
)
from sightline.measurements.records import (
    Measurement,
    MeasurementValues,
    ReviewState,
    ScanHeight,
    ScanHeightValues,
)
from sightline.measurements.tables import measurement_series, measurements
from sightline.recordings.tables import recordings
from sightline.vehicles.tables import vehicles

_Made = TypeVar("_Made", Measurement, ScanHeight)
_SOME = 500  # revisions written with one statement
_IN_EVENTS = (
    "target",
    "frame",
    "contact",
    "target_point",
    "made",
    "side",
    "height_m",
    "U95_height_m",
    "status",
    "reason",
    "pose_id",
)


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
    or a frame that is not the stored one, and for a target that stands measured, with that measurement, where
    this is no repeat: two heights of one target would be counted twice.
    """
    ground = ground_of(session, vehicle_id, values, client_key, actor=actor)
    if ground.known_id is not None:
        if ground.known_vehicle_id != vehicle_id:
            raise Conflict("measurements-other-vehicle")
        return get_measurement(session, ground.known_id)
    if ground.vehicle_deleted:
        raise missing("vehicle", vehicle_id)
    check_ground(ground, values)
    if repeat_of is None and ground.standing_id is not None:
        raise _already_measured(session, ground.standing_id)
    place: dict[str, Any] = {"survey_id": ground.survey_id, "recording_id": ground.recording_id}
    place |= {"vehicle_id": vehicle_id, "repeat_of": _repeated(session, vehicle_id, repeat_of, values.target)}
    series_id = add_row(session, measurement_series, {**place, "client_key": client_key})
    known = partial(
        _complete_revision, session, _first_revision(series_id, 0, values, place, now()), ground, actor
    )
    return append_revision(
        session, series_id, 1, values, before=None, action="create", actor=actor, made_of=known
    )


def add_measurements(
    session: Session, survey_id: int, fresh: Sequence[NewMeasurement], *, actor: int | None
) -> list[int]:
    """`add_measurement` of thousands of a survey, each with its audit event; their ids, in their order.

    Raises as that does, and Conflict for a known `client_key`; ValueError for two of one vehicle's target.
    """
    if len({(one.vehicle_id, one.values.target) for one in fresh}) < len(fresh):
        raise ValueError("two heights of one vehicle's target")
    made: list[int] = []
    for at in range(0, len(fresh), _SOME):
        made += _add_some(session, survey_id, fresh[at : at + _SOME], actor)
    return made


def _add_some(
    session: Session, survey_id: int, fresh: Sequence[NewMeasurement], actor: int | None
) -> list[int]:
    grounds = grounds_of(session, survey_id, fresh)
    for measurement, ground in zip(fresh, grounds, strict=True):
        if ground.known_id is not None:
            raise Conflict("measurements-other-vehicle")
        check_ground(ground, measurement.values)
        if ground.standing_id is not None:
            raise _already_measured(session, ground.standing_id)
    places: list[dict[str, Any]] = [
        {
            "survey_id": survey_id,
            "recording_id": ground.recording_id,
            "vehicle_id": measurement.vehicle_id,
            "repeat_of": None,
        }
        for measurement, ground in zip(fresh, grounds, strict=True)
    ]
    keyed = [{**place, "client_key": one.client_key} for place, one in zip(places, fresh, strict=True)]
    ids = add_rows(session, measurement_series, keyed)
    moment = now()
    stamps = {"revision": 1, "withdrawn": False, "created_at": moment, "created_by": actor}
    rows = [{**_row_of(one.values), "series_id": id_, **stamps} for id_, one in zip(ids, fresh, strict=True)]
    revision_ids = add_rows(session, measurements, rows)
    content_of = _contents(session, revision_ids)
    events = [
        (id_, None, _event_after(_first_revision(id_, number, one.values, place, moment), content_of[number]))
        for id_, number, one, place in zip(ids, revision_ids, fresh, places, strict=True)
    ]
    trail.record_many(session, actor, "create", "measurement", survey_id, events)
    return ids


def _first_revision(
    series_id: int, revision_id: int, values: MeasurementValues, place: Mapping[str, Any], moment: datetime
) -> Measurement:
    return Measurement(
        id=series_id,
        revision=1,
        revision_id=revision_id,
        values=values,
        created_by=None,
        created_at=moment,
        withdrawn=False,
        computing_id=None,
        review=ReviewState("to_review"),
        **place,
    )


def _contents(session: Session, revision_ids: Sequence[int]) -> dict[int, JsonObject]:
    """The rows of revisions as the database gives them back, by id: what a verification hashes."""
    rows = session.execute(select(measurements).where(measurements.c.id.in_(revision_ids))).mappings()
    return {row["id"]: to_plain_json(row_content(row)) for row in rows}


def revise_measurement(
    session: Session,
    before: Measurement,
    values: MeasurementValues,
    *,
    clicked_by: Who | None = None,
    actor: int | None,
) -> Measurement:
    """A new revision with other content than `before`, which `require_measurement_revision` gave in the same
    transaction. `clicked_by`: who stays its operator, for the clicks are the same. Raises Conflict for one
    that is withdrawn, or a repeat.
    """
    if before.withdrawn:
        raise Conflict("measurements-withdrawn")
    if before.repeat_of is not None:
        raise Conflict("measurements-repeat-fixed")
    if values.target != before.values.target:
        _require_alone(session, before, values.target)
    return append_measurement_revision(
        session, before, values, withdrawn=False, action="revise", clicked_by=clicked_by, actor=actor
    )


def withdraw_measurement(
    session: Session, series_id: int, *, seen_revision: int, actor: int | None
) -> Measurement:
    """A new revision that takes the measurement out of all lists and counts."""
    before = require_measurement_revision(session, series_id, seen_revision)
    if before.withdrawn:
        raise Conflict("measurements-withdrawn-already")
    return append_measurement_revision(
        session, before, before.values, withdrawn=True, action="withdraw", actor=actor
    )


def restore_measurement(
    session: Session, series_id: int, *, seen_revision: int, actor: int | None
) -> Measurement:
    """A new revision that brings a withdrawn measurement back."""
    before = require_measurement_revision(session, series_id, seen_revision)
    if not before.withdrawn:
        raise Conflict("measurements-not-withdrawn")
    _require_alone(session, before, before.values.target)
    return append_measurement_revision(
        session, before, before.values, withdrawn=False, action="restore", actor=actor
    )


def is_stored_key(session: Session, client_key: str) -> bool:
    """Whether a measurement was stored with this `client_key`."""
    found = select(measurement_series.c.id).where(measurement_series.c.client_key == client_key)
    return session.execute(found).first() is not None


def get_measurement(session: Session, series_id: int) -> Measurement:
    """The current revision, withdrawn or not. Raises NotFound."""
    return _measurement_of(session, _current_row(session, series_id))


@cache
def _with_place() -> Select[Any]:
    """Whole revisions with what is known of the recording's camera and whether the vehicle was deleted."""
    return (
        measurement_revision_rows()
        .add_columns(
            *TELLING,
            *(vehicles.c.number.label("vehicle_number"), vehicles.c.deleted_at.label("vehicle_deleted_at")),
            *(vehicles.c.updated_at.label("vehicle_updated_at"), vehicles.c.updated_by.label("deleter_id")),
        )
        .join(recordings, recordings.c.id == measurement_series.c.recording_id)
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
    )


# What a stored click asks is made once: making a statement takes longer than the database does to answer it.
@cache
def _current() -> Select[Any]:
    return _with_place().where(measurements.c.series_id == bindparam("of_series"), is_last)


@cache
def _revision() -> Select[Any]:
    return _with_place().where(measurements.c.id == bindparam("of_revision"))


def _current_row(session: Session, series_id: int) -> Row[Any]:
    row = session.execute(_current(), {"of_series": series_id}).one_or_none()
    if row is None:
        raise missing("measurement", series_id)
    return row


def _measurement_of(session: Session, row: Row[Any]) -> Measurement:
    return derived_from(session, measurement_of_row(row), row._mapping)


def measurement_revisions(session: Session, series_id: int) -> tuple[Measurement, ...]:
    """Every revision, oldest first. Raises NotFound."""
    query = (
        measurement_revision_rows()
        .where(measurements.c.series_id == series_id)
        .order_by(measurements.c.revision)
    )
    found = fetch_measurements(session, query)
    if not found:
        raise missing("measurement", series_id)
    return found


def list_measurements(
    session: Session, survey_id: int, *, include_repeats: bool = False
) -> tuple[Measurement, ...]:
    """A survey's standing measurements of vehicles that were not deleted."""
    query = measurement_revision_rows().join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
    query = query.where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
    query = query.where(is_current, ~measurements.c.withdrawn)
    if not include_repeats:
        query = query.where(is_first)
    return fetch_measurements(session, query.order_by(measurements.c.series_id, measurements.c.revision))


def require_measurement_revision(session: Session, series_id: int, revision: int) -> Measurement:
    """The current revision, if it is the one that the caller saw. Raises Conflict, naming who and when.

    Also for a vehicle that was deleted meanwhile: what is written to it, nobody would see.
    """
    row = _current_row(session, series_id)
    if row.vehicle_deleted_at is not None:
        name = name_of(session, row.deleter_id)
        when = f"{row.vehicle_updated_at:%Y-%m-%d %H:%M:%S} UTC"
        raise Conflict(
            "measurements-vehicle-deleted", name=name, vehicle_number=row.vehicle_number, when=when
        )
    current = _measurement_of(session, row)
    require_seen(current, revision)
    return current


def require_seen(current: Measurement | ScanHeight, revision: int) -> None:
    """Raises Conflict, naming who and when, where the current revision is not the one that the caller saw."""
    if current.revision != revision:
        name = current.created_by.name if current.created_by else "The system"
        raise Conflict(
            "measurements-changed-meanwhile",
            name=name,
            created_at=format(current.created_at, "%Y-%m-%d %H:%M:%S"),
        )


def append_measurement_revision(
    session: Session,
    before: Measurement,
    values: MeasurementValues,
    *,
    withdrawn: bool,
    action: AuditAction,
    clicked_by: Who | None = None,
    actor: int | None,
) -> Measurement:
    """Write the revision after `before` with its audit event, and give it back.

    Points put back where they were, so that the height is what it was, bring the verdict back that stood on
    it: an undone change and a withdrawal undone leave a review as it was. A fix has a verdict of its own.
    """
    ground = ground_of(session, before.vehicle_id, values, series_id=before.id, actor=actor)
    check_ground(ground, values)
    carried = None
    if ground.judged and not withdrawn and action != "fix":
        carried = verdict_that_stood(session, OF_FRAMES, before.id, values)
    to_come = replace(
        before,
        revision=before.revision + 1,
        values=values,
        withdrawn=withdrawn,
        review=ReviewState("to_review"),
        computing_id=None,
        verdict_of_revision=None,
        judged_revision=None,
    )
    return append_revision(
        session,
        before.id,
        to_come.revision,
        values,
        withdrawn=withdrawn,
        before=before,
        action=action,
        clicked_by=clicked_by,
        actor=actor,
        verdict_of_revision=carried,
        # a verdict that comes with it is read, and another person's name
        made_of=(
            partial(_complete_revision, session, to_come, ground, actor)
            if carried is None and clicked_by is None
            else partial(_as_stored, session)
        ),
    )


def verdict_that_stood(
    session: Session, kind: Reader[Any], series_id: int, values: MeasurementValues | ScanHeightValues
) -> int | None:
    """The newest judged of the revisions with this very content: the one that its verdict was given to."""
    (contact_x, contact_y), (target_x, target_y) = values.contact, values.target_point
    query = (
        kind.rows.where(measurements.c.series_id == series_id)
        .where(measurements.c.contact_x_px == contact_x, measurements.c.contact_y_px == contact_y)
        .where(measurements.c.target_x_px == target_x, measurements.c.target_y_px == target_y)
        .order_by(measurements.c.revision.desc())
    )
    history = (kind.read(row) for row in session.execute(query))
    return judged_alike(history, lambda one: same_height(one.values, values), lambda one: one.judged_revision)


def append_revision(
    session: Session,
    series_id: int,
    revision: int,
    values: MeasurementValues | ScanHeightValues,
    *,
    withdrawn: bool = False,
    before: _Made | None,
    action: AuditAction,
    clicked_by: Who | None = None,
    actor: int | None,
    verdict_of_revision: int | None = None,
    made_of: Callable[[Row[Any]], _Made],
) -> _Made:
    """Write a revision of checked content, with its event, and give it back: `made_of` its stored row."""
    stamps: dict[str, Any] = {"series_id": series_id, "revision": revision, "withdrawn": withdrawn}
    stamps["verdict_of_revision"] = verdict_of_revision
    stamps |= {"created_at": now(), "created_by": actor if clicked_by is None else clicked_by.id}
    row = session.execute(_insert_revision(), {**_row_of(values), **stamps}).one()
    made = made_of(row)
    then = None if before is None else _event_words(before)
    after = _event_after(made, to_plain_json(row_content(row._mapping)))
    trail.record(session, actor, action, "measurement", series_id, made.survey_id, then, after)
    return made


@cache
def _insert_revision() -> ReturningInsert[Any]:
    """Gives the row back as the database has it: what a verification hashes."""
    return insert(measurements).returning(measurements)


def _complete_revision(
    session: Session, to_come: Measurement, ground: Ground, actor: int | None, row: Row[Any]
) -> Measurement:
    """A revision with the number that it was given, and what the ground tells of it."""
    named = who(actor, ground.actor_name)
    made = replace(to_come, revision_id=row.id, created_at=row.created_at, created_by=named)
    return derived_from(session, made, ground.telling)


# Every column of a content: what is said of frames is said of no line, and the other way round.
_EMPTY: dict[str, Any] = {
    column.name: None
    for kind in (MeasurementValues, ScanHeightValues)
    for column in fields(kind)
    if column.name not in ("contact", "target_point")
}


def _row_of(values: MeasurementValues | ScanHeightValues) -> dict[str, Any]:
    row: dict[str, Any] = {one.name: getattr(values, one.name) for one in fields(values)}
    (row["contact_x_px"], row["contact_y_px"]) = row.pop("contact")
    (row["target_x_px"], row["target_y_px"]) = row.pop("target_point")
    row["more_frames"] = [to_plain_json(one) for one in values.more_frames]
    return {**_EMPTY, "made": "clicked", **row}


def _event_words(revision: Measurement | ScanHeight) -> JsonObject:
    """The few words of an event on a revision."""
    words = {name: getattr(revision.values, name) for name in _IN_EVENTS if hasattr(revision.values, name)}
    return {**words, "revision": revision.revision}


def _event_after(revision: Measurement | ScanHeight, content: JsonObject) -> JsonObject:
    """An event's words of a revision, and the whole row, to hold every input and figure to the chain."""
    after: JsonObject = {
        **_event_words(revision),
        "revision_id": revision.revision_id,
        **revision.place,
        "withdrawn": revision.withdrawn,
        "row": content,
        "content_sha256": content_hash(content),
    }
    if revision.repeat_of is not None:
        after["repeat_of"] = revision.repeat_of
    return after


@dataclass(frozen=True, slots=True, kw_only=True)
class ComputedAgain:
    """A revision to come of the same clicks: after which, its content, and the one whose verdict it keeps."""

    before: Measurement | ScanHeight
    values: MeasurementValues | ScanHeightValues
    verdict_of_revision: int | None = None


def append_computed_again(
    session: Session,
    survey_id: int,
    computing_id: int,
    computed: Sequence[ComputedAgain],
    *,
    action: AuditAction,
    actor: int | None,
) -> None:
    """Write thousands of revisions of the same clicks, each with its audit event.

    They stay by who clicked. The revisions before them are read in the same transaction.
    """
    moment = now()
    for at in range(0, len(computed), _SOME):
        some = computed[at : at + _SOME]
        ids = add_rows(session, measurements, [_row_again(one, computing_id, moment) for one in some])
        content_of = _contents(session, ids)
        events = [
            (
                recomputed.before.id,
                _event_words(recomputed.before),
                _event_after(_made_again(recomputed, row_id), content_of[row_id]),
            )
            for recomputed, row_id in zip(some, ids, strict=True)
        ]
        trail.record_many(session, actor, action, "measurement", survey_id, events)


def _row_again(computed: ComputedAgain, computing_id: int, moment: datetime) -> dict[str, Any]:
    return {
        **_row_of(computed.values),
        "series_id": computed.before.id,
        "revision": computed.before.revision + 1,
        "withdrawn": False,
        "computing_id": computing_id,
        "verdict_of_revision": computed.verdict_of_revision,
        "created_at": moment,
        "created_by": computed.before.created_by.id if computed.before.created_by else None,
    }


def _made_again(one: ComputedAgain, row_id: int) -> Measurement | ScanHeight:
    new: dict[str, Any] = {"revision": one.before.revision + 1, "values": one.values}
    return replace(one.before, revision_id=row_id, withdrawn=False, **new)


def _as_stored(session: Session, row: Row[Any]) -> Measurement:
    """A revision as the database gives it back."""
    return _measurement_of(session, session.execute(_revision(), {"of_revision": row.id}).one())


def _require_alone(session: Session, before: Measurement, target: str) -> None:
    """Raises Conflict where another measurement of the target stands on the vehicle."""
    if before.repeat_of is None:
        asked = {"of_vehicle": before.vehicle_id, "of_target": target, "but": before.id}
        other = session.execute(standing_measurement(), asked).scalar_one()
        if other is not None:
            raise _already_measured(session, other)


def _already_measured(session: Session, standing_id: int) -> Conflict:
    there = get_measurement(session, standing_id)
    name = name_or_somebody(there.created_by)
    return Conflict("measurements-already-measured", current=there, name=name)


def _repeated(session: Session, vehicle_id: int, repeat_of: int | None, target: str) -> int | None:
    """The first measurement that a new one repeats. Raises BadInput for another vehicle's or target's."""
    if repeat_of is None:
        return None
    first = get_measurement(session, repeat_of)
    if (first.vehicle_id, first.values.target) != (vehicle_id, target):
        raise BadInput("measurements-repeat-mismatch")
    return first.repeat_of or first.id
