"""Vehicle records: their facts."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, get_args

from sqlalchemy import ColumnElement, Select, and_, func, select
from sqlalchemy.orm import Session

from sightline.enums import Direction, ModelSize
from sightline.errors import BadInput, Conflict
from sightline.geometry.sides import driver_side
from sightline.infra.audit.changing import alter_row, bring_back_row, change_since, make_rows, take_out_row
from sightline.infra.database.people import people
from sightline.infra.database.rows import get_row, missing, who
from sightline.infra.database.types import columns_of, now
from sightline.recordings.filming import filming_of
from sightline.recordings.frames.tables import frames
from sightline.recordings.tables import recordings
from sightline.statistics.sampling import PassTime, counts_in_results, headways, is_in_sample
from sightline.surveys.store import TRAFFIC, asked_of, sampling_of, traffic_of_row
from sightline.surveys.tables import surveys
from sightline.vehicles.records import (
    BY_SIZE,
    KNOWN,
    KNOWN_WITHIN_M,
    MOST_HEIGHT_M,
    NOT_VISIBLE,
    Vehicle,
    VehicleChanges,
    VehicleFields,
)
from sightline.vehicles.tables import vehicles


@dataclass(frozen=True, slots=True)
class PassSpan:
    """From which frame to which a pass goes, and which way; None where nobody said."""

    first_frame: int
    last_frame: int
    direction: Direction | None


@dataclass(frozen=True, slots=True)
class PassCount:
    """How many passes a recording has."""

    recording_id: int
    passes: int


#: A vehicle without lighting has its recording's.
LIGHT = func.coalesce(vehicles.c.lighting, recordings.c.lighting).label("light")
#: The first frame of a pass in its recording's frame table, and its time, seconds since the table's first.
FIRST = and_(frames.c.recording_id == vehicles.c.recording_id, frames.c.n == vehicles.c.first_frame)
FIRST_S = frames.c.time_s.label("first_s")
_ALIVE: ColumnElement[bool] = vehicles.c.deleted_at.is_(None)
_SKIPPED = ("created_at", "created_by", "updated_by", "deleted_at")
_FIELDS = frozenset(one.name for one in fields(VehicleFields))
_NAMED = [column.name for column in columns_of(vehicles, *_SKIPPED)]


def create_vehicle(
    session: Session, recording_id: int, fields: VehicleChanges, *, actor: int | None
) -> Vehicle:
    """A vehicle of a recording; `first_frame` and `last_frame` are needed. Numbers count up in the survey."""
    recording = get_row(session, recordings, recording_id, "recording", recordings.c.deleted_at.is_(None))
    if "first_frame" not in fields or "last_frame" not in fields:
        raise BadInput("vehicles-no-frames")
    _check_year(fields)
    content: dict[str, Any] = {**_empty(), **_check_fields(fields, recording["frame_count"])}
    survey_id = recording["survey_id"]
    counted = select(func.coalesce(func.max(vehicles.c.number), 0)).where(vehicles.c.survey_id == survey_id)
    place = {"survey_id": survey_id, "recording_id": recording_id}
    place["number"] = session.execute(counted).scalar_one() + 1
    told = [{**place, **content}]
    return get_vehicle(session, *make_rows(session, vehicles, told, survey_id=survey_id, actor=actor))


def get_vehicle(session: Session, vehicle_id: int, *, deleted: bool = False) -> Vehicle:
    """The facts of one vehicle. Raises NotFound; `deleted` also finds one that was deleted."""
    query = vehicle_rows(vehicles.c.id == vehicle_id, deleted=deleted)
    row = session.execute(query).mappings().one_or_none()
    if row is None:
        raise missing("vehicle", vehicle_id)
    return Vehicle(**facts_of_row(row, headways_needed(session, [row])))


def count_passes(session: Session, survey_id: int) -> tuple[PassCount, ...]:
    """How many passes each recording of a survey has, without those that were discarded."""
    query = (
        select(recordings.c.id, func.count(vehicles.c.id))
        .outerjoin(
            vehicles, and_(vehicles.c.recording_id == recordings.c.id, _ALIVE, vehicles.c.discarded.is_(None))
        )
        .where(recordings.c.survey_id == survey_id, recordings.c.deleted_at.is_(None))
        .group_by(recordings.c.id)
        .order_by(recordings.c.id)
    )
    return tuple(PassCount(*row) for row in session.execute(query))


def list_vehicles_of_recording(session: Session, recording_id: int) -> tuple[Vehicle, ...]:
    """The facts of the vehicles of a recording, by number."""
    rows = session.execute(vehicle_rows(vehicles.c.recording_id == recording_id)).mappings().all()
    headway_s = headways_needed(session, rows)
    return tuple(Vehicle(**facts_of_row(row, headway_s)) for row in rows)


def update_vehicle(
    session: Session, vehicle_id: int, changes: VehicleChanges, *, version: int | None, actor: int | None
) -> Vehicle:
    """Change fields. Raises Conflict, naming who and when, if a `version` is not the current one."""
    before = _current(session, vehicle_id, version)
    _check_year(changes)
    frame_count = get_row(session, recordings, before["recording_id"], "recording")["frame_count"]
    change = _check_fields({**_checked_with(before), **changes}, frame_count)
    alter_row(session, vehicles, before, change, actor=actor)
    return get_vehicle(session, vehicle_id)


def remove_vehicle(
    session: Session, vehicle_id: int, *, version: int | None = None, actor: int | None
) -> Vehicle:
    """Delete softly: out of all lists and counts, with its measurements; `restore` brings it back."""
    take_out_row(session, vehicles, _current(session, vehicle_id, version), "number", actor=actor)
    return get_vehicle(session, vehicle_id, deleted=True)


def restore_vehicle(session: Session, vehicle_id: int, *, actor: int | None) -> Vehicle:
    """Bring a deleted vehicle back. Raises Conflict for one not deleted, NotFound where its recording is."""
    before = get_row(session, vehicles, vehicle_id, "vehicle")
    get_row(session, recordings, before["recording_id"], "recording", recordings.c.deleted_at.is_(None))
    if before["deleted_at"] is None:
        raise Conflict("scans-vehicle-not-deleted")
    bring_back_row(session, vehicles, before, actor=actor)
    return get_vehicle(session, vehicle_id)


def pass_spans(session: Session, recording_id: int) -> tuple[PassSpan, ...]:
    """The spans of all passes of a recording, discarded ones too."""
    columns = (vehicles.c.first_frame, vehicles.c.last_frame, vehicles.c.direction)
    query = select(*columns).where(vehicles.c.recording_id == recording_id).order_by(vehicles.c.first_frame)
    return tuple(PassSpan(*row) for row in session.execute(query))


def _check_year(fields: VehicleChanges) -> None:
    """Next year's models are sold already, later ones are not."""
    year, most = fields.get("year"), now().year + 1
    if year is not None and year > most:
        raise BadInput("vehicles-year-to-come", year=str(year), most=str(most))


def _current(session: Session, vehicle_id: int, version: int | None) -> dict[str, Any]:
    row = get_row(session, vehicles, vehicle_id, "vehicle", _ALIVE)
    if by := change_since(session, row, version):
        raise Conflict("scans-vehicle-changed", name=by[0], when=by[1], number=row["number"])
    return row


def _empty() -> dict[str, Any]:
    return {**dict.fromkeys(_FIELDS, None), "notes": "", "origin": "person", "check_target": False}


def _checked_with(row: Mapping[str, Any]) -> dict[str, Any]:
    """What a change is checked together with."""
    names = ("first_frame", "last_frame", "best_frame", "model_chosen_by", "model_sizes")
    return {key: row[key] for key in names}


def _check_fields(fields: Mapping[str, Any], frame_count: int | None) -> dict[str, Any]:
    values = dict(fields)
    unknown = set(values) - _FIELDS
    if unknown:
        raise BadInput("vehicles-field-unknown", unknown=", ".join(sorted(unknown)))
    first, last, best = values["first_frame"], values["last_frame"], values.get("best_frame")
    end = last if frame_count is None else frame_count - 1
    if not 0 <= first <= last <= end:
        raise BadInput("vehicles-frames-outside", first=first, last=last, end=end)
    if best is not None and not first <= best <= last:
        raise BadInput("vehicles-best-frame-outside", best=best, first=first, last=last)
    for target, name in NOT_VISIBLE.items():
        if values.get(name) == "no_driver" and target != "driver_eye":
            raise BadInput("vehicles-no-driver-target", target=target)
    values["model_sizes"] = _sizes_of_choice(values.get("model_chosen_by"), values.get("model_sizes"))
    for known, names in KNOWN.items():
        height, u_height = values.get(names.height), values.get(names.u)
        if height is not None and not 0 < height <= MOST_HEIGHT_M:
            raise BadInput("vehicles-known-height-range", height=format(height, "g"))
        low, high = KNOWN_WITHIN_M[known]
        if height is not None and not low <= height <= high:
            given = format(height, "g")
            raise BadInput("vehicles-known-height-kind", target=known, height=given, low=low, high=high)
        if u_height is not None and not 0 <= u_height <= MOST_HEIGHT_M:
            raise BadInput("vehicles-u-range", u_height=format(u_height, "g"))
    return values


def _sizes_of_choice(chosen_by: str | None, sizes: str | None) -> str | None:
    """By which sizes a model was chosen; those of no choice fall away. Raises BadInput."""
    words = (sizes or "").split()
    unknown = next((word for word in words if word not in get_args(ModelSize)), None)
    if unknown is not None:
        raise BadInput("vehicles-model-size-unknown", size=unknown, known=", ".join(get_args(ModelSize)))
    if chosen_by == BY_SIZE and not words:
        raise BadInput("vehicles-model-without-sizes")
    return " ".join(dict.fromkeys(words)) or None if chosen_by is not None else None


def vehicle_rows(*where: ColumnElement[bool], deleted: bool = False) -> Select[Any]:
    """Vehicles by number, last changer and what their survey says, for `facts_of_row`; `deleted` too."""
    of_survey = (*(surveys.c[name] for name in TRAFFIC), surveys.c.asked, surveys.c.sampling)
    filmed = (recordings.c.started_at, recordings.c.time_zone, FIRST_S)
    query = select(vehicles, people.c.name.label("changer"), *of_survey, LIGHT, *filmed)
    query = query.join(surveys, surveys.c.id == vehicles.c.survey_id)
    query = query.join(recordings, recordings.c.id == vehicles.c.recording_id).outerjoin(frames, FIRST)
    query = query.outerjoin(people, people.c.id == vehicles.c.updated_by).order_by(vehicles.c.number)
    return query.where(*where) if deleted else query.where(*where, _ALIVE)


def headways_of(session: Session, recording_ids: Iterable[int]) -> dict[int, float]:
    """Seconds behind the pass before in its direction, by vehicle, in recordings with a frame table."""
    v = vehicles.c
    query = (
        select(v.id, v.recording_id, v.direction, FIRST_S, v.discarded)
        .join(frames, FIRST)
        .where(v.recording_id.in_(sorted(set(recording_ids))), _ALIVE)
    )
    return headways(
        PassTime(row.id, row.recording_id, row.direction, row.first_s, row.discarded is None)
        for row in session.execute(query)
    )


def vehicles_outside(session: Session, survey_ids: Sequence[int] | None = None) -> set[int]:
    """Living vehicles of these surveys, or of all, whose heights count nowhere by their survey's rule."""
    rules = {
        row.id: sampling_of(row.sampling)
        for row in session.execute(select(surveys.c.id, surveys.c.sampling))
        if survey_ids is None or row.id in survey_ids
    }
    rules = {id_: rule for id_, rule in rules.items() if rule.leaves_out}
    if not rules:
        return set()
    v = vehicles.c
    query = select(v.id, v.survey_id, v.number, v.recording_id).where(v.survey_id.in_(rules), _ALIVE)
    rows = session.execute(query).all()
    timed = {one.recording_id for one in rows if rules[one.survey_id].free_flowing_s is not None}
    headway_s = headways_of(session, timed) if timed else {}
    return {
        one.id for one in rows if not is_in_sample(rules[one.survey_id], one.number, headway_s.get(one.id))
    }


def headways_needed(session: Session, rows: Iterable[Mapping[Any, Any]]) -> dict[int, float]:
    """`headways_of` the rows of `vehicle_rows` whose survey takes free-flowing vehicles alone."""
    wanted = {row["recording_id"] for row in rows if row["sampling"]["free_flowing_s"] is not None}
    return headways_of(session, wanted) if wanted else {}


def facts_of_row(row: Mapping[Any, Any], headway_s: Mapping[int, float]) -> dict[str, Any]:
    """The fields of a Vehicle, from a row of `vehicle_rows` and `headways_needed`."""
    stored = {name: row[name] for name in _NAMED}
    changed = {"updated_by": who(row["updated_by"], row["changer"]), "deleted": row["deleted_at"] is not None}
    found = driver_side(row["driver_side"], row["direction"], traffic_of_row(row))
    side = {"side": found and found.side, "side_from": found and found.basis}
    rule = sampling_of(row["sampling"])
    chosen = is_in_sample(rule, row["number"], headway_s.get(row["id"]))
    answers = {"asked": asked_of(row["asked"]).of(row["light"]), "in_sample": chosen}
    answers["counts"] = counts_in_results(rule, chosen, row["check_target"])
    filming, first_s = filming_of(row), row["first_s"]
    filmed_at = None if filming is None or first_s is None else filming.at(first_s)
    return {**stored, **changed, **side, **answers, "first_s": first_s, "filmed_at": filmed_at}
