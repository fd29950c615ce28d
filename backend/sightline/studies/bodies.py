"""What studies take, and what is said of one: lengths in metres; a figure that is missing has its reason."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field, computed_field

from sightline.enums import LengthUnit, RuleHeights, RuleVerdict, StandardHeight, StatisticsTarget
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, In, JobBody, Name, Out, Text
from sightline.infra.web.named import SurveyId
from sightline.messages.said import Said
from sightline.statistics.rules import whose_heights
from sightline.studies.records import PlanRow, StudyDifference, StudyFacts, StudySurvey, YearRow

_MOST_SURVEYS = 2000
_Table = Annotated[str, Field(max_length=1_000_000)]


class StudySurveyIn(In):
    survey_id: SurveyId
    site: Annotated[str, Field(max_length=200, description="Empty: as the survey says.")] = ""
    stratum: Annotated[str, Field(max_length=200, description="Empty: as the table of sites says.")] = ""
    year: Annotated[int | None, Field(description="Where years are compared.")] = None


class NewStudy(In):
    name: Name
    description: Text = ""
    surveys: Annotated[tuple[StudySurveyIn, ...], Field(max_length=_MOST_SURVEYS)] = ()
    fleet_csv: Annotated[_Table, Field(description="Shares of the fleet by class; empty: no weights.")] = ""
    sites_csv: Annotated[_Table, Field(description="Facts of the sites; empty: none are known.")] = ""
    goal_m: Annotated[Finite, Field(description="U95 of P10 that a further study is to have.")] = 0.010

    def record(self) -> StudyFacts:
        """As the store takes it."""
        surveys = tuple(StudySurvey(**one.model_dump()) for one in self.surveys)
        return StudyFacts(**{**self.model_dump(exclude={"surveys", "version"}), "surveys": surveys})


class StudyChange(NewStudy):
    version: int = Field(
        description="The version that was changed; another's change in between is a conflict."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class StudySurveyBody(StudySurvey):
    name: str


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyBody(StudyFacts):
    id: int
    surveys: tuple[StudySurveyBody, ...]
    simulated: Annotated[bool, Field(description="Its surveys are invented; say so beside every figure.")]
    version: int
    created_at: datetime
    updated_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class ListedStudy:
    """A study in the list, with what its newest result found."""

    id: int
    name: str
    description: str
    simulated: bool
    surveys: int
    sites: int
    heights: Annotated[int | None, Field(description="Of its newest result; null: not computed yet.")]
    computed_at: datetime | None


class StudiedRow(Out):
    place: str
    survey: str
    site: str
    year: int | None = None
    counted: int
    out_of_sample: int


class FigureRow(Out):
    target: StatisticsTarget
    figure: str
    percent: float | None = None
    n: int
    sites: int
    value_m: float | None = None
    low_m: float | None = None
    high_m: float | None = None
    raw_m: float | None = None
    design_effect: float | None = None
    effective_n: float | None = None
    weighting_effect: float | None = None
    reason: Said | None = None


class RuleRow(Out):
    target: StatisticsTarget
    standard: str
    standard_code: str | None = None
    what: StandardHeight
    percent: float
    vehicle_class: str
    by_class: bool
    n: int
    standard_m: float
    value_m: float | None
    low_m: float | None
    high_m: float | None
    difference_m: float | None
    lower: float | None
    risk: float | None
    verdict: RuleVerdict
    reason: Said | None

    @computed_field(description="Whose heights it is read on.")  # type: ignore[prop-decorator]
    @property
    def whose(self) -> RuleHeights:
        return whose_heights(self.what, self.by_class)


class BesideBody(Out):
    """A study less another one."""

    first: Annotated[str, Field(description="The other one, which is taken away.")]
    second: str
    shared_surveys: Annotated[list[str], Field(description="In both: the intervals are then too wide.")]
    differences: list[StudyDifference]


class ErrorRow(Out):
    group: str
    figure: str
    n: int
    value_m: float
    low_m: float | None
    high_m: float | None


class ClassRow(Out):
    group: str
    category: str
    n: int
    share: float
    low: float | None
    high: float | None
    design_effect: float | None = None
    fleet_share: float | None = None


class StudyCurvePoint(Out):
    percent: float
    value_m: float
    raw_m: float
    low_m: float | None
    high_m: float | None


class StudyCurveBody(Out):
    """Percentiles of true heights, to be drawn."""

    target: StatisticsTarget
    points: list[StudyCurvePoint]


class FiguresBody(Out):
    """The rows of the package's tables."""

    heights: int
    vehicles: int
    notes: list[Said]
    consequence: dict[LengthUnit, str] | None = Field(
        description="What it changes on the road, by unit; of earlier versions in metres alone."
    )
    curves: list[StudyCurveBody]
    packages: list[StudiedRow]
    figures: list[FigureRow]
    rules: list[RuleRow]
    years: list[YearRow]
    errors: list[ErrorRow]
    classes: list[ClassRow]
    plan: list[PlanRow]


@dataclass(frozen=True, slots=True, kw_only=True)
class ResultBody:
    id: int
    created_at: datetime
    created_by: Who | None
    code_version: str
    size_bytes: int
    sha256: str
    study_changed: Annotated[bool, Field(description="The study was changed since it was computed.")]
    surveys_changed: Annotated[list[str], Field(description="Surveys that were written to since.")]
    package_url: str
    report_url: str
    found: FiguresBody


class StudyMembersBody(Out):
    open_to_all: bool
    members: tuple[Who, ...]
    others: Annotated[tuple[Who, ...], Field(description="Whom a member may add.")]


class Openness(In):
    open_to_all: bool


class StudyPage(Out):
    study: StudyBody
    result: ResultBody | None
    job: Annotated[JobBody | None, Field(description="Its newest computing.")]
