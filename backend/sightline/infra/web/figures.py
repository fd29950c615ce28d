"""Bodies of statistical figures; a part that cannot be computed is its reason."""

from pydantic import Field

from sightline.enums import IntervalPart
from sightline.infra.web.bodies import Out
from sightline.messages.said import Said
from sightline.statistics.errors import Interval


class ReasonBody(Out):
    reason: Said


class FigureBody(Out):
    value: float | None
    ci95: Interval | None
    reason: Said | None = Field(description="Why the interval alone is missing.")
    holds: list[IntervalPart] = Field(default=[], description="What the interval holds.")


class EcdfBody(Out):
    """Shares of a sample that are <= value, with a 95 % band that holds everywhere at once."""

    n: int
    value: list[float]
    share: list[float]
    low: list[float]
    high: list[float]


class DensityBody(Out):
    n: int
    bandwidth: float
    value: list[float]
    density: list[float]
    low: list[float]
    high: list[float]
