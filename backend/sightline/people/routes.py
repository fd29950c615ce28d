"""Accounts, for admins."""

from fastapi import APIRouter, Request

from sightline.infra.web.deps import Admin, PathId, Reading, Wired
from sightline.infra.web.idempotency import TOLD_ONCE
from sightline.infra.web.person import PersonFacts
from sightline.people import store
from sightline.people.bodies import Invited, Link, NewPerson, PersonChange
from sightline.people.service import link_path

router = APIRouter()


@router.get("/people")
def list_people(who: Admin, session: Reading) -> list[PersonFacts]:
    """Everybody who has an account."""
    return list(store.list_people(session))


@router.post("/people", status_code=201, dependencies=[TOLD_ONCE])
def add_person(body: NewPerson, who: Admin, services: Wired) -> Invited:
    """A new account, and the one-time link with which the person signs in first."""
    with services.writing() as session:
        person = store.create_person(session, name=body.name, email=body.email, role=body.role, actor=who.id)
        token = store.create_sign_in_link(session, person.id, actor=who.id)
    return Invited(person=person, link=link_path(token))


@router.put("/people/{person_id}")
def change_person(
    person_id: PathId, body: PersonChange, who: Admin, request: Request, services: Wired
) -> PersonFacts:
    """Change name, role or access; the last admin stays one."""
    with services.writing() as session:
        person = store.update_person(
            session, person_id, name=body.name, role=body.role, active=body.active, actor=who.id
        )
    request.app.state.sign_in.forget()
    request.app.state.access.forget()
    request.app.state.bearers.forget()
    return person


@router.post("/people/{person_id}/link", status_code=201, dependencies=[TOLD_ONCE])
def new_link(person_id: PathId, who: Admin, services: Wired) -> Link:
    """A fresh one-time link for somebody who lost the first or the password; older ones end."""
    with services.writing() as session:
        token = store.create_sign_in_link(session, person_id, actor=who.id)
    return Link(link=link_path(token))
