"""The queries by which scanned vehicles and their measurements are read."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from sqlalchemy import ColumnElement, Select, Text, exists, func, select, type_coerce
from sqlalchemy.orm import Session

from sightline.infra.audit.written import written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import who
from sightline.measurements.records import ReviewState
from sightline.scans.records import ScanMeasurement, ScanReview, ScanValues, ScanVehicle
from sightline.scans.tables import scan_measurements, scan_reviews, scan_vehicles

_later = scan_measurements.alias("later")
_maker = people.alias("maker")
_reviewer = people.alias("reviewer")
_changer = people.alias("changer")
_VALUES = tuple(one.name for one in fields(ScanValues))
_LISTED = tuple(name for name in _VALUES if name != "profile")
_OF_VEHICLE = tuple(
    one.name for one in fields(ScanVehicle) if one.name not in ("updated_by", "deleted", "measurement")
)

#: True for the newest revision of each vehicle.
is_current: ColumnElement[bool] = ~exists().where(
    _later.c.vehicle_id == scan_measurements.c.vehicle_id, _later.c.revision > scan_measurements.c.revision
)
_newest_review = (
    select(func.max(scan_reviews.c.id))
    .where(scan_reviews.c.measurement_id.in_((scan_measurements.c.id, scan_measurements.c.verdict_of_id)))
    .correlate(scan_measurements)
    .scalar_subquery()
)


_PLACE = ("id", "survey_id", "scan_id", "vehicle_id", "revision", "created_at", "verdict_of_id")


def _columns(names: tuple[str, ...]) -> list[Any]:
    return [
        *(scan_measurements.c[name].label(f"m_{name}") for name in (*names, *_PLACE, "created_by")),
        _maker.c.name.label("maker_name"),
        scan_reviews.c.verdict,
        scan_reviews.c.measurement_id.label("judged_id"),
        scan_reviews.c.reason.label("review_reason"),
        scan_reviews.c.created_by.label("reviewed_by"),
        scan_reviews.c.created_at.label("reviewed_at"),
        _reviewer.c.name.label("reviewer_name"),
    ]


def scan_revision_rows(*, profile: bool = True) -> Select[Any]:
    """Whole revisions, for `measurement`; add the conditions and the order."""
    return (
        select(*_columns(_VALUES if profile else _LISTED))
        .select_from(scan_measurements)
        .outerjoin(scan_reviews, scan_reviews.c.id == _newest_review)
        .outerjoin(_maker, _maker.c.id == scan_measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == scan_reviews.c.created_by)
    )


def scan_vehicle_rows(*, profile: bool = False) -> Select[Any]:
    """Vehicles with their current revisions, for `vehicle`; add the conditions and the order."""
    return (
        select(
            *(scan_vehicles.c[name] for name in _OF_VEHICLE),
            scan_vehicles.c.updated_by,
            scan_vehicles.c.deleted_at,
            _changer.c.name.label("changer_name"),
            *_columns(_VALUES if profile else _LISTED),
        )
        .select_from(scan_vehicles)
        .outerjoin(scan_measurements, (scan_measurements.c.vehicle_id == scan_vehicles.c.id) & is_current)
        .outerjoin(scan_reviews, scan_reviews.c.id == _newest_review)
        .outerjoin(_maker, _maker.c.id == scan_measurements.c.created_by)
        .outerjoin(_reviewer, _reviewer.c.id == scan_reviews.c.created_by)
        .outerjoin(_changer, _changer.c.id == scan_vehicles.c.updated_by)
    )


def scan_vehicle_states(*conditions: ColumnElement[bool]) -> Select[Any]:
    """(scan, status, verdict, rig's text, lane, direction) of each living vehicle: what counts come from."""
    return (
        select(
            scan_vehicles.c.scan_id,
            scan_measurements.c.status,
            scan_reviews.c.verdict,
            type_coerce(scan_measurements.c.rig, Text),
            scan_measurements.c.lane,
            scan_measurements.c.direction,
        )
        .select_from(scan_vehicles)
        .outerjoin(scan_measurements, (scan_measurements.c.vehicle_id == scan_vehicles.c.id) & is_current)
        .outerjoin(scan_reviews, scan_reviews.c.id == _newest_review)
        .where(scan_vehicles.c.deleted_at.is_(None), *conditions)
    )


def scan_vehicle_of_row(row: Mapping[Any, Any]) -> ScanVehicle:
    """The record of a row of `vehicles()`."""
    return ScanVehicle(
        **{name: row[name] for name in _OF_VEHICLE},
        updated_by=who(row["updated_by"], row["changer_name"]),
        deleted=row["deleted_at"] is not None,
        measurement=None if row["m_id"] is None else scan_measurement_of_row(row),
    )


def scan_measurement_of_row(row: Mapping[Any, Any]) -> ScanMeasurement:
    """The record of a row of `revisions()`."""
    values = {name: row[f"m_{name}"] for name in _LISTED}
    review = ReviewState("to_review")
    if row["verdict"] is not None:
        reviewer = who(row["reviewed_by"], row["reviewer_name"])
        review = ReviewState(row["verdict"], row["review_reason"], reviewer, row["reviewed_at"])
    return ScanMeasurement(
        **{name: row[f"m_{name}"] for name in _PLACE},
        values=ScanValues(profile=row.get("m_profile"), **values),
        created_by=who(row["m_created_by"], row["maker_name"]),
        review=review,
        judged_id=row["judged_id"],
    )


def reviews_where(session: Session, condition: ColumnElement[bool]) -> tuple[ScanReview, ...]:
    """The verdicts that meet a condition, oldest first."""
    of = (scan_measurements.c.vehicle_id, scan_measurements.c.revision)
    rows = written_rows(session, scan_reviews, condition, beside=of, of=scan_measurements)
    return tuple(record_of(ScanReview, row, reviewer=row["created_by"], at=row["created_at"]) for row in rows)
