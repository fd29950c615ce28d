"""Who belongs to a survey, and whether everybody does."""

from fastapi import APIRouter, Request

from sightline.infra.database import Session
from sightline.infra.web.deps import Manager, PathId, Reading, Viewer, Wired, access_of
from sightline.surveys.members import store
from sightline.surveys.members.bodies import MemberRole, MembersBody, Openness
from sightline.surveys.members.records import Candidate
from sightline.surveys.store import get_survey

router = APIRouter()


def _members(session: Session, survey_id: int) -> MembersBody:
    return MembersBody(
        open_to_all=get_survey(session, survey_id).open_to_all, members=store.list_members(session, survey_id)
    )


@router.get("/surveys/{survey_id}/members")
def list_members(survey_id: PathId, who: Viewer, session: Reading) -> MembersBody:
    """Who belongs to the survey and as what; administrators see and do everything without belonging to it."""
    return _members(session, survey_id)


@router.get("/surveys/{survey_id}/members/others")
def list_others(survey_id: PathId, who: Manager, session: Reading) -> tuple[Candidate, ...]:
    """Whom a manager may add."""
    return store.list_others(session, survey_id)


@router.put("/surveys/{survey_id}/members/{person_id}")
def put_member(
    survey_id: PathId, person_id: PathId, body: MemberRole, who: Manager, request: Request, services: Wired
) -> MembersBody:
    """Make a person a member, or give a member another role; one manager stays."""
    with services.writing(survey_id) as session:
        store.put_member(session, survey_id, person_id, body.role, actor=who.id)
        found = _members(session, survey_id)
    access_of(request).forget()
    return found


@router.delete("/surveys/{survey_id}/members/{person_id}")
def remove_member(
    survey_id: PathId, person_id: PathId, who: Manager, request: Request, services: Wired
) -> MembersBody:
    """Take a person out; what they did stays theirs. The last manager stays."""
    with services.writing(survey_id) as session:
        store.remove_member(session, survey_id, person_id, actor=who.id)
        found = _members(session, survey_id)
    access_of(request).forget()
    return found


@router.put("/surveys/{survey_id}/open-to-all")
def open_to_all(
    survey_id: PathId, body: Openness, who: Manager, request: Request, services: Wired
) -> MembersBody:
    """Open the survey to everybody who signs in, or close it to all but members and administrators."""
    with services.writing(survey_id) as session:
        store.open_survey_to_all(session, survey_id, body.open_to_all, actor=who.id)
        found = _members(session, survey_id)
    access_of(request).forget()
    return found
