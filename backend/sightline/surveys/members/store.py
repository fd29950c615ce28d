"""Members of surveys, and the questions that every access rests on: `seen_surveys` and `roles_by_thing`."""

from collections.abc import Collection
from typing import Any, get_args

from sqlalchemy import ColumnElement, FromClause, and_, delete, null, or_, select
from sqlalchemy import update as sql_update
from sqlalchemy.orm import Session

from sightline.enums import ActingRole, SurveyRole
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, change_row, get_row, missing
from sightline.infra.database.types import metadata
from sightline.infra.slices import load_tables
from sightline.infra.web.person import Person, Seen
from sightline.surveys.members.records import Candidate, Member
from sightline.surveys.members.tables import survey_members
from sightline.surveys.tables import surveys

_m = survey_members.c


def seen_surveys(session: Session, person: Person) -> Seen:
    """The surveys that a person sees: those open to all and those they belong to; None for all (an admin)."""
    if person.role == "admin":
        return None
    mine = select(_m.survey_id).where(_m.person_id == person.id)
    query = select(surveys.c.id).where(or_(surveys.c.open_to_all, surveys.c.id.in_(mine)))
    return frozenset(session.execute(query).scalars())


def seen_studies(session: Session, person: Person) -> Seen:
    """The studies a person sees: open ones, theirs whose surveys they all see; None for all (an admin)."""
    if person.role == "admin":
        return None
    load_tables()
    studies, belongs = metadata.tables["studies"].c, metadata.tables["study_members"].c
    mine = select(belongs.study_id).where(belongs.person_id == person.id)
    query = select(studies.id, studies.open_to_all, studies.surveys)
    query = query.where(studies.deleted_at.is_(None), or_(studies.open_to_all, studies.id.in_(mine)))
    seen = seen_surveys(session, person) or frozenset()
    return frozenset(
        row.id
        for row in session.execute(query)
        if row.open_to_all or all(one["survey_id"] in seen for one in row.surveys)
    )


def roles_by_thing(
    session: Session, person: Person, table: str, ids: Collection[int]
) -> dict[int, ActingRole]:
    """What a person is in the survey of each row of a table, by the row's id; left out: what they do not see.

    A row of no survey (a job of the installation) is met with the role of the account, a study and what is of
    one (its job) so by who sees the study. One statement, two where there are rows of studies.
    """
    load_tables()
    row = metadata.tables[table]
    belongs = _survey_of(row)
    mine = and_(_m.survey_id == surveys.c.id, _m.person_id == person.id)
    query = (
        select(row.c.id, belongs.label("survey_id"), surveys.c.open_to_all, _m.role, _study_of(row))
        .select_from(row if row is surveys else row.outerjoin(surveys, surveys.c.id == belongs))
        .outerjoin(survey_members, mine)
        .where(row.c.id.in_(ids))
    )
    roles: dict[int, ActingRole] = {}
    rows = session.execute(query).all()
    studies = seen_studies(session, person) if any(row.study_id is not None for row in rows) else None
    for id_, survey_id, open_to_all, role, study_id in rows:
        if studies is not None and study_id is not None and study_id not in studies:
            continue
        if survey_id is None or person.role == "admin" or (role is None and open_to_all):
            roles[id_] = person.role
        elif role is not None:
            roles[id_] = role
    return roles


def _study_of(row: FromClause) -> ColumnElement[int | None]:
    """The study of a table's rows, for those that are one or may be of one."""
    own: ColumnElement[Any] = row.c.id if row is metadata.tables["studies"] else row.c.get("study_id", null())
    return own.label("study_id")


def _survey_of(row: FromClause) -> ColumnElement[Any]:
    """The survey of a table's rows: their column, or their camera's (calibrations, images); studies: none."""
    if row is surveys:
        return surveys.c.id
    own: ColumnElement[int] | None = row.c.get("survey_id")
    if own is not None:
        return own
    if row is metadata.tables["studies"]:
        return null()
    cameras = metadata.tables["cameras"]
    return select(cameras.c.survey_id).where(cameras.c.id == row.c.camera_id).scalar_subquery()


def list_members(session: Session, survey_id: int) -> tuple[Member, ...]:
    """Who belongs to a survey, by name."""
    query = (
        select(people.c.id, people.c.name, _m.role, people.c.active, people.c.role)
        .join(people, people.c.id == _m.person_id)
        .where(_m.survey_id == survey_id)
        .order_by(people.c.name, people.c.id)
    )
    return tuple(Member(*row) for row in session.execute(query))


def list_others(session: Session, survey_id: int) -> tuple[Candidate, ...]:
    """Whom a manager may add: people with an account in use who do not belong to the survey, by name."""
    inside = select(_m.person_id).where(_m.survey_id == survey_id)
    query = select(people.c.id, people.c.name, people.c.role)
    query = query.where(people.c.active, people.c.id.not_in(inside))
    return tuple(Candidate(*row) for row in session.execute(query.order_by(people.c.name, people.c.id)))


def put_member(
    session: Session, survey_id: int, person_id: int, role: SurveyRole, *, actor: int | None
) -> None:
    """Make a person a member, or give a member another role.

    Raises:
        NotFound: there is no such person, or the account is switched off.
        Conflict: the survey would have no manager any more.
    """
    if role not in get_args(SurveyRole):
        raise BadInput("people-role-unknown", role=role, roles=", ".join(get_args(SurveyRole)))
    before = _member_row(session, survey_id, person_id)
    after = {"person_id": person_id, "role": role}
    if before is None:
        if not get_row(session, people, person_id, "person")["active"]:
            raise missing("person", person_id)
        row_id = add_row(session, survey_members, {"survey_id": survey_id, **after})
        trail.record(session, actor, "create", "survey_member", row_id, survey_id, None, after)
        return
    if before["role"] == "manager" and role != "manager":
        _keep_a_manager(session, survey_id, person_id)
    change_row(session, survey_members, before["id"], {"role": role})
    was = {"person_id": person_id, "role": before["role"]}
    trail.record(session, actor, "update", "survey_member", before["id"], survey_id, was, after)


def remove_member(session: Session, survey_id: int, person_id: int, *, actor: int | None) -> None:
    """Take a person out of a survey; what they did stays theirs.

    Raises:
        NotFound: they are no member.
        Conflict: the survey would have no manager any more.
    """
    before = _member_row(session, survey_id, person_id)
    if before is None:
        raise missing("member", person_id)
    if before["role"] == "manager":
        _keep_a_manager(session, survey_id, person_id)
    session.execute(delete(survey_members).where(_m.id == before["id"]))
    was = {"person_id": person_id, "role": before["role"]}
    trail.record(session, actor, "delete", "survey_member", before["id"], survey_id, was, None)


def open_survey_to_all(session: Session, survey_id: int, open_to_all: bool, *, actor: int | None) -> None:
    """Open a survey to everybody who signs in, or close it to all but its members. Raises NotFound."""
    before = get_row(session, surveys, survey_id, "survey")["open_to_all"]
    session.execute(sql_update(surveys).where(surveys.c.id == survey_id).values(open_to_all=open_to_all))
    was, after = {"open_to_all": before}, {"open_to_all": open_to_all}
    trail.record(session, actor, "update", "survey", survey_id, survey_id, was, after)


def _member_row(session: Session, survey_id: int, person_id: int) -> dict[str, Any] | None:
    query = select(survey_members).where(_m.survey_id == survey_id, _m.person_id == person_id)
    row = session.execute(query).mappings().one_or_none()
    return None if row is None else dict(row)


def _keep_a_manager(session: Session, survey_id: int, person_id: int) -> None:
    """Raises Conflict where nobody else with an account in use manages the survey."""
    others = (
        select(_m.id)
        .join(people, people.c.id == _m.person_id)
        .where(_m.survey_id == survey_id, _m.role == "manager", people.c.active, _m.person_id != person_id)
    )
    if session.execute(others).first() is None:
        raise Conflict("members-last-manager")
