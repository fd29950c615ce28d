"""How well each person clicks, as their repeats show it. Rows are only added; a person's newest counts."""

from typing import Any

from sqlalchemy import exists, select
from sqlalchemy.orm import Session

from sightline.infra.audit.written import written_once
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import get_row, who
from sightline.measurements.records import ClickSigma
from sightline.measurements.tables import click_sigmas
from sightline.surveys.tables import surveys

_later = click_sigmas.alias("later")
_is_newest = ~exists().where(
    _later.c.survey_id == click_sigmas.c.survey_id,
    _later.c.person_id == click_sigmas.c.person_id,
    _later.c.id > click_sigmas.c.id,
)
_person = people.alias("person")
_maker = people.alias("maker")


def choose_click_sigma(
    session: Session, survey_id: int, person_id: int, *, sigma_px: float | None, pairs: int, actor: int | None
) -> ClickSigma:
    """From now on a person's clicks in this survey count with this sigma; None: with the usual one again.

    Measurements that are stored keep theirs. Raises NotFound for a survey or person that is not there.
    """
    get_row(session, surveys, survey_id, "survey")
    get_row(session, people, person_id, "person")
    before = of_person(session, survey_id, person_id)
    content = {"survey_id": survey_id, "person_id": person_id, "sigma_px": sigma_px, "pairs": pairs}
    then = None if before is None else {"sigma_px": before.sigma_px, "pairs": before.pairs}
    row_id = written_once(session, click_sigmas, content, "choose", before=then, actor=actor)
    return _fetch(session, click_sigmas.c.id == row_id)[0]


def of_person(session: Session, survey_id: int, person_id: int) -> ClickSigma | None:
    """The figure that counts for a person's clicks, None where nobody chose one."""
    found = _fetch(session, click_sigmas.c.survey_id == survey_id, click_sigmas.c.person_id == person_id)
    return found[0] if found else None


def list_click_sigmas(session: Session, survey_id: int) -> tuple[ClickSigma, ...]:
    """What counts for each person of a survey, by person."""
    return _fetch(session, click_sigmas.c.survey_id == survey_id)


def _fetch(session: Session, *conditions: Any) -> tuple[ClickSigma, ...]:
    query = (
        select(click_sigmas, _person.c.name.label("person"), _maker.c.name.label("maker"))
        .join(_person, _person.c.id == click_sigmas.c.person_id)
        .outerjoin(_maker, _maker.c.id == click_sigmas.c.created_by)
        .where(_is_newest, *conditions)
        .order_by(click_sigmas.c.person_id)
    )
    return tuple(
        record_of(
            ClickSigma,
            row._mapping,
            person=who(row.person_id, row.person),
            created_by=who(row.created_by, row.maker),
        )
        for row in session.execute(query)
    )
