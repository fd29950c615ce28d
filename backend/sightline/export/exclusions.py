"""The list of exclusions of an export: what counts for no result, and why. Made of the package's own rows."""

from collections.abc import Iterator, Mapping

from sightline.export.chosen import chosen_vehicles
from sightline.infra.csv_package.columns import code_in, code_of, key, text
from sightline.infra.csv_package.files import Files, read_columns, undo_safe_text
from sightline.infra.csv_package.schema import Cell, Table, ids_of
from sightline.measurements.csv import TARGETS
from sightline.measurements.sheets.csv import counting_in
from sightline.messages.said import Said

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
        key("measurement_id", "excluded measurement"),
        key("vehicle_id", "vehicle that was measured"),
        key("vehicle_number", "its number within the survey"),
        text("target", "what was measured", required=True, enum=TARGETS),
        text("state", "state for which it is excluded", required=True, enum=STATES),
        text("reason", "the reason in words", required=True),
        text("reason_code", "reason by code and values (JSON)"),
    ),
    primary=("measurement_id",),
    foreign=ids_of(measurement_id="measurements", vehicle_id="vehicles"),
)
_CHECK = "check_target", Said("excluded-check-target")
_OTHER = "not_selected", Said("excluded-not-selected")
_TIMELESS = "not_selected", Said("excluded-without-time")
_OUTSIDE = "out_of_sample", Said("excluded-out-of-sample")
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
        why = _find_exclusion(row) or apart.get(row["vehicle_id"])
        if why is not None:
            yield {
                "measurement_id": int(row["id"]),
                "vehicle_id": int(row["vehicle_id"]),
                "vehicle_number": numbers.get(row["vehicle_id"]),
                "target": row["target"],
                "state": why[0],
                "reason": why[1],
                "reason_code": code_of(why[1]),
            }


def _find_exclusion(row: Mapping[str, str]) -> tuple[str, Said] | None:
    if row["withdrawn"] == "true":
        return "withdrawn", Said("excluded-withdrawn")
    if row["status"] != "ok":
        return "not_measurable", reason_in(row) or Said("excluded-no-height")
    if row["verdict"] == "rejected":
        return "rejected", _of_person(row) or Said("excluded-rejected")
    if row["verdict"] == "to_review":
        return "to_review", Said("excluded-not-reviewed")
    if row["verdict"] == "reopened":
        return "to_review", _of_person(row) or Said("excluded-reopened")
    return None


def reason_in(row: Mapping[str, str]) -> Said | None:
    """Of what is missing; a package of an earlier program may have its words alone."""
    return code_in(undo_safe_text(row["reason_code"])) or (
        Said.read(undo_safe_text(row["reason"])) if row["reason"] else None
    )


def _of_person(row: Mapping[str, str]) -> Said | None:
    return Said("said", sentence=undo_safe_text(row["review_reason"])) if row["review_reason"] else None
