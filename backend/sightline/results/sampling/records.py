"""How far a survey's sample has come."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import ClassSet, Lighting
from sightline.statistics.sampling import Response


@dataclass(frozen=True, slots=True)
class QuotaProgress:
    """One quota: of the vehicles wanted, how many are measured and how many wait in the sample."""

    lighting: Lighting
    class_set: Annotated[ClassSet | None, Field(description="Null: vehicles of any class.")]
    wanted: int
    measured: int
    open: int


@dataclass(frozen=True, slots=True)
class SampleProgress:
    """Quotas, and how passes end, by lighting, set and target."""

    quotas: tuple[QuotaProgress, ...]
    response: tuple[Response, ...]
