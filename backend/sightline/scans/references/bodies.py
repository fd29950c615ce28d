"""Bodies of reference values: m/s for speeds, metres for lengths; u at k = 1."""

from typing import Annotated

from pydantic import Field

from sightline.infra.web.bodies import Finite, In
from sightline.infra.web.quantities import SeenRevision, Word

Positive = Annotated[Finite, Field(gt=0, le=1000)]


class ReferenceIn(In):
    """What this source says, in place of what was seen."""

    value: Positive = Field(description="m/s of a speed, metres of a length.")
    u: Positive = Field(description="Its standard uncertainty (k = 1), in the same unit.")
    device: Word | None = Field(default=None, description="Which radar, whose tape.")
    revision: SeenRevision
