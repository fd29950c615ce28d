"""What routes depend on: the services of the app, a database session, and who is asking with which role.

    @router.get("/surveys")
    def list_surveys(who: Viewer, session: Reading) -> list[SurveyBody]: ...

    @router.post("/surveys", status_code=201)
    def add_survey(body: NewSurvey, who: Operator, session: Writing) -> SurveyBody: ...

Put the person before the session: nobody who may not write ever waits for the write lock. A route that works
long before it writes (corner detection in an image, say) takes `Wired` and opens `services.writing()` itself,
at the end; one that stores a click takes `Writes`. Every route declares a role, and with it the scope that
a token needs (`Viewer`: read; `Operator`: measure; `InPerson`: no token will do), or is `OPEN`; a test walks
all of them. The role is the one in the survey of what path and query name, and what the body names must be
seen (`access`). A list of more than one survey takes `SurveysSeen`.
"""

from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from typing import Annotated, TypeVar

from fastapi import Depends, Path, Request
from fastapi.concurrency import contextmanager_in_threadpool, run_in_threadpool
from sqlalchemy.orm import Session

from sightline.enums import ActingRole, Scope
from sightline.errors import NotAllowed, NotSignedIn
from sightline.infra.database.engine import SurveyOf
from sightline.infra.idempotency.request import keyed_request
from sightline.infra.services import Services
from sightline.infra.web.access import RANK, Access
from sightline.infra.web.bearer import Bearers, bearer_of
from sightline.infra.web.named import Thing, naming_of
from sightline.infra.web.person import Asking, Person, Seen
from sightline.infra.web.spoken import language_of
from sightline.infra.web.turns import Turns
from sightline.infra.web.write_gate import WriteGate

T = TypeVar("T")


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


@dataclass(frozen=True, slots=True)
class ShortWrites:
    """For what people do all day: the whole of a write in one visit of the writers' thread, those of several
    requests together (`WriteGate.write`). Its route is `async` and does nothing else that takes time.
    """

    _gate: WriteGate
    _services: Services

    async def to(self, survey: SurveyOf, work: Callable[[Session], T]) -> T:
        """What `work` returns, once stored for good; it writes to no `survey` but the one the path names."""
        return await self._gate.write(self._services, survey, work)


async def short_writes(request: Request, services: Wired) -> ShortWrites:
    return ShortWrites(request.app.state.write_gate, services)


Writes = Annotated[ShortWrites, Depends(short_writes)]


# scope="function": the commit happens before the answer is sent, so a failed one is never answered with 200.
Reading = Annotated[Session, Depends(reading_session, scope="function")]
Writing = Annotated[Session, Depends(writing_session, scope="function")]


def asked_in(request: Request) -> str:
    """The language that a request asks for, one of the catalogue's."""
    return language_of(request.scope)


AskedIn = Annotated[str, Depends(asked_in)]


async def asking(request: Request) -> Asking:
    """The signed-in person, or the one whose token came with the request; then the cookie counts for nothing.

    Raises:
        NotSignedIn: no cookie, a forged or old one, a token that does not hold, or an account switched off.
        TooMany: too many requests with this token, or too many wrong tokens from one address.
    """
    # Whoever asks again within moments is known: no thread is needed to find that out.
    if bearer_of(request.headers) is None:
        known: Person | None = request.app.state.sign_in.known_person_of(request)
        if known is not None:
            return _noted(Asking(known))
    return _noted(await run_in_threadpool(_identify_asker, request))


def _noted(asking: Asking) -> Asking:
    """A request that bears a key is known by who asks."""
    request = keyed_request()
    if request is not None:
        request.person_id = asking.person.id
    return asking


def _identify_asker(request: Request) -> Asking:
    text = bearer_of(request.headers)
    if text is None:
        person: Person | None = request.app.state.sign_in.person_of(request)
        if person is None:
            raise NotSignedIn("web-not-signed-in")
        return Asking(person)
    bearers: Bearers = request.app.state.bearers
    is_first = not hasattr(request.state, "spent")
    token = bearers.token_of(text, address_of(request), spending=is_first)
    request.state.spent = True
    owner = None if token is None else request.app.state.sign_in.person(token.person_id)
    if token is None or owner is None:
        raise NotSignedIn("web-token-invalid")
    return Asking(owner, token.scopes)


def address_of(request: Request) -> str:
    """Where a request comes from, for limits."""
    return request.client.host if request.client else ""


async def current_person(who: Annotated[Asking, Depends(asking)]) -> Person:
    """The person who asks, themselves or by a program."""
    return who.person


SignedIn = Annotated[Person, Depends(current_person)]


def access_of(request: Request) -> Access:
    """Who may do what to which survey."""
    access: Access = request.app.state.access
    return access


async def named_in_body(request: Request) -> tuple[Thing, ...]:
    """What the request's body names."""
    return await naming_of(request.scope["route"]).in_body(request)


async def acting_role(
    request: Request, person: SignedIn, in_body: Annotated[tuple[Thing, ...], Depends(named_in_body)]
) -> ActingRole:
    """In which role the person asks: theirs in the survey of what the request names, else the account's."""
    access = access_of(request)
    known = access.known_role(request, person, in_body)
    return await run_in_threadpool(access.role, request, person, in_body) if known is None else known


def surveys_seen(request: Request, person: SignedIn, session: Reading) -> Seen:
    """The surveys that the person sees, for lists of more than one; None for all."""
    return access_of(request).seen(session, person)


def studies_seen(request: Request, person: SignedIn, session: Reading) -> Seen:
    """The studies that the person sees, for lists of what may be of one; None for all."""
    return access_of(request).seen_studies(session, person)


ActingAs = Annotated[ActingRole, Depends(acting_role)]
SurveysSeen = Annotated[Seen, Depends(surveys_seen)]
StudiesSeen = Annotated[Seen, Depends(studies_seen)]


class require:
    """A dependency that lets only people through who ask in this role, or in one above it.

    A token needs the scope beside the role; what has none is done by people who signed in themselves.
    """

    def __init__(self, role: ActingRole, scope: Scope | None) -> None:
        self.role: ActingRole = role
        self.scope = scope

    async def __call__(self, who: Annotated[Asking, Depends(asking)], role: ActingAs) -> Person:
        return self.check(who, role)

    def check(self, who: Asking, role: ActingRole) -> Person:
        """The person, where role and scope suffice. Raises NotAllowed."""
        if RANK[role] < RANK[self.role]:
            raise NotAllowed("web-needs-role", needed=self.role, role=role)
        if who.scopes is not None and self.scope not in who.scopes:
            raise self._refused(who.scopes)
        return who.person

    def _refused(self, scopes: tuple[Scope, ...]) -> NotAllowed:
        if self.scope is None:
            return NotAllowed("web-token-never")
        return NotAllowed("web-token-lacks-scope", needed=self.scope, scopes=", ".join(scopes))


async def allow_anybody() -> None:
    """Declares a route that needs no sign-in."""


OPEN = Depends(allow_anybody)
Viewer = Annotated[Person, Depends(require("viewer", "read"))]
Stopper = Annotated[Person, Depends(require("viewer", "measure"))]
Exporter = Annotated[Person, Depends(require("viewer", "export"))]
InPerson = Annotated[Person, Depends(require("viewer", None))]
Operator = Annotated[Person, Depends(require("operator", "measure"))]
_UPLOADER = require("operator", "upload")
Uploader = Annotated[Person, Depends(_UPLOADER)]
OperatorInPerson = Annotated[Person, Depends(require("operator", None))]
Reviewer = Annotated[Person, Depends(require("reviewer", "review"))]
Manager = Annotated[Person, Depends(require("manager", None))]
Admin = Annotated[Person, Depends(require("admin", None))]

# Ids are 32-bit in PostgreSQL; a larger number is a malformed id and not a database error.
PathId = Annotated[int, Path(ge=1, le=2**31 - 1)]
PathFrame = Annotated[int, Path(ge=0, le=2**31 - 1)]


def require_uploader_still(request: Request) -> None:
    """Ask again, in the middle of a long request and in a thread, what `Uploader` asked at its beginning.

    Raises:
        NotSignedIn, NotFound, NotAllowed: signed out, taken out of the survey, or given a lesser role since.
    """
    who = _identify_asker(request)
    _UPLOADER.check(who, access_of(request).role(request, who.person, ()))
