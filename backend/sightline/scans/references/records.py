"""Records of reference values: what something else measured of a scanned vehicle, and of their import."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import ReferenceChange, ReferenceQuantity, ReferenceSource
from sightline.errors import BadInput
from sightline.infra.audit.records import Who
from sightline.messages.said import Said
from sightline.statistics.references import Agreement

#: What of a motion is compared with a reference; its u stands under the same name with u_ before it.
MEASURED: dict[ReferenceQuantity, str] = {
    "speed": "speed_mps",
    "length": "length_m",
    "wheelbase": "wheelbase_m",
}
UNITS: dict[ReferenceQuantity, str] = {"speed": "m/s", "length": "m", "wheelbase": "m"}
_LEAST: dict[ReferenceQuantity, float] = {"speed": 0.0, "length": 0.3, "wheelbase": 0.3}
_MOST: dict[ReferenceQuantity, float] = {"speed": 150.0, "length": 100.0, "wheelbase": 100.0}
MOST_DEVICE = 200


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit by its name; `si`: how many m/s or metres it is."""

    name: str
    si: float


@dataclass(frozen=True, slots=True)
class ReferenceValues:
    """One value in m/s or m with its standard uncertainty (k = 1); `device`: which radar, whose tape."""

    quantity: ReferenceQuantity
    source: ReferenceSource
    value: float
    u: float
    device: str | None = None
    withdrawn: bool = False


@dataclass(frozen=True, slots=True)
class StoredReference:
    """A revision of a value by one source; the newest of a vehicle, quantity and source counts."""

    id: int
    scan_id: int
    vehicle_id: int
    revision: int
    values: ReferenceValues
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class ShownReference(ReferenceValues):
    """What one source says of a vehicle, beside our own value."""

    unit: str
    U95: float
    revision: int
    agreement: Annotated[
        Agreement | None, Field(description="null: there is no value of ours to compare with.")
    ]
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True)
class ReferenceRow:
    """What an import does with one line of a file, and why; `given`: its values as they were read.

    `time`: as it stands in the line; `apart_s`: that minus the vehicle's own; `by_time`: the vehicle follows
    from it.
    """

    line: int
    number: str
    time: str
    apart_s: float | None
    by_time: bool
    source: str
    given: tuple[ReferenceValues, ...]
    run_of: str | None
    change: ReferenceChange
    words: tuple[Said, ...]


@dataclass(frozen=True)
class ReferencePlan:
    """What an import would do: nothing is stored yet. `rows`: the first of many, those to look at first.

    `tolerance_s`: within which a line's time is that of a vehicle; None for a file without times. `notes`:
    what is to be said of the times as a whole.
    """

    counts: dict[ReferenceChange, int]
    rows: tuple[ReferenceRow, ...]
    tolerance_s: float | None = None
    notes: tuple[Said, ...] = ()


@dataclass(frozen=True)
class ReferencesImported:
    """What came of an import: values and names of cars that were stored, lines that were refused."""

    values: int
    cars: int
    plan: ReferencePlan


def require_reference(reference: ReferenceValues, given_in: Unit | None = None) -> None:
    """Raise BadInput for a value that no vehicle has, or one without an uncertainty, in the unit in which it
    was given.
    """
    unit = given_in or Unit(UNITS[reference.quantity], 1.0)
    value = f"{reference.value / unit.si:.7g}"
    if not _LEAST[reference.quantity] < reference.value <= _MOST[reference.quantity]:
        raise BadInput(
            "reference-value-cannot-be",
            quantity=reference.quantity,
            value=value,
            unit=unit.name,
            least=f"{_LEAST[reference.quantity] / unit.si:g}",
            most=f"{_MOST[reference.quantity] / unit.si:g}",
        )
    if not 0 < reference.u <= reference.value:
        raise BadInput(
            "reference-u-cannot-be",
            quantity=reference.quantity,
            u=f"{reference.u / unit.si:.7g}",
            value=value,
            unit=unit.name,
        )
    if reference.device is not None and len(reference.device) > MOST_DEVICE:
        raise BadInput("reference-device-too-long", most=MOST_DEVICE)
