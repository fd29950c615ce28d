"""The heights of standards that a survey's figures are read against, and where they come from.

They have no table of their own (`infra/audit/choice`): they are words and figures that nothing refers to,
seldom changed, and who changed them when is as much asked for as they are.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Annotated

from pydantic import Field
from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Conflict
from sightline.infra.audit import choice
from sightline.infra.database.rows import get_row
from sightline.results.usual_standards import STANDARDS, add_usual_code, stored_standards
from sightline.statistics.standards import Standard
from sightline.surveys.tables import surveys

MOST = 40
_KIND = choice.Kind("standards", "standards")


@dataclass(frozen=True)
class StandardsOfSurvey:
    """`version` is the number of the audit event that made them, 0 for the usual ones."""

    standards: tuple[Standard, ...]
    version: Annotated[int, Field(description="0: the usual ones; give it back with a change.")]


def get_standards(session: Session, survey_id: int) -> StandardsOfSurvey:
    """What a survey is read against. Raises NotFound."""
    get_row(session, surveys, survey_id, "survey")
    return _newest(session, [survey_id]).get(survey_id, StandardsOfSurvey(STANDARDS, 0))


def standards_of_surveys(session: Session, survey_ids: Sequence[int] | None = None) -> tuple[Standard, ...]:
    """Those of some surveys, or of all, each once: the usual ones first where a survey keeps to them."""
    every = select(surveys.c.id).order_by(surveys.c.id)
    wanted = list(session.execute(every).scalars() if survey_ids is None else survey_ids)
    found = _newest(session, wanted)
    return joined_standards([found[id_].standards if id_ in found else STANDARDS for id_ in wanted])


def joined_standards(tables: Sequence[tuple[Standard, ...]]) -> tuple[Standard, ...]:
    """The standards of several tables, each once: the usual ones first where a table is theirs."""
    usual_first = sorted(tables, key=lambda table: table != STANDARDS)
    return tuple(dict.fromkeys(one for table in usual_first for one in table)) if tables else STANDARDS


def choose_standards(
    session: Session, survey_id: int, standards: Sequence[Standard], *, version: int, actor: int | None
) -> StandardsOfSurvey:
    """From now on the survey is read against these.

    Raises BadInput for a table that cannot be drawn, Conflict if `version` is not the current one, NotFound.
    """
    before = get_standards(session, survey_id)
    if version != before.version:
        raise Conflict("results-standards-changed")
    known = {one.code: one.words for one in (*STANDARDS, *before.standards)}
    table = tuple(_kept_code(_stripped(one), known) for one in standards)
    _refuse(table)
    then, now = ([asdict(one) for one in listed] for listed in (before.standards, table))
    return StandardsOfSurvey(table, choice.choose(session, _KIND, survey_id, then, now, actor))


def _stripped(one: Standard) -> Standard:
    words = ("name", "source", "edition", "vehicle_class", "cited_by")
    return replace(one, **{word: getattr(one, word).strip() for word in words})


def _kept_code(standard: Standard, known: Mapping[str | None, tuple[str, ...]]) -> Standard:
    """With its code while its words are the program's, whether or not it was sent along."""
    if standard.code is None:
        return add_usual_code(standard)
    return standard if known.get(standard.code) == standard.words else replace(standard, code=None)


def _refuse(table: Sequence[Standard]) -> None:
    if len(table) > MOST:
        raise BadInput("results-standards-many", count=len(table), most=MOST)
    for standard in table:
        if not standard.name:
            raise BadInput("results-standard-no-name")
        if not 0.0 < standard.height_m < 10.0:
            raise BadInput("results-standard-height", name=standard.name)
        if standard.percent is not None and not 0.0 < standard.percent < 100.0:
            raise BadInput("results-standard-percent", name=standard.name)
    named = [(standard.what, standard.name) for standard in table]
    twice = next((name for what, name in named if named.count((what, name)) > 1), None)
    if twice is not None:
        raise BadInput("results-standard-twice", twice=twice)


def _newest(session: Session, survey_ids: Sequence[int]) -> dict[int, StandardsOfSurvey]:
    """By survey, of those that have a table of their own."""
    return {
        survey_id: StandardsOfSurvey(stored_standards(table), version)
        for survey_id, (table, version) in choice.current_choices(session, _KIND, survey_ids).items()
    }
