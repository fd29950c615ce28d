"""Who sees a study: members who see each of its surveys, all where it is open to all, and administrators.

What belongs to a survey is asked for at each computing, opening and download, not when the study was made.
"""

from collections.abc import Iterable

from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from sightline.enums import ActingRole
from sightline.errors import NotAllowed
from sightline.infra.audit import trail
from sightline.infra.audit.records import Who
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, change_row, get_row, missing
from sightline.infra.web.access import RANK
from sightline.infra.web.person import Person
from sightline.studies.records import StudyResult
from sightline.studies.tables import studies, study_members
from sightline.surveys.members.store import roles_by_thing, seen_surveys
from sightline.surveys.store import survey_names

_m = study_members.c


def require_surveys(
    session: Session, person: Person, survey_ids: Iterable[int], least: ActingRole = "viewer"
) -> None:
    """Raises NotAllowed where the person is less than this in one of the surveys, at this moment."""
    ids = dict.fromkeys(survey_ids)
    roles = roles_by_thing(session, person, "surveys", ids)
    if any(one not in roles for one in ids):
        raise NotAllowed("studies-needs-each-survey")
    less = next((one for one in ids if RANK[roles[one]] < RANK[least]), None)
    if less is not None:
        raise NotAllowed("studies-open-needs-managers", name=survey_names(session)[less][0])


def sees_result(session: Session, person: Person, result: StudyResult) -> bool:
    """Whether a person who sees the study sees each survey that went into a result, or everybody does."""
    seen = seen_surveys(session, person)
    return seen is None or result.heads.keys() <= seen or is_open_to_all(session, result.study_id)


def list_study_members(session: Session, study_id: int) -> tuple[Who, ...]:
    """Who belongs to a study, by name."""
    query = select(people.c.id, people.c.name).join(study_members, _m.person_id == people.c.id)
    query = query.where(_m.study_id == study_id).order_by(people.c.name, people.c.id)
    return tuple(Who(*row) for row in session.execute(query))


def list_study_others(session: Session, study_id: int) -> tuple[Who, ...]:
    """Whom a member may add: people with an account in use who do not belong to it, by name."""
    inside = select(_m.person_id).where(_m.study_id == study_id)
    query = select(people.c.id, people.c.name).where(people.c.active, people.c.id.not_in(inside))
    return tuple(Who(*row) for row in session.execute(query.order_by(people.c.name, people.c.id)))


def is_open_to_all(session: Session, study_id: int) -> bool:
    """Whether everybody who signs in sees it. Raises NotFound."""
    return bool(get_row(session, studies, study_id, "study")["open_to_all"])


def add_study_member(session: Session, study_id: int, person_id: int, *, actor: int | None) -> None:
    """Let a person see it; who does already stays. Raises NotFound for a person without an account in use."""
    if not get_row(session, people, person_id, "person")["active"]:
        raise missing("person", person_id)
    if any(one.id == person_id for one in list_study_members(session, study_id)):
        return
    content = {"study_id": study_id, "person_id": person_id}
    row_id = add_row(session, study_members, content)
    trail.record(session, actor, "create", "study_member", row_id, None, None, content)


def remove_study_member(session: Session, study_id: int, person_id: int, *, actor: int | None) -> None:
    """Take a person out; what they did stays theirs. Raises NotFound."""
    query = select(_m.id).where(_m.study_id == study_id, _m.person_id == person_id)
    row_id = session.execute(query).scalar_one_or_none()
    if row_id is None:
        raise missing("member", person_id)
    session.execute(delete(study_members).where(_m.id == row_id))
    was = {"study_id": study_id, "person_id": person_id}
    trail.record(session, actor, "delete", "study_member", row_id, None, was, None)


def open_study_to_all(session: Session, study_id: int, open_to_all: bool, *, actor: int | None) -> None:
    """Open a study to everybody who signs in, or close it to all but its members. Raises NotFound."""
    before = is_open_to_all(session, study_id)
    change_row(session, studies, study_id, {"open_to_all": open_to_all})
    was, after = {"open_to_all": before}, {"open_to_all": open_to_all}
    trail.record(session, actor, "update", "study", study_id, None, was, after)
