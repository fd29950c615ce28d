"""What the vehicles say of the rig of two line-scan cameras, as it goes out. Metres, seconds."""

from pydantic import Field

from sightline.enums import KnownLength
from sightline.infra.web.bodies import Out


class RigEstimateBody(Out):
    """A constant of the rig from n vehicles, with its standard uncertainty; `spread`: of one vehicle."""

    value: float | None
    u: float | None
    spread: float | None
    n: int
    reason: str | None
    warning: str | None


class ImpliedBaselineBody(Out):
    """The baseline that makes known sizes come out right; ratio: measured over true as it is now."""

    of: KnownLength
    ratio: RigEstimateBody
    baseline_m: float | None
    u_baseline_m: float | None
    differs: bool = Field(description="From the baseline in force by more than twice its uncertainty.")
    words: str


class RigOfTrafficBody(Out):
    """What the vehicles say of the rig; `order`: a sentence where the strips seem to be swapped."""

    misalignment: RigEstimateBody
    gain: RigEstimateBody
    baselines: list[ImpliedBaselineBody]
    order: str | None
