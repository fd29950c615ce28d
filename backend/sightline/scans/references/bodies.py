"""Bodies of reference values: m/s for speeds, metres for lengths; u at k = 1."""

from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import ReferenceQuantity, ReferenceSource
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, In, Out
from sightline.infra.web.quantities import Word

SeenRevision = Annotated[int, Field(ge=0, le=2**31 - 1, description="The revision that you saw; 0: none.")]
Positive = Annotated[Finite, Field(gt=0, le=1000)]


class ReferenceIn(In):
    """What this source says, in place of what was seen."""

    value: Positive = Field(description="m/s of a speed, metres of a length.")
    u: Positive = Field(description="Its standard uncertainty (k = 1), in the same unit.")
    device: Word | None = Field(default=None, description="Which radar, whose tape.")
    revision: SeenRevision


class AgreementBody(Out):
    """Ours minus the reference, with the u of that; `within`: |E_n| <= 1, the combined U95 holds it."""

    difference: float
    u_difference: float
    U95_difference: float
    E_n: float
    within: bool


class ReferenceBody(Out):
    """What one source says of a vehicle."""

    quantity: ReferenceQuantity
    source: ReferenceSource
    unit: str
    value: float
    u: float
    U95: float
    device: str | None
    revision: int
    agreement: AgreementBody | None = Field(description="null: there is no value of ours to compare with.")
    created_by: Who | None
    created_at: datetime
