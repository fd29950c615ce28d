"""What a survey is."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime

from sightline.geometry.sides import TrafficFacts


@dataclass(frozen=True, slots=True)
class Inset:
    """How far a target lies behind the side plane, metres, and its standard uncertainty."""

    inset_m: float
    u_inset_m: float
    note: str = ""


@dataclass(frozen=True, slots=True)
class Survey:
    """Its words, traffic and insets (by `InsetName`); its progress is its overview (`results`)."""

    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    traffic: TrafficFacts
    insets: Mapping[str, Inset]
