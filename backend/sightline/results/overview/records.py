"""How far the work of a survey has come."""

from dataclasses import dataclass

from sightline.enums import StepKey, StepState
from sightline.messages.said import Said
from sightline.scans.records import ScanProgress
from sightline.surveys.records import Survey


@dataclass(frozen=True, slots=True)
class SurveyCounts:
    """Computed when asked, never stored. `vehicles_measured`: of `vehicles`, those of which all that is asked
    for is measured or said not to be visible; `measurements`: in frames; verdicts: of line scans too.
    """

    recordings: int = 0
    vehicles: int = 0
    vehicles_measured: int = 0
    not_visible: int = 0
    measurements: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a survey's work, and what to do next in it."""

    key: StepKey
    state: StepState
    summary: list[Said]


@dataclass(frozen=True, slots=True)
class ChangesSince:
    """How many heights and verdicts were added or changed since a package was built, and how many other
    things that its tables hold (vehicles, recordings, poses, the survey's own facts).
    """

    heights: int = 0
    reviews: int = 0
    other: int = 0

    @property
    def makes_outdated(self) -> bool:
        """Whether the package no longer holds what is there."""
        return self.heights + self.reviews + self.other > 0


@dataclass(frozen=True, slots=True)
class SurveyOverview:
    """A survey with what it has and what comes next; `since_package`: the newest one, None without any."""

    survey: Survey
    counts: SurveyCounts
    steps: tuple[Step, ...]
    scans: ScanProgress
    since_package: ChangesSince | None
