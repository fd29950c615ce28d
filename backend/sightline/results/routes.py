"""Statistics of measurements: errors against reference heights, distributions, vehicles to take."""

from dataclasses import asdict, replace
from datetime import date
from typing import Annotated, Any, get_args

from fastapi import APIRouter, Query

from sightline.enums import (
    Correction,
    LightingGroup,
    Rounding,
    StandardHeight,
    StatisticsTarget,
)
from sightline.errors import BadInput
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Id
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.infra.web.figures import error_figures, round_to_micrometre
from sightline.messages.said import Said
from sightline.recordings.bodies import FilmedAsked
from sightline.results import standards_store
from sightline.results.bodies import HeightsAsked, StandardsIn, StatisticsBody
from sightline.results.standards_store import StandardsOfSurvey
from sightline.results.survey_statistics import (
    Statistics,
    StatisticsOptions,
    standards_of,
    survey_statistics,
)
from sightline.statistics.agreement import U_MANUFACTURER_M
from sightline.statistics.errors import GROUPS
from sightline.statistics.known_errors import KnownErrors
from sightline.statistics.lateral import Lateral
from sightline.statistics.paper import PAPER
from sightline.statistics.sample_size import SampleSize, vehicles_needed
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Distribution, Errors, Groups, Target

router = APIRouter()

Metres = Annotated[float, Query(allow_inf_nan=False)]
MOST_OWN = 20
_LIGHTING = get_args(LightingGroup)
_TITLES = {column.group: column.title for column in PAPER}


@router.get("/statistics")
def statistics_of_measurements(
    who: Viewer,
    session: Reading,
    heights: HeightsAsked,
    filmed: FilmedAsked,
    operator: Annotated[Id | None, Query()] = None,
    first_day: date | None = None,
    last_day: date | None = None,
    target: Annotated[
        StatisticsTarget | None,
        Query(description="Only this target is counted and shown; errors are of roofs anyway."),
    ] = None,
    rounding: Rounding = "none",
    correction: Correction = "inset",
    u_reference_m: Annotated[
        Metres, Query(description="Of a reference height without a u of its own.")
    ] = U_MANUFACTURER_M,
    eye_limit_m: Annotated[list[Metres], Query(description="Own limits beside the standards'.")] = [],  # noqa: B006
    object_limit_m: Annotated[list[Metres], Query(description="Own limits beside the standards'.")] = [],  # noqa: B006
) -> StatisticsBody:
    """Error table, figures and distributions of the measurements that a filter leaves."""
    if not 0.0 <= u_reference_m < 1.0:
        raise BadInput("results-reference-u")
    own = _own_standards("eye_car", eye_limit_m) + _own_standards("object_stopping", object_limit_m)
    chosen = replace(
        heights,
        operator_id=operator,
        first_day=first_day,
        last_day=last_day,
        **asdict(filmed),
        target=target,
    )
    choices = StatisticsOptions(rounding, correction, u_reference_m, own)
    return statistics_body(survey_statistics(session, chosen, choices), correction)


@router.get("/statistics/sample-size")
def sample_size(who: Viewer, percent: Metres, width_m: Metres, sd_m: Metres) -> SampleSize:
    """How many vehicles give a percentile's 95 % interval a wanted width."""
    return vehicles_needed(percent, width_m, sd_m)


@router.get("/surveys/{survey_id}/standards")
def standards_of_survey(who: Viewer, session: Reading, survey_id: PathId) -> StandardsOfSurvey:
    """The heights of standards that a survey's figures are read against, with their sources."""
    return standards_store.get_standards(session, survey_id)


@router.put("/surveys/{survey_id}/standards")
def choose_standards(
    who: Operator, session: Writing, survey_id: PathId, body: StandardsIn
) -> StandardsOfSurvey:
    """Put another table in its place; `version` is that of the table it replaces."""
    table = [Standard(**one.model_dump()) for one in body.standards]
    return standards_store.choose_standards(session, survey_id, table, version=body.version, actor=who.id)


def _own_standards(what: StandardHeight, limits_m: list[float]) -> tuple[Standard, ...]:
    if len(limits_m) > MOST_OWN:
        raise BadInput("results-own-values-many", most_own=MOST_OWN)
    if any(not 0.0 < limit < 10.0 for limit in limits_m):
        raise BadInput("results-own-value-range")
    return tuple(Standard("own value", what, limit, "entered on the page", code="own") for limit in limits_m)


def statistics_body(statistics: Statistics, correction: Correction) -> StatisticsBody:
    """Statistics as they go out."""
    return StatisticsBody.model_validate(
        {
            **vars(statistics),
            "errors": _errors(statistics.errors, correction),
            "known_errors": [_json_of_known_errors(one) for one in statistics.known_errors],
            "targets": [
                _target(name, one, standards_of(statistics.standards, name))
                for name, one in statistics.targets.items()
            ],
            "lateral": _lateral(statistics.lateral),
            "surveys": [Who(*one) for one in statistics.surveys.items()],
            "operators": [Who(*one) for one in statistics.operators.items()],
        }
    )


def _errors(errors: Errors, correction: Correction) -> dict[str, Any]:
    heights = "inset" if correction == "inset" else "paper"
    points = errors.points
    return {
        **vars(errors),
        "words": Said("stat-errors-of", heights=heights, rounded=errors.rounding),
        "groups": [{**error_figures(name, errors.groups[name]), "title": _TITLES[name]} for name in GROUPS],
        "paper": PAPER,
        "points": {
            "reference_m": round_to_micrometre(points[:, 0]),
            "error_m": round_to_micrometre(points[:, 1]),
            "lighting": [_LIGHTING[int(code)] for code in points[:, 2]],
        },
    }


def _json_of_known_errors(one: KnownErrors) -> dict[str, Any]:
    groups = [{"grouping": part.grouping, **error_figures(part.group, part.errors)} for part in one.groups]
    return {**vars(one), "groups": groups}


def _target(name: StatisticsTarget, target: Target, table: list[Standard]) -> dict[str, Any]:
    done = target.correction
    corrected = _distribution(target.corrected, table) | (
        {"words": None, "warning": None, "reason": done}
        if isinstance(done, Said)
        else {"words": done.words, "warning": done.warning, "reason": None}
    )
    return {
        "target": name,
        "raw": _distribution(target.raw, table),
        "corrected": corrected,
        "density": target.density,
        "total": target.total,
        "groups": {key: _grouping(groups, table) for key, groups in target.groups.items()},
    }


def _lateral(found: Lateral | None) -> dict[str, Any] | None:
    if found is None or found.all.n == 0:
        return None
    classes = {lane: _grouping(groups, []) for lane, groups in found.classes.items()}
    return {"all": _distribution(found.all, []), "lanes": _grouping(found.lanes, []), "classes": classes}


def _grouping(groups: Groups, table: list[Standard]) -> dict[str, Any]:
    listed = [{"word": word, **_distribution(one, table)} for word, one in groups.of.items()]
    return {"groups": listed, "left_out": groups.left_out}


def _distribution(distribution: Distribution, table: list[Standard]) -> dict[str, Any]:
    shares = [
        {"standard": standard, **asdict(share)}
        for standard, share in zip(table, distribution.shares, strict=False)
    ]
    return {**vars(distribution), "shares": shares}
