"""What the person who asks may do to what a request names: found once, before any route runs.

A route's path names things by their kind and number (`/vehicles/{vehicle_id}/join`), its query and its body
by the types of their fields (`named`). Each belongs to a survey, and the person has a role there or does not
see it: then the answer is the one for what does not exist. The role that counts is the least in what path and
query name; what a body names is read from, so it must be seen and no more. A path may name no kind that is
not listed here, and no number in a query or body may be without its type; tests go through every route.
"""

import re
import threading
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import Protocol

from cachetools import TTLCache
from fastapi import Request
from sqlalchemy.orm import Session

from sightline.enums import ActingRole
from sightline.infra.database.rows import missing
from sightline.infra.services import BELIEVED_S, Services
from sightline.infra.web.named import Thing, named_thing, naming_of
from sightline.infra.web.person import Person, Seen

RANK: dict[ActingRole, int] = {"viewer": 0, "operator": 1, "reviewer": 2, "manager": 3, "admin": 4}
#: What stands before a number in a path, and the table that the number is of.
THINGS: Mapping[str, str] = {
    "surveys": "surveys",
    "photographs": "survey_photographs",
    "cameras": "cameras",
    "from": "cameras",
    "calibration-images": "calibration_images",
    "calibrations": "calibrations",
    "uploads": "uploads",
    "recordings": "recordings",
    "poses": "road_poses",
    "vehicles": "vehicles",
    "measurements": "measurement_series",
    "computings": "computings",
    "lots": "lots",
    "scans": "scans",
    "scan-vehicles": "scan_vehicles",
    "scan-measurements": "scan_measurements",
    "exports": "exports",
    "jobs": "jobs",
    "studies": "studies",
}
#: Kinds that are of no survey, or that the path finds within another.
APART = frozenset({"people", "catalogue", "members", "results", "tokens", "checkpoints"})
#: Looked at each time: who sees a study follows from its members and from those of each of its surveys.
NEVER_BELIEVED = "studies"
MOST_BELIEVED = 65536
_NAMED = re.compile(r"/([a-z-]+)/\{(\w+_id)\}")


class Members(Protocol):
    """The three questions, as the room of surveys answers them."""

    def seen_surveys(self, session: Session, person: Person) -> Seen: ...

    def seen_studies(self, session: Session, person: Person) -> Seen: ...

    def roles_by_thing(
        self, session: Session, person: Person, table: str, ids: Collection[int]
    ) -> dict[int, ActingRole]: ...


class Access:
    """Finds the role in which a person asks; believes for a moment what it found."""

    def __init__(
        self, services: Services, members: Members, timer: Callable[[], float] = time.monotonic
    ) -> None:
        self._services = services
        self._members = members
        self._known: TTLCache[tuple[int, Thing], ActingRole] = TTLCache(MOST_BELIEVED, BELIEVED_S, timer)
        self._age = 0
        self._lock = threading.Lock()

    def known_role(self, request: Request, person: Person, in_body: Collection[Thing]) -> ActingRole | None:
        """`role` where all that it needs was found within the last moments; None where it was not."""
        asked = dict.fromkeys(things_of(request))
        with self._lock:
            known = {one: self._known.get((person.id, one)) for one in (*asked, *in_body)}
        roles = [role for role in known.values() if role is not None]
        if len(roles) < len(known):
            return None
        return min((known[one] or person.role for one in asked), key=RANK.__getitem__, default=person.role)

    def role(self, request: Request, person: Person, in_body: Collection[Thing]) -> ActingRole:
        """The least that the person is in the surveys that the request is about; of none: the account's role.

        Raises:
            NotFound: something named is not there, or the person does not see it; the answer is the same.
        """
        asked = dict.fromkeys(things_of(request))
        roles = self._roles_at(person, dict.fromkeys((*asked, *in_body)))
        return min((roles[one] for one in asked), key=RANK.__getitem__, default=person.role)

    def seen(self, session: Session, person: Person) -> Seen:
        """The surveys that a person sees, for lists; None for all."""
        return self._members.seen_surveys(session, person)

    def seen_studies(self, session: Session, person: Person) -> Seen:
        """The studies that a person sees, for lists; None for all."""
        return self._members.seen_studies(session, person)

    def forget(self) -> None:
        """Read afresh; called after every change of an account or of a survey's members."""
        with self._lock:
            self._known.clear()
            self._age += 1

    def _roles_at(self, person: Person, things: Iterable[Thing]) -> dict[Thing, ActingRole]:
        with self._lock:
            age = self._age
            known = {one: self._known.get((person.id, one)) for one in things}
        roles = {one: role for one, role in known.items() if role is not None}
        unknown = [one for one, role in known.items() if role is None]
        if not unknown:
            return roles
        with self._services.reading() as session:
            for table in dict.fromkeys(table for table, _ in unknown):
                ids = [id_ for its, id_ in unknown if its == table]
                found = self._members.roles_by_thing(session, person, table, ids)
                roles |= {(table, id_): role for id_, role in found.items()}
        for table, id_ in unknown:
            if (table, id_) not in roles:
                raise missing(_word(table), id_)
        with self._lock:
            # What was read before a change must not be believed after it.
            if age == self._age:
                believed = (one for one in unknown if one[0] != NEVER_BELIEVED)
                self._known.update({(person.id, one): roles[one] for one in believed})
        return roles


def things_of(request: Request) -> Iterator[Thing]:
    """What path and query name that belongs to a survey; what is no number is left to the route."""
    route = request.scope["route"]
    for kind, name in _NAMED.findall(route.path):
        if kind not in APART:
            yield from named_thing(THINGS[kind], str(request.path_params[name]))
    yield from naming_of(route).in_query(request)


def _word(table: str) -> str:
    """What a person calls a row of the table."""
    return _WORDS.get(table, table.removesuffix("s").replace("_", " "))


_WORDS = {
    "survey_photographs": "photograph",
    "calibration_images": "image",
    "measurement_series": "measurement",
    "scan_vehicles": "vehicle",
    "scan_measurements": "measurement",
    "road_poses": "pose",
    "studies": "study",
}
