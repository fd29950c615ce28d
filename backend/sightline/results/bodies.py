"""Bodies of the statistics: lengths in metres; a part that cannot be computed is its reason."""

from typing import Annotated

from pydantic import Field

from sightline.enums import LightingGroup, Rounding, StandardHeight, StatisticsTarget
from sightline.infra.web.bodies import Finite, In, Out
from sightline.infra.web.figures import (
    DensityBody,
    EcdfBody,
    FigureBody,
    IntervalBody,
    PercentileBody,
    ReasonBody,
)


class ErrorGroupBody(Out):
    """One column of the error table; error = measured - reference."""

    group: str
    title: str = Field(description="The column of the paper's table that it stands for.")
    n: int
    figures: dict[str, FigureBody]
    reason: str | None = Field(description="Why a figure or its interval is missing.")


class PaperBody(Out):
    """A column of the paper's Table 1 as printed, and what is inconsistent in it."""

    group: str
    title: str
    n: int
    mae_m: float
    rmse_m: float
    mse_m2: float
    sd_m: float
    note: str


class ReferencePartBody(Out):
    u_reference_m: float
    share_of_variance: float
    rounding_share: float
    camera_sd_m: float | None
    correlation_alone: float
    words: str


class BlandAltmanBody(Out):
    n: int
    bias_m: float
    bias_ci95: IntervalBody
    lower_m: float
    lower_ci95: IntervalBody
    upper_m: float
    upper_ci95: IntervalBody


class TrendBody(Out):
    """A line by least squares over the reference height, with the band of the line."""

    slope: float
    slope_ci95: IntervalBody
    intercept: float
    correlation: float
    correlation_ci95: IntervalBody
    n: int
    at: list[float]
    value: list[float]
    low: list[float]
    high: list[float]


class PointsBody(Out):
    reference_m: list[float]
    error_m: list[float]
    lighting: list[LightingGroup]


Ecdfs = dict[str, EcdfBody | ReasonBody]


class ErrorsBody(Out):
    rounding: Rounding
    words: str = Field(description="Which heights were compared, and how they were rounded.")
    groups: list[ErrorGroupBody]
    paper: list[PaperBody]
    reference_part: ReferencePartBody | ReasonBody
    bland_altman: BlandAltmanBody | ReasonBody
    trend: TrendBody | ReasonBody
    absolute_trend: TrendBody | ReasonBody
    absolute: Ecdfs
    relative: Ecdfs
    density: dict[str, DensityBody | ReasonBody]
    points: PointsBody = Field(description="At most 1500, drawn at random but always the same.")


class StandardBody(Out):
    name: str
    what: StandardHeight
    height_m: float
    source: str


class StandardIn(In):
    name: Annotated[str, Field(min_length=1, max_length=100)]
    what: StandardHeight
    height_m: Finite
    source: Annotated[str, Field(max_length=500)] = ""


class StandardsIn(In):
    version: Annotated[int, Field(ge=0, le=2**31 - 1)]
    standards: list[StandardIn]


class StandardsBody(Out):
    version: int = Field(description="0: the usual ones; give it back with a change.")
    standards: list[StandardBody]


class ShareBody(Out):
    """The share of vehicles below a standard's height."""

    standard: StandardBody
    below: int
    n: int
    share: float
    low: float
    high: float


class DistributionBody(Out):
    n: int
    mean_m: float | None
    sd_m: float | None
    ecdf: EcdfBody | ReasonBody
    percentiles: list[PercentileBody]
    shares: list[ShareBody]


class CorrectedBody(DistributionBody):
    words: str | None = Field(description="What was done.")
    warning: str | None
    reason: str | None = Field(description="Why the correction could not be made; all else is then empty.")


class GroupBody(DistributionBody):
    word: str


class GroupingBody(Out):
    groups: list[GroupBody]
    left_out: int = Field(description="Smaller groups that are not listed.")


class TargetBody(Out):
    target: StatisticsTarget
    raw: DistributionBody
    corrected: CorrectedBody
    density: DensityBody | ReasonBody
    groups: dict[str, GroupingBody]


class CountedBody(Out):
    measurements: int
    vehicles: int
    with_reference: int = Field(description="Roofs of vehicles with a reference height.")
    left_out: dict[str, int] = Field(description="Left out by the review state alone.")


class NamedBody(Out):
    id: int
    name: str


class StatisticsBody(Out):
    counted: CountedBody
    errors: ErrorsBody
    targets: list[TargetBody]
    standards: list[StandardBody] = Field(description="Heights of standards, and the asker's own.")
    surveys: list[NamedBody] = Field(description="What can be filtered by.")
    operators: list[NamedBody] = Field(description="What can be filtered by.")


class SampleSizeBody(Out):
    percent: float
    width_m: float
    vehicles: int
    words: str
