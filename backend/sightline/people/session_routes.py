"""Signing in and out, and who am I."""

from collections.abc import Callable

from fastapi import APIRouter, Request, Response

from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.infra.web.cookie import SignIn
from sightline.infra.web.deps import OPEN, InPerson, Viewer, Wired, address_of
from sightline.infra.web.person import Person
from sightline.people import service, store
from sightline.people.bodies import Credentials, LinkToken, Me, NewPassword, OwnName

router = APIRouter()


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
