"""Vehicle records. Their state follows from their measurements and is never stored."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.enums import REQUIRED_TARGETS, Direction, VehicleState
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, change_row, get_row, missing, name_of, who
from sightline.infra.database.types import columns_of, now
from sightline.measurements.query import measurements_of_vehicles
from sightline.measurements.records import Measurement, Vehicle
from sightline.measurements.tables import measurement_series, measurements, wheel_pairs
from sightline.recordings.tables import recordings
from sightline.vehicles.records import MOST_HEIGHT_M, VehicleChanges
from sightline.vehicles.tables import vehicles


@dataclass(frozen=True, slots=True)
class PassSpan:
    """From which frame to which a pass goes, and which way; None where nobody said."""

    first_frame: int
    last_frame: int
    direction: Direction | None


_ALIVE: ColumnElement[bool] = vehicles.c.deleted_at.is_(None)
_FIELDS = frozenset(VehicleChanges.__annotations__)
_SKIPPED = ("created_at", "created_by", "updated_by", "deleted_at")
_NAMED = [column.name for column in columns_of(vehicles, *_SKIPPED)]


def create_vehicle(
    session: Session, recording_id: int, fields: VehicleChanges, *, actor: int | None
) -> Vehicle:
    """A vehicle of a recording; `first_frame` and `last_frame` are needed. Numbers count up in the survey."""
    recording = get_row(session, recordings, recording_id, "recording", recordings.c.deleted_at.is_(None))
    if "first_frame" not in fields or "last_frame" not in fields:
        raise BadInput("A vehicle needs its first and last frame; mark the pass on the timeline.")
    content: dict[str, Any] = {**_empty(), **_checked(fields, recording["frame_count"])}
    survey_id, moment = recording["survey_id"], now()
    counted = select(func.coalesce(func.max(vehicles.c.number), 0)).where(vehicles.c.survey_id == survey_id)
    place = {"survey_id": survey_id, "recording_id": recording_id}
    place["number"] = session.execute(counted).scalar_one() + 1
    stamps = {"version": 1, "created_at": moment, "created_by": actor}
    stamps |= {"updated_at": moment, "updated_by": actor}
    vehicle_id = add_row(session, vehicles, {**content, **place, **stamps})
    trail.record(session, actor, "create", "vehicle", vehicle_id, survey_id, None, {**place, **content})
    return get_vehicle(session, vehicle_id)


def get_vehicle(session: Session, vehicle_id: int, *, deleted: bool = False) -> Vehicle:
    """One vehicle with its measurements. Raises NotFound; `deleted` also finds one that was deleted."""
    found = _fetch(
        session, [vehicles.c.id == vehicle_id], [measurement_series.c.vehicle_id == vehicle_id], deleted
    )
    if not found:
        raise missing("vehicle", vehicle_id)
    return found[0]


def list_vehicles(
    session: Session, survey_id: int, *, recording_id: int | None = None
) -> tuple[Vehicle, ...]:
    """The vehicles of a survey or of one recording by number, with measurements; two queries."""
    where = [vehicles.c.survey_id == survey_id]
    of_these = [measurement_series.c.survey_id == survey_id]
    if recording_id is not None:
        where.append(vehicles.c.recording_id == recording_id)
        of_these.append(measurement_series.c.recording_id == recording_id)
    return _fetch(session, where, of_these, False)


def list_vehicles_by_id(session: Session, ids: Iterable[int]) -> tuple[Vehicle, ...]:
    """Those of these vehicles that were not deleted, by number, with measurements; two queries."""
    chosen = sorted(set(ids))
    of_these = [measurement_series.c.vehicle_id.in_(chosen)]
    return _fetch(session, [vehicles.c.id.in_(chosen)], of_these, False)


def update_vehicle(
    session: Session, vehicle_id: int, changes: VehicleChanges, *, version: int, actor: int | None
) -> Vehicle:
    """Change fields. Raises Conflict, naming who and when, if `version` is not the current one."""
    before = _current(session, vehicle_id, version)
    frame_count = get_row(session, recordings, before["recording_id"], "recording")["frame_count"]
    change = _checked({**_span(before), **changes}, frame_count)
    stamps = {"version": version + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, vehicles, vehicle_id, {**change, **stamps})
    what = trail.changed(before, change, change)
    trail.record(session, actor, "update", "vehicle", vehicle_id, before["survey_id"], *what)
    return get_vehicle(session, vehicle_id)


def remove_vehicle(
    session: Session, vehicle_id: int, *, version: int | None = None, actor: int | None
) -> Vehicle:
    """Delete softly: out of all lists and counts, with its measurements; `restore` brings it back."""
    before = _current(session, vehicle_id, version)
    stamps = {"version": before["version"] + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, vehicles, vehicle_id, {"deleted_at": stamps["updated_at"], **stamps})
    then = {"number": before["number"], "deleted": False}
    trail.record(
        session, actor, "delete", "vehicle", vehicle_id, before["survey_id"], then, {"deleted": True}
    )
    return get_vehicle(session, vehicle_id, deleted=True)


def restore_vehicle(session: Session, vehicle_id: int, *, actor: int | None) -> Vehicle:
    """Bring a deleted vehicle back. Raises Conflict for one that is not deleted."""
    before = get_row(session, vehicles, vehicle_id, "vehicle")
    if before["deleted_at"] is None:
        raise Conflict("This vehicle was not deleted, so there is nothing to restore.")
    stamps = {"version": before["version"] + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, vehicles, vehicle_id, {"deleted_at": None, **stamps})
    then, after = {"deleted": True}, {"deleted": False}
    trail.record(session, actor, "restore", "vehicle", vehicle_id, before["survey_id"], then, after)
    return get_vehicle(session, vehicle_id)


def pass_spans(session: Session, recording_id: int) -> tuple[PassSpan, ...]:
    """The spans of all passes of a recording, discarded ones too."""
    columns = (vehicles.c.first_frame, vehicles.c.last_frame, vehicles.c.direction)
    query = select(*columns).where(vehicles.c.recording_id == recording_id).order_by(vehicles.c.first_frame)
    return tuple(
        PassSpan(first_frame=row.first_frame, last_frame=row.last_frame, direction=row.direction)
        for row in session.execute(query)
    )


def frames_used_of_vehicle(session: Session, vehicle_id: int) -> tuple[tuple[int, ...], ...]:
    """The frames of each measurement of a vehicle as it is now, withdrawn ones and repeats too."""
    newest = (
        select(measurements.c.series_id, func.max(measurements.c.revision).label("revision"))
        .join(measurement_series, measurement_series.c.id == measurements.c.series_id)
        .where(measurement_series.c.vehicle_id == vehicle_id)
        .group_by(measurements.c.series_id)
        .subquery()
    )
    query = select(measurements.c.frame, measurements.c.more_frames).join(
        newest,
        (newest.c.series_id == measurements.c.series_id) & (newest.c.revision == measurements.c.revision),
    )
    clicked = [(frame, *(int(one["frame"]) for one in more or ())) for frame, more in session.execute(query)]
    pairs = select(wheel_pairs.c.frame).where(wheel_pairs.c.vehicle_id == vehicle_id)
    return (*clicked, *((int(frame),) for frame in session.execute(pairs).scalars()))


def state_of(found: Sequence[Measurement]) -> VehicleState:
    """What a vehicle's standing measurements make of it (roof, eye and taillight are asked for)."""
    verdicts = {one.review.verdict for one in found}
    if "rejected" in verdicts:
        return "rejected"
    if not set(REQUIRED_TARGETS) <= {one.values.target for one in found}:
        return "partial" if found else "to_do"
    return "accepted" if verdicts <= {"accepted", "fixed"} else "measured"


def _current(session: Session, vehicle_id: int, version: int | None) -> dict[str, Any]:
    row = get_row(session, vehicles, vehicle_id, "vehicle", _ALIVE)
    if version is not None and row["version"] != version:
        name, when = name_of(session, row["updated_by"]), f"{row['updated_at']:%Y-%m-%d %H:%M:%S} UTC"
        raise Conflict(f"{name} changed vehicle {row['number']} at {when}; look again and redo yours.")
    return row


def _empty() -> dict[str, Any]:
    return {**dict.fromkeys(_FIELDS, None), "notes": "", "origin": "person"}


def _span(row: Mapping[str, Any]) -> dict[str, Any]:
    return {key: row[key] for key in ("first_frame", "last_frame", "best_frame")}


def _checked(fields: Mapping[str, Any], frame_count: int | None) -> dict[str, Any]:
    values = dict(fields)
    unknown = set(values) - _FIELDS
    if unknown:
        raise BadInput(f"A vehicle has no {', '.join(sorted(unknown))}; leave it out.")
    first, last, best = values["first_frame"], values["last_frame"], values.get("best_frame")
    end = last if frame_count is None else frame_count - 1
    if not 0 <= first <= last <= end:
        raise BadInput(f"Frames {first} to {last} are not a span of this recording; it ends at frame {end}.")
    if best is not None and not first <= best <= last:
        raise BadInput(f"The best frame {best} lies outside frames {first} to {last}; choose one of them.")
    height, u_height = values.get("manufacturer_height_m"), values.get("u_manufacturer_height_m")
    if height is not None and not 0 < height <= MOST_HEIGHT_M:
        raise BadInput(
            f"A manufacturer's height of {height:g} m cannot be used; give it in metres, as in 1.624."
        )
    if u_height is not None and not 0 <= u_height <= MOST_HEIGHT_M:
        raise BadInput(f"An uncertainty of {u_height:g} m cannot be used; give it in metres, as in 0.005.")
    return values


def _fetch(
    session: Session,
    where: Iterable[ColumnElement[bool]],
    of_these: Iterable[ColumnElement[bool]],
    deleted: bool,
) -> tuple[Vehicle, ...]:
    query = (
        select(vehicles, people.c.name.label("changer"))
        .outerjoin(people, people.c.id == vehicles.c.updated_by)
        .where(*where)
        .order_by(vehicles.c.number)
    )
    rows = session.execute(query if deleted else query.where(_ALIVE)).mappings().all()
    found = measurements_of_vehicles(session, of_these) if rows else {}
    return tuple(_vehicle(row, tuple(found.get(row["id"], ()))) for row in rows)


def _vehicle(row: Mapping[Any, Any], found: tuple[Measurement, ...]) -> Vehicle:
    return Vehicle(
        updated_by=who(row["updated_by"], row["changer"]),
        deleted=row["deleted_at"] is not None,
        state=state_of(found),
        measurements=found,
        **{name: row[name] for name in _NAMED},
    )
