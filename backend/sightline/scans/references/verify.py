"""Making again what follows from the reference values of an export: which stand, and ours beside them."""

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.schema import cell_text
from sightline.scans.references.csv import FOLLOWING, SCAN_REFERENCES, listed_references
from sightline.scans.references.records import ReferenceValues, StoredReference
from sightline.scans.references.service import compare_with_reference

Row = Mapping[str, str]
_UNKNOWN = datetime(1, 1, 1, tzinfo=UTC)  # no column that is made again holds it


def check_references(
    rows: Mapping[int, Row],
    vehicles: Mapping[int, Row],
    events: Mapping[str, Mapping[int, Mapping[str, Any]]],
) -> None:
    """Compare and compute again, from the events of references and current motions. Raises Damaged."""
    history = [_reference_of_event(number, events["scan_reference"][number]) for number in sorted(rows)]
    motions = {
        number: events["scan_measurement"][int(row["measurement_id"])] if row["measurement_id"] else None
        for number, row in vehicles.items()
    }
    for listed in listed_references(
        history, lambda one: compare_with_reference(motions[one.vehicle_id], one.values)
    ):
        for column in SCAN_REFERENCES.columns:
            if column.name not in FOLLOWING:
                continue
            if rows[listed.reference.id][column.name] != cell_text(column, column.of_object(listed)):
                raise Damaged(
                    "scans-reference-differs",
                    path=SCAN_REFERENCES.key,
                    name=column.name,
                    number=listed.reference.id,
                )


def _reference_of_event(number: int, after: Mapping[str, Any]) -> StoredReference:
    return StoredReference(
        id=number,
        scan_id=after["scan_id"],
        vehicle_id=after["vehicle_id"],
        revision=after["revision"],
        values=ReferenceValues(**{name: after[name] for name in ReferenceValues.__slots__}),
        created_by=None,
        created_at=_UNKNOWN,
    )
