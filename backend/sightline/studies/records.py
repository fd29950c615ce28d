"""What a study is made of and what comes out of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sightline.statistics.study_figures import StudyFigure, StudyPercentile

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class StudiedPackage:
    """One package, verified: where its tables can be read, and what tells it from others."""

    place: Path
    tables: Path
    name: str
    site: str
    made_with: str
    seal: str
    survey: str


@dataclass(frozen=True)
class SiteFacts:
    """What is known of a site beyond its packages: its stratum, how many sites that has, and its traffic."""

    stratum: str
    sites_there: float
    traffic: float | None


@dataclass(frozen=True)
class Fleet:
    """Shares of classes in the fleet by what divides it (`category`, `lighting`, `stratum`, `site`)."""

    margins: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True, eq=False)
class StudiedHeights:
    """Counted heights of one target, (N,) each: accepted, not withdrawn. package: which of the study's;
    category, lighting: codes of words, -1 for none; inset_m, u_inset_m, u_clicks_m, u_by_inset_m: NaN where
    not known; reference_m: the maker's height, NaN where not known.
    """

    package: Ints
    pose: Ints
    category: Ints
    lighting: Ints
    height_m: Floats
    u_height_m: Floats
    u_clicks_m: Floats
    u_by_inset_m: Floats
    inset_m: Floats
    u_inset_m: Floats
    reference_m: Floats


@dataclass(frozen=True)
class TargetFigures:
    """The figures of one target's heights, or the reason why there are none."""

    target: str
    n: int
    sites: int
    weighting_effect: float | None = None
    mean: StudyFigure | None = None
    sd: StudyFigure | None = None
    percentiles: list[StudyPercentile] = field(default_factory=list)
    reason: str | None = None


@dataclass(frozen=True)
class ClassShare:
    """The share of a class among the vehicles seen, by its group ("all", or a lighting)."""

    group: str
    category: str
    n: int
    share: StudyFigure
    fleet: float | None


@dataclass(frozen=True)
class ErrorFigure:
    """One figure of the error table of roofs."""

    group: str
    figure: str
    n: int
    value: StudyFigure


@dataclass(frozen=True)
class PlannedStudy:
    """Sites and vehicles at each that give a percentile its interval; vehicles None: no number does."""

    target: str
    percent: float
    goal_U95_m: float
    sites: int
    vehicles: int | None
    U95_m: float | None


@dataclass(frozen=True)
class Study:
    """Everything that comes out of a study. `counted`, `out_of_sample`: accepted heights of each package that
    count, and that do not, for their vehicle is not in its survey's sample.
    """

    packages: list[StudiedPackage]
    counted: list[int]
    out_of_sample: list[int]
    heights: int
    vehicles: int
    targets: list[TargetFigures]
    errors: list[ErrorFigure]
    classes: list[ClassShare]
    plans: list[PlannedStudy]
    notes: list[str]
