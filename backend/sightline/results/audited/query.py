"""Reading the audit trail with the names of what its events are about."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from sqlalchemy import ColumnElement, and_, or_, select
from sqlalchemy.orm import Session

from sightline.cameras.tables import cameras
from sightline.infra.audit import trail
from sightline.infra.audit.records import AuditEvent, Who
from sightline.infra.audit.tables import audit_events
from sightline.infra.database.people import people
from sightline.infra.jobs.tables import jobs
from sightline.measurements.tables import measurement_series, measurements, reviews, wheel_pairs
from sightline.recordings.tables import recordings
from sightline.results.audited.records import NamedEvent, Subject
from sightline.scans.tables import scan_vehicles, scans
from sightline.surveys.tables import surveys
from sightline.vehicles.tables import vehicles

#: Kinds of things that have a name of their own, and the column that holds it; a job has its kind.
_NAMED = {
    "survey": surveys.c.name,
    "camera": cameras.c.name,
    "recording": recordings.c.name,
    "scan": scans.c.name,
    "person": people.c.name,
    "job": jobs.c.kind,
}
_e = audit_events.c


def with_names(session: Session, events: Sequence[AuditEvent]) -> tuple[NamedEvent, ...]:
    """Events with the names of what they are about, in their order."""
    names = _names(session, events)
    of_surveys = _by_id(session, surveys.c.name, (event.survey_id for event in events))
    subjects = _subjects(session, events)
    return tuple(
        NamedEvent(
            event,
            Subject(
                survey=of_surveys.get(event.survey_id),
                name=names.get((event.entity, event.entity_id)),
                **subjects.get(event.id, {}),
            ),
        )
        for event in events
    )


def acting_people(session: Session, seen: Collection[int] | None = None) -> tuple[Who, ...]:
    """Those who did something, by name; `seen`: to these surveys or the catalogue."""
    acted = select(_e.actor_id) if seen is None else select(_e.actor_id).where(trail.in_sight(seen))
    query = select(people.c.id, people.c.name).where(people.c.id.in_(acted))
    return tuple(Who(row.id, row.name) for row in session.execute(query.order_by(people.c.name)))


def of_vehicle(number: int, survey_id: int | None) -> ColumnElement[bool]:
    """Events of the vehicles with this number: their records, measurements, verdicts and tyres."""
    mine = select(vehicles.c.id).where(vehicles.c.number == number)
    if survey_id is not None:
        mine = mine.where(vehicles.c.survey_id == survey_id)
    series = select(measurement_series.c.id).where(measurement_series.c.vehicle_id.in_(mine))
    judged = select(reviews.c.id).where(reviews.c.series_id.in_(series))
    pairs = select(wheel_pairs.c.id).where(wheel_pairs.c.vehicle_id.in_(mine))
    kinds = (("vehicle", mine), ("measurement", series), ("review", judged), ("wheel_pair", pairs))
    return or_(*(and_(_e.entity == kind, _e.entity_id.in_(ids)) for kind, ids in kinds))


def _names(session: Session, found: Sequence[AuditEvent]) -> dict[tuple[str, int | None], str]:
    names: dict[tuple[str, int | None], str] = {}
    for kind, column in _NAMED.items():
        ids = [one.entity_id for one in found if one.entity == kind]
        names |= {(kind, id_): name for id_, name in _by_id(session, column, ids).items()}
    return names


def _by_id(session: Session, column: Any, ids: Iterable[int | None]) -> dict[int | None, Any]:
    wanted = {id_ for id_ in ids if id_ is not None}
    if not wanted:
        return {}
    key = column.table.c.id
    return {row[0]: row[1] for row in session.execute(select(key, column).where(key.in_(wanted)))}


def _subjects(session: Session, events: Sequence[AuditEvent]) -> dict[int, dict[str, Any]]:
    """Vehicle and target of each event that has them, by event."""
    of_series = _series(session, events)
    vehicle_of = {
        **{one.id: one.entity_id for one in events if one.entity == "vehicle"},
        **{
            one.id: _number_in_event(one, "vehicle_id")
            for one in events
            if one.entity in ("wheel_pair", "measurement")
        },
        **{id_: of["vehicle_id"] for id_, of in of_series.items()},
    }
    numbers = _by_id(session, vehicles.c.number, vehicle_of.values())
    subjects: dict[int, dict[str, Any]] = {
        id_: {"vehicle_id": vehicle, "vehicle": numbers[vehicle], **_target(of_series.get(id_))}
        for id_, vehicle in vehicle_of.items()
        if vehicle in numbers
    }
    scanned = {
        one.id: one.entity_id if one.entity == "scan_vehicle" else _number_in_event(one, "scan_vehicle_id")
        for one in events
        if one.entity in ("scan_vehicle", "measurement", "review")
    }
    of_scans = _by_id(session, scan_vehicles.c.number, scanned.values())
    for id_, one in scanned.items():
        if one in of_scans:
            subjects[id_] = {"vehicle_id": one, "vehicle": of_scans[one]}
    return subjects


def _target(series: Mapping[str, Any] | None) -> dict[str, Any]:
    """A repeat stands in the review of what it repeats, and in no list of its own."""
    if series is None:
        return {}
    return {"target": series["target"], "measurement_id": series["repeat_of"] or series["id"]}


def _number_in_event(event: AuditEvent, name: str) -> int | None:
    for state in (event.after, event.before):
        if state and isinstance(state.get(name), int):
            return int(state[name])
    return None


def _series(session: Session, events: Sequence[AuditEvent]) -> dict[int, dict[str, Any]]:
    """The measurement of each event on one, or on a verdict: its vehicle and target."""
    judged = {one.id: one.entity_id for one in events if one.entity == "review"}
    rows = session.execute(select(reviews.c.id, reviews.c.series_id).where(reviews.c.id.in_(judged.values())))
    of_review = {row.id: row.series_id for row in rows} if judged else {}
    series_of = {one.id: one.entity_id for one in events if one.entity == "measurement"}
    series_of |= {id_: of_review.get(review) for id_, review in judged.items()}
    wanted = {one for one in series_of.values() if one is not None}
    query = (
        select(
            *(measurement_series.c.id, measurement_series.c.vehicle_id, measurement_series.c.repeat_of),
            measurements.c.target,
        )
        .join(measurements, measurements.c.series_id == measurement_series.c.id)
        .where(measurement_series.c.id.in_(wanted), measurements.c.revision == 1)
    )
    known = {row.id: dict(row._mapping) for row in session.execute(query)} if wanted else {}
    return {id_: known[series] for id_, series in series_of.items() if series in known}
