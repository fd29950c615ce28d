"""The list of exclusions of an export: what counts for no result, and why. Made of the package's own rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sightline.export.chosen import chosen_vehicles
from sightline.infra.csv_package.files import Files, read_columns, unsafe
from sightline.infra.csv_package.schema import Cell, Column, Table
from sightline.measurements.csv import TARGETS
from sightline.measurements.sheets.csv import counting_in

STATES = (
    "withdrawn",
    "not_measurable",
    "rejected",
    "to_review",
    "not_selected",
    "check_target",
    "out_of_sample",
)

EXCLUSIONS = Table(
    "exclusions",
    "The measurements that count for no result in statistics/, and why: withdrawn, without a height, "
    "rejected, not accepted yet, of a vehicle that the package is not of (selection.csv), of a check "
    "target, whose errors alone are stated (statistics/errors_by_target.csv), or of a vehicle out of the "
    "sample (sampling.csv).",
    (
        Column("measurement_id", "integer", "excluded measurement", required=True),
        Column("vehicle_id", "integer", "vehicle that was measured", required=True),
        Column("vehicle_number", "integer", "its number within the survey", required=True),
        Column("target", "string", "what was measured", required=True, enum=TARGETS),
        Column("state", "string", "state for which it is excluded", required=True, enum=STATES),
        Column("reason", "string", "the reason in words", required=True),
        Column("reason_code", "string", "of a height that is missing: why, by code and values (JSON)"),
    ),
    primary=("measurement_id",),
    foreign=((("measurement_id",), "measurements", ("id",)), (("vehicle_id",), "vehicles", ("id",))),
)
_CHECK = "check_target", "It checks the measuring: its errors are in statistics/errors_by_target.csv."
_OTHER = "not_selected", "It is not among the vehicles of this package."
_TIMELESS = (
    "not_selected",
    "This package is of days or hours of filming, and the start of its recording is not confirmed.",
)
_OUTSIDE = "out_of_sample", "Its vehicle is out of the survey's sample."
_READ = (
    "id",
    "vehicle_id",
    "target",
    "withdrawn",
    "status",
    "reason",
    "reason_code",
    "verdict",
    "review_reason",
)


def exclusion_rows(files: Files) -> Iterator[dict[str, Cell]]:
    """Rows by measurement, from measurements.csv and vehicles.csv."""
    numbers, apart = {}, {}
    counts = counting_in(files)
    for id_, number, check in read_columns(files, "vehicles.csv", ("id", "number", "check_target")):
        numbers[id_] = int(number)
        if not counts[id_]:
            apart[id_] = _CHECK if check == "true" else _OUTSIDE
    chosen = chosen_vehicles(files)
    for id_ in numbers.keys() - chosen.of:
        apart[id_] = _TIMELESS if id_ in chosen.without_time else _OTHER
    for values in read_columns(files, "measurements.csv", _READ):
        row = dict(zip(_READ, values, strict=True))
        why = _why(row) or apart.get(row["vehicle_id"])
        if why is not None:
            yield {
                "measurement_id": int(row["id"]),
                "vehicle_id": int(row["vehicle_id"]),
                "vehicle_number": numbers.get(row["vehicle_id"]),
                "target": row["target"],
                "state": why[0],
                "reason": why[1],
                "reason_code": unsafe(row["reason_code"]) or None if why[0] == "not_measurable" else None,
            }


def _why(row: Mapping[str, str]) -> tuple[str, str] | None:
    if row["withdrawn"] == "true":
        return "withdrawn", "The measurement was withdrawn."
    if row["status"] != "ok":
        return "not_measurable", unsafe(row["reason"]) or "There is no height."
    if row["verdict"] == "rejected":
        return "rejected", unsafe(row["review_reason"]) or "It was rejected by a reviewer."
    if row["verdict"] == "to_review":
        return "to_review", "It has not been reviewed yet."
    if row["verdict"] == "reopened":
        return "to_review", unsafe(row["review_reason"]) or (
            "It was reopened and is waiting for another review."
        )
    return None
