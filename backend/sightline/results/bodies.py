"""Bodies of the statistics: lengths in metres; a part that cannot be computed is its reason."""

from typing import Annotated, get_args

from fastapi import Depends, Query
from pydantic import Field

from sightline.enums import (
    Category,
    ClassSet,
    ErrorGrouping,
    Lighting,
    LightingGroup,
    Rounding,
    StandardHeight,
    StatisticsState,
    StatisticsTarget,
    Target,
)
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, In, Out, of_record
from sightline.infra.web.deps import SurveysSeen
from sightline.infra.web.figures import (
    DensityPart,
    EcdfPart,
    ErrorFiguresBody,
    Part,
    ReasonBody,
)
from sightline.infra.web.named import SurveyId
from sightline.messages.said import Said
from sightline.results.survey_comparison import ComparedSurveys
from sightline.results.survey_statistics import Filter, SampleCounts
from sightline.statistics.agreement import BlandAltman, ReferencePart, Trend
from sightline.statistics.distributions import Share
from sightline.statistics.known_errors import Inside
from sightline.statistics.paper import PaperColumn
from sightline.statistics.rules import RuleToday
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Distribution
from sightline.statistics.total_uncertainty import TotalFigures


def heights_asked_for(
    seen: SurveysSeen,
    survey: Annotated[list[SurveyId], Query(max_length=200)] = [],  # noqa: B006 (FastAPI copies it)
    lighting: Lighting | None = None,
    category: Annotated[list[Category], Query(max_length=len(get_args(Category)))] = [],  # noqa: B006
    class_set: Annotated[
        list[ClassSet],
        Query(max_length=len(get_args(ClassSet)), description="Beside `category`: what is of either counts."),
    ] = [],  # noqa: B006
    state: StatisticsState = "accepted",
) -> Filter:
    """Which heights a question is about."""
    return Filter(
        survey_ids=tuple(sorted(set(survey))),
        lighting=lighting,
        categories=tuple(one for one in get_args(Category) if one in category),
        class_sets=tuple(one for one in get_args(ClassSet) if one in class_set),
        state=state,
        seen=seen,
    )


HeightsAsked = Annotated[Filter, Depends(heights_asked_for)]


class ErrorGroupBody(ErrorFiguresBody):
    """One column of the error table; error = measured - reference."""

    title: str = Field(description="The column of the paper's table that it stands for.")


@of_record(Trend)
class TrendBody(Out):
    """A line by least squares over the reference height, with the band of the line."""


class PointsBody(Out):
    reference_m: list[float]
    error_m: list[float]
    lighting: list[LightingGroup]


class ErrorsBody(Out):
    rounding: Rounding
    words: Said = Field(description="Which heights were compared, and how they were rounded.")
    groups: list[ErrorGroupBody]
    paper: list[PaperColumn]
    reference_part: Annotated[ReferencePart | ReasonBody, Part]
    bland_altman: Annotated[BlandAltman | ReasonBody, Part]
    trend: Annotated[TrendBody | ReasonBody, Part]
    absolute_trend: Annotated[TrendBody | ReasonBody, Part]
    absolute: dict[str, EcdfPart]
    relative: dict[str, EcdfPart]
    density: dict[str, DensityPart]
    points: PointsBody = Field(description="At most 1500, drawn at random but always the same.")


class KnownGroupBody(ErrorFiguresBody):
    """Bias, MAE, RMSE and SD of some vehicles' errors, not rounded, with total intervals."""

    grouping: ErrorGrouping


class KnownErrorsBody(Out):
    """Errors of one target against heights that were known before, of the traffic or of check targets."""

    target: Target
    check_target: bool
    groups: list[KnownGroupBody] = Field(description="All first, then each lighting and class there is.")
    inside: Annotated[Inside | ReasonBody, Part] = Field(
        description="How many differences are not larger than their own U95; about 95 % should be."
    )


class StandardIn(In):
    name: Annotated[str, Field(min_length=1, max_length=100)]
    what: StandardHeight
    height_m: Finite
    source: Annotated[str, Field(max_length=500)] = ""
    edition: Annotated[str, Field(max_length=100)] = ""
    year: Annotated[int | None, Field(ge=1850, le=2100)] = None
    percent: Annotated[Finite | None, Field(description="Of its class, where known.")] = None
    vehicle_class: Annotated[str, Field(max_length=200)] = ""
    cited_by: Annotated[str, Field(max_length=500, description="Empty: the source itself was read.")] = ""
    drawn: Annotated[bool, Field(description="Whether distributions are read against it.")] = True
    code: Annotated[
        str | None,
        Field(max_length=100, description="The program's for its words; null once these are changed."),
    ] = None


class StandardsIn(In):
    version: Annotated[int, Field(ge=0, le=2**31 - 1)]
    standards: list[StandardIn]


@of_record(Share, "limit")
class ShareBody(Out):
    """The share of vehicles below a standard's height."""

    standard: Standard


@of_record(Distribution)
class DistributionBody(Out):
    ecdf: EcdfPart
    shares: list[ShareBody]


class CorrectedBody(DistributionBody):
    words: Said | None = Field(description="What was done.")
    warning: Said | None
    reason: Said | None = Field(description="Why the correction could not be made; all else is then empty.")


class GroupBody(DistributionBody):
    word: str


class GroupingBody(Out):
    groups: list[GroupBody]
    left_out: int = Field(description="Smaller groups that are not listed.")


class TargetBody(Out):
    target: StatisticsTarget
    total: TotalFigures | None = Field(description="Null where heights are not corrected by their insets.")
    raw: DistributionBody
    corrected: CorrectedBody
    density: DensityPart
    groups: dict[str, GroupingBody]


class LateralBody(Out):
    """Where vehicles drive: distance of the contact from the camera across the road, one of each vehicle."""

    all: DistributionBody
    lanes: GroupingBody = Field(description="By the way that they go in the picture.")
    classes: dict[str, GroupingBody] = Field(description="Of each lane, by class.")


class StatisticsBody(Out):
    rules: list[RuleToday] = Field(description="The rules of standards on the heights of their classes.")
    of_chosen: bool = Field(description="Whether classes are chosen: rules are on these of their class.")
    lateral: LateralBody | None
    comparison: ComparedSurveys | None = Field(description="Where what counts is of two surveys.")
    counted: SampleCounts
    errors: ErrorsBody
    known_errors: list[KnownErrorsBody] = Field(
        description="By target, of the traffic and of check targets; of those that have a known height."
    )
    targets: list[TargetBody]
    standards: list[Standard] = Field(description="Heights of standards, and the asker's own.")
    surveys: list[Who] = Field(description="What can be filtered by.")
    operators: list[Who] = Field(description="What can be filtered by.")
