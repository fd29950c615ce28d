"""What a study is made of and what comes out of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

from sightline.enums import ComparisonVerdict, JsonObject, StatisticsTarget
from sightline.infra.audit.records import Who
from sightline.messages.said import Said
from sightline.statistics.figures import TotalFigure, TotalPercentile
from sightline.statistics.rules import RuleToday
from sightline.statistics.standards import Standard


@dataclass(frozen=True)
class StudiedSurvey:
    """One survey of a study: where it came from, its site, and the standards that it is read against.

    seal: of a package, the hash of its audit chain without the seal; of an installation's survey "".
    head: of an installation's survey, the last hash of its audit chain when it was read; of a package "".
    """

    place: str
    name: str
    site: str
    made_with: str
    standards: tuple[Standard, ...]
    seal: str = ""
    head: str = ""
    year: int | None = None
    simulated: bool = False


@dataclass(frozen=True)
class StudiedPackage(StudiedSurvey):
    """One package, verified: where its tables can be read, and what tells its survey from others."""

    tables: Path = Path()
    survey: str = ""


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


@dataclass(frozen=True)
class TargetFigures:
    """The figures of one target's heights, or the reason why there are none."""

    target: StatisticsTarget
    n: int
    sites: int
    weighting_effect: float | None = None
    mean: TotalFigure | None = None
    sd: TotalFigure | None = None
    percentiles: list[TotalPercentile] = field(default_factory=list)
    reason: Said | None = None


@dataclass(frozen=True)
class ClassShare:
    """The share of a class among the vehicles seen, by its group ("all", or a lighting)."""

    group: str
    category: str
    n: int
    share: TotalFigure
    fleet: float | None


@dataclass(frozen=True)
class ErrorFigure:
    """One figure of the error table of roofs."""

    group: str
    figure: str
    n: int
    value: TotalFigure


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanRow:
    """Sites and vehicles at each that give a percentile its interval; vehicles None: no number does."""

    target: StatisticsTarget
    percent: float
    goal_U95_m: float
    sites: int
    vehicles_each: int | None
    U95_m: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyDifference:
    """A figure of a study less that of another, metres; percent None: the mean."""

    target: StatisticsTarget
    percent: float | None
    n_first: int
    n_second: int
    value_m: float | None
    low_m: float | None
    high_m: float | None
    verdict: ComparisonVerdict | None
    reason: Said | None


@dataclass(frozen=True, slots=True, kw_only=True)
class YearRow(StudyDifference):
    """A figure of the second year less that of the first. Either n may be 0."""

    first_year: int
    second_year: int


@dataclass(frozen=True)
class Curve:
    """Percentiles of one target from low to high, each with its interval: its distribution, to be drawn."""

    target: StatisticsTarget
    points: list[TotalPercentile]


@dataclass(frozen=True, kw_only=True)
class Study:
    """Everything that comes out of a study. `counted`, `out_of_sample`: accepted heights of each survey that
    count, and that do not, for their vehicle is not in its survey's sample. `rules`: of standards, on the
    heights of their class in the fleet.
    """

    surveys: list[StudiedSurvey]
    counted: list[int]
    out_of_sample: list[int]
    heights: int
    vehicles: int
    targets: list[TargetFigures] = field(default_factory=list)
    errors: list[ErrorFigure] = field(default_factory=list)
    classes: list[ClassShare]
    plans: list[PlanRow] = field(default_factory=list)
    rules: list[RuleToday] = field(default_factory=list)
    years: list[YearRow] = field(default_factory=list)
    curves: list[Curve] = field(default_factory=list)
    notes: list[Said]


@dataclass(frozen=True, slots=True)
class StudySurvey:
    """A survey of this installation in a study: at which site, of which stratum ("": not told) and year."""

    survey_id: int
    site: str
    stratum: str = ""
    year: int | None = None


@dataclass(frozen=True, slots=True)
class StudyFacts:
    """What people say of a study; the tables of its fleet and sites as they were uploaded, "" for none; the
    U95 of P10 that a further study is to have.
    """

    name: str
    description: str = ""
    surveys: tuple[StudySurvey, ...] = ()
    fleet_csv: str = ""
    sites_csv: str = ""
    goal_m: float = 0.010


@dataclass(frozen=True, slots=True)
class StoredStudy:
    """A study of this installation's surveys. simulated: they are invented; job_id: its newest computing."""

    id: int
    facts: StudyFacts
    simulated: bool
    job_id: int | None
    version: int
    created_at: datetime
    updated_at: datetime


@dataclass(frozen=True, slots=True)
class StudyResult:
    """What a computing found. heads: the end of each survey's audit chain when it was read, by its id;
    document: rows of the package's tables, curves, notes; sha256, size_bytes: of the package.
    """

    id: int
    study_id: int
    study_version: int
    heads: Mapping[int, str]
    document: JsonObject
    media_key: str
    size_bytes: int
    sha256: str
    report_key: str
    report_sha256: str
    code_version: str
    created_at: datetime
    created_by: Who | None
