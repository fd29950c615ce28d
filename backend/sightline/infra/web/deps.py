"""What routes depend on: the services of the app, a database session, and who is asking with which role.

    @router.get("/surveys")
    def list_surveys(who: Viewer, session: Reading) -> list[SurveyBody]: ...

    @router.post("/surveys", status_code=201)
    def add_survey(body: NewSurvey, who: Operator, session: Writing) -> SurveyBody: ...

Put the person before the session: nobody who may not write ever waits for the write lock. A route that works
long before it writes (corner detection in an image, say) takes `Wired` and opens `services.writing()` itself,
at the end. Every route declares a role (`Viewer`, `Operator`, `Reviewer`, `Manager`, `Admin`) or is `OPEN`;
a test walks all of them. The role is the one in the survey of what the path names (`access`). A list of
more than one survey takes `SurveysSeen`.
"""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Annotated

from fastapi import Depends, Path, Request
from fastapi.concurrency import contextmanager_in_threadpool
from sqlalchemy.orm import Session

from sightline.enums import ActingRole
from sightline.errors import NotAllowed, NotSignedIn
from sightline.infra.services import Services
from sightline.infra.web.access import RANK, Access
from sightline.infra.web.person import Person, Seen
from sightline.infra.web.turns import Turns
from sightline.infra.web.write_gate import WriteGate


async def services_of(request: Request) -> Services:
    """The services that `create_app` put on the app."""
    services: Services = request.app.state.services
    return services


Wired = Annotated[Services, Depends(services_of)]


async def reading_session(request: Request, services: Wired) -> AsyncIterator[Session]:
    turns: Turns = request.app.state.readers
    async with turns.turn(), contextmanager_in_threadpool(services.reading()) as session:
        yield session


async def writing_session(request: Request, services: Wired) -> AsyncIterator[Session]:
    gate: WriteGate = request.app.state.write_gate
    async with gate.unit(services.writing()) as session:
        yield session


@asynccontextmanager
async def writing_to(
    request: Request, services: Services, survey_of: Callable[[Session], int]
) -> AsyncIterator[Session]:
    """The session of a route that writes to one survey only: writers of other surveys need not wait for it.

    `survey_of` finds the survey's number by what the path names; 0 where there is no such thing.
    """
    gate: WriteGate = request.app.state.write_gate
    async with gate.unit(services.writing(survey_of)) as session:
        yield session


# scope="function": the commit happens before the answer is sent, so a failed one is never answered with 200.
Reading = Annotated[Session, Depends(reading_session, scope="function")]
Writing = Annotated[Session, Depends(writing_session, scope="function")]


def current_person(request: Request) -> Person:
    """The signed-in person.

    Raises:
        NotSignedIn: no cookie, a forged or old one, or an account that is switched off.
    """
    person: Person | None = request.app.state.sign_in.person_of(request)
    if person is None:
        raise NotSignedIn("web-you-not-signed-sign-try-again")
    return person


SignedIn = Annotated[Person, Depends(current_person)]


def access_of(request: Request) -> Access:
    """Who may do what to which survey."""
    access: Access = request.app.state.access
    return access


def acting_role(request: Request, person: SignedIn) -> ActingRole:
    """In which role the person asks: theirs in the survey of what the request names, else the account's."""
    return access_of(request).role(request, person)


def surveys_seen(request: Request, person: SignedIn, session: Reading) -> Seen:
    """The surveys that the person sees, for lists of more than one; None for all."""
    return access_of(request).seen(session, person)


ActingAs = Annotated[ActingRole, Depends(acting_role)]
SurveysSeen = Annotated[Seen, Depends(surveys_seen)]


class require:
    """A dependency that lets only people through who ask in this role, or in one above it."""

    def __init__(self, role: ActingRole) -> None:
        self.role: ActingRole = role

    def __call__(self, person: SignedIn, role: ActingAs) -> Person:
        if RANK[role] < RANK[self.role]:
            raise NotAllowed("web-needs-role-you-ask-admin", needed=self.role, role=role)
        return person


def anybody() -> None:
    """Declares a route that needs no sign-in."""


OPEN = Depends(anybody)
Viewer = Annotated[Person, Depends(require("viewer"))]
Operator = Annotated[Person, Depends(require("operator"))]
Reviewer = Annotated[Person, Depends(require("reviewer"))]
Manager = Annotated[Person, Depends(require("manager"))]
Admin = Annotated[Person, Depends(require("admin"))]

# Ids are 32-bit in PostgreSQL; a larger number is a malformed id and not a database error.
PathId = Annotated[int, Path(ge=1, le=2**31 - 1)]
PathFrame = Annotated[int, Path(ge=0, le=2**31 - 1)]
