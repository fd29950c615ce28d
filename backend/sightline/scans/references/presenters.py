"""Reference values as they go out."""

from sightline.coverage import COVERAGE_95
from sightline.scans.references.bodies import AgreementBody, ReferenceBody
from sightline.scans.references.records import UNITS, StoredReference
from sightline.statistics.references import Agreement


def reference_body(one: StoredReference, found: Agreement | None) -> ReferenceBody:
    """One value beside our own."""
    values = one.values
    return ReferenceBody(
        quantity=values.quantity,
        source=values.source,
        unit=UNITS[values.quantity],
        value=values.value,
        u=values.u,
        U95=COVERAGE_95 * values.u,
        device=values.device,
        revision=one.revision,
        agreement=None if found is None else agreement_body(found),
        created_by=one.created_by,
        created_at=one.created_at,
    )


def agreement_body(found: Agreement) -> AgreementBody:
    """A difference with its U95."""
    return AgreementBody(
        difference=found.difference,
        u_difference=found.u_difference,
        U95_difference=COVERAGE_95 * found.u_difference,
        E_n=found.E_n,
        within=found.within,
    )
