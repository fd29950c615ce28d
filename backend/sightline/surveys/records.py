"""What a survey is, and how far its work has come."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Literal

from sightline.enums import (
    StepKey,
    StepState,
)


@dataclass(frozen=True, slots=True)
class Inset:
    """How far a target lies behind the side plane, metres, and its standard uncertainty."""

    inset_m: float
    u_inset_m: float
    note: str = ""


@dataclass(frozen=True, slots=True)
class SurveyCounts:
    """Computed when asked, never stored."""

    recordings: int = 0
    vehicles: int = 0
    vehicles_measured: int = 0
    measurements: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a survey's work, and what to do next in it."""

    key: StepKey
    state: StepState
    summary: str


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """The line scans of a survey: vehicles by what was done with them, and what to do next."""

    state: Literal["none", "open", "done"]
    summary: str
    scans: int = 0
    ready: int = 0
    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0


@dataclass(frozen=True, slots=True)
class Survey:
    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    insets: Mapping[str, Inset]
    counts: SurveyCounts
    steps: tuple[Step, ...]
    scans: ScanProgress
