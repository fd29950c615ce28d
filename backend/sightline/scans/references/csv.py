"""The table of reference values in an export: every revision, and ours beside those that stand."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import get_args

from sightline.coverage import COVERAGE_95
from sightline.enums import ReferenceQuantity, ReferenceSource
from sightline.infra.csv_package.columns import columns_within, flag, key, moment, number, person, text
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.scans.references.records import UNITS, StoredReference
from sightline.statistics.references import Agreement


@dataclass(frozen=True, slots=True)
class ListedReference:
    """`current`: the newest of its vehicle, quantity and source. `found`: ours beside it, where it stands."""

    reference: StoredReference
    current: bool
    found: Agreement | None


SCAN_REFERENCES: Table[ListedReference] = Table(
    "scan_references",
    "What something else measured of scanned vehicles: every revision; the newest of a vehicle, quantity and "
    "source counts, unless it is withdrawn. Beside it how far the vehicle's own value is from it.",
    (
        *columns_within(
            "reference", key("id", "revision"), key("vehicle_id", "vehicle of a line-scan recording")
        ),
        *columns_within(
            "reference.values",
            text(
                "quantity",
                "speed: when the front reaches camera 1; length; wheelbase",
                required=True,
                enum=get_args(ReferenceQuantity),
            ),
            text(
                "source",
                "what measured it; counter: the car's own speedometer",
                required=True,
                enum=get_args(ReferenceSource),
            ),
        ),
        *columns_within("reference", key("revision", "number of the revision, from 1")),
        flag("current", "whether it is the newest revision", required=True),
        *columns_within(
            "reference.values", flag("withdrawn", "whether it takes the value back", required=True)
        ),
        text("unit", "unit of the row's figures", lambda one: UNITS[one.reference.values.quantity]),
        *columns_within(
            "reference.values",
            number("value", "the reference value", required=True),
            number("u", "standard uncertainty of value (k = 1)", required=True),
            text("device", "device or instrument, in words"),
        ),
        *columns_within(
            "found",
            number("difference", "measured value minus reference; empty if either is withdrawn or missing"),
            number(
                "u_difference", "standard uncertainty of the difference (k = 1), both taken as independent"
            ),
            number(
                "U95_difference",
                "half-width of its 95 % interval",
                of=lambda found: COVERAGE_95 * found.u_difference,
            ),
            number("E_n", "difference over U95_difference (ISO 13528)"),
            flag("within", "whether the difference is within U95_difference"),
        ),
        *columns_within(
            "reference",
            person("created_by_id", "who entered it"),
            moment("created_at", "when the revision was stored"),
        ),
    ),
    primary=("id",),
    foreign=ids_of(vehicle_id="scan_vehicles"),
)
#: The columns that follow from others.
FOLLOWING = ("current", "unit", "difference", "u_difference", "U95_difference", "E_n", "within")


def listed_references(
    history: Iterable[StoredReference], compare: Callable[[StoredReference], Agreement | None]
) -> list[ListedReference]:
    """The rows of a history, oldest first; `compare` compares one that stands."""
    told = list(history)
    newest = {(one.vehicle_id, one.values.quantity, one.values.source): one.id for one in told}
    rows = []
    for one in told:
        current = newest[one.vehicle_id, one.values.quantity, one.values.source] == one.id
        rows.append(ListedReference(one, current, compare(one) if current else None))
    return rows
