"""Signing in and out, and who am I."""

from collections.abc import Callable
from typing import Annotated

from fastapi import APIRouter, Request, Response
from pydantic import Field

from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.infra.web.bodies import In, Name, Out, example
from sightline.infra.web.cookie import SignIn
from sightline.infra.web.deps import OPEN, InPerson, Viewer, Wired, address_of
from sightline.infra.web.person import Person, PersonFacts
from sightline.people import service, store

router = APIRouter()

Secret = Annotated[str, Field(max_length=1000)]


class Credentials(In):
    model_config = example(email="ada@example.org", password="a few words in a row")

    email: Annotated[str, Field(max_length=320)]
    password: Secret


class LinkToken(In):
    token: Secret


class NewPassword(In):
    current: Secret | None = None
    new: Annotated[str, Field(min_length=service.MIN_PASSWORD, max_length=service.MAX_PASSWORD)]


class Me(Out):
    person: PersonFacts
    version: str
    needs_password: bool = Field(
        description="No password yet, or here by a one-time link: the current one is not asked."
    )
    needs_name: bool = Field(description="The first administrator, who was not asked for a name yet.")
    demo_survey_id: int | None


class OwnName(In):
    name: Name


@router.post("/session", dependencies=[OPEN])
def sign_in(body: Credentials, request: Request, response: Response, services: Wired) -> Me:
    """Sign in with email and password; five failures within five minutes make you wait."""
    attempts: service.Attempts = request.app.state.attempts
    person = service.sign_in(services, attempts, body.email, body.password, address_of(request))
    return _welcome(request, response, services, person, by_link=False)


@router.post("/session/link", dependencies=[OPEN])
def sign_in_by_link(body: LinkToken, request: Request, response: Response, services: Wired) -> Me:
    """Sign in with the token of a one-time link."""
    person = service.sign_in_by_link(services, request.app.state.attempts, body.token, address_of(request))
    return _welcome(request, response, services, person, by_link=True)


@router.get("/session")
def who_am_i(who: Viewer, request: Request, services: Wired) -> Me:
    """The signed-in person and what the front end needs to begin."""
    return _answer_me(request, services, who, _cookies(request).by_link(request))


@router.delete("/session", status_code=204, dependencies=[OPEN])
def sign_out(request: Request, response: Response, services: Wired) -> None:
    """Sign out, everywhere: a copy of the cookie is worth nothing afterwards. Done also without a session.

    The browser is told to let go of everything it kept of this site, where it listens (over HTTPS).
    """
    cookies = _cookies(request)
    person = cookies.person_of(request)
    if person is not None:
        with services.writing() as session:
            store.end_sessions(session, person.id, actor=person.id)
        cookies.forget()
    cookies.end(response)
    response.headers["Clear-Site-Data"] = '"cache"'


@router.put("/session/password")
def change_password(
    body: NewPassword, who: InPerson, request: Request, response: Response, services: Wired
) -> Me:
    """Set the password; every other session of the person ends."""
    attempts, by_link = request.app.state.attempts, _cookies(request).by_link(request)
    address = address_of(request)
    person = service.change_password(services, attempts, who, body.current, body.new, by_link, address)
    return _welcome(request, response, services, person, by_link=False)


@router.put("/session/name")
def change_name(body: OwnName, who: InPerson, request: Request, services: Wired) -> Me:
    """Say what one is called: the name stands beside everything that one does."""
    person = service.change_name(services, who, body.name)
    return _answer_me(request, services, person, _cookies(request).by_link(request))


def _cookies(request: Request) -> SignIn:
    cookies: SignIn = request.app.state.sign_in
    return cookies


def _welcome(
    request: Request, response: Response, services: Services, person: Person, *, by_link: bool
) -> Me:
    cookies = _cookies(request)
    cookies.forget()
    cookies.remember(response, person, by_link=by_link)
    return _answer_me(request, services, person, by_link)


def _answer_me(request: Request, services: Services, person: Person, by_link: bool) -> Me:
    demo_survey_id: Callable[[Session], int | None] = request.app.state.demo_survey_id
    with services.reading() as session:
        demonstration = demo_survey_id(session)
    return Me(
        person=person,
        version=code_version(),
        needs_password=by_link or not person.has_password,
        needs_name=(person.name, person.email) == service.FIRST_ADMIN,
        demo_survey_id=demonstration,
    )
