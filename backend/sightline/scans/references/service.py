"""Reference values beside our own: the difference, and whether it is within the combined uncertainty."""

from collections.abc import Mapping
from typing import Any

from sightline.coverage import expanded
from sightline.infra.by_name import filled_from
from sightline.scans.records import ScanValues
from sightline.scans.references.records import (
    MEASURED,
    UNITS,
    ReferenceValues,
    ShownReference,
    StoredReference,
)
from sightline.statistics.references import Agreement, agreement

#: What of a motion is looked at.
LOOKED_AT = ("status", *(name for one in MEASURED.values() for name in (one, f"u_{one}")))


def shown_reference(reference: StoredReference, ours: ScanValues | None) -> ShownReference:
    """A reference beside our own stored value; None where the vehicle was never measured."""
    return filled_from(
        ShownReference,
        reference,
        reference.values,
        unit=UNITS[reference.values.quantity],
        U95=expanded(reference.values.u),
        agreement=beside_ours(ours, reference.values),
    )


def beside_ours(values: ScanValues | None, one: ReferenceValues) -> Agreement | None:
    """Our own stored value against a reference; `values` is None where the vehicle was never measured."""
    return compare_with_reference(
        None if values is None else {name: getattr(values, name) for name in LOOKED_AT}, one
    )


def compare_with_reference(motion: Mapping[str, Any] | None, reference: ReferenceValues) -> Agreement | None:
    """Our own value against a reference; None where there is no motion, or it was taken back.

    `motion`: its values by name, with `status`; None where the vehicle was never measured.
    """
    if motion is None or motion["status"] != "ok" or reference.withdrawn:
        return None
    name = MEASURED[reference.quantity]
    value, u = motion[name], motion[f"u_{name}"]
    if value is None or u is None:
        return None
    return agreement(value, u, reference.value, reference.u)
