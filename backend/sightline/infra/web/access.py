"""What the person who asks may do to what a request names: found once, before any route runs.

A route's path names things by their kind and number (`/vehicles/{vehicle_id}/join`), its query names surveys,
calibrations and recordings. Each belongs to a survey, and the person has a role there or does not see it:
then the answer is the one for what does not exist. A path may name no kind that is not listed here; a test
goes through every route.
"""

import re
import threading
import time
from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Protocol

from cachetools import TTLCache
from fastapi import Request
from sqlalchemy.orm import Session

from sightline.enums import ActingRole
from sightline.infra.database.rows import missing
from sightline.infra.services import Services
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
    "line-heights": "line_heights",
    "exports": "exports",
    "jobs": "jobs",
}
#: Kinds that are of no survey (a study has members of its own), or that the path finds within another.
APART = frozenset({"people", "catalogue", "members", "studies", "results"})
#: Names of a query's values that number a thing, and its table.
ASKED_FOR: Mapping[str, str] = {
    "survey": "surveys",
    "survey_id": "surveys",
    "calibration_id": "calibrations",
    "recording_id": "recordings",
}
# How long another process may still believe what it read; in this one, changes count at once.
BELIEVED_S = 2.0
MOST_BELIEVED = 65536
_MOST_ID = 2**31 - 1
_NAMED = re.compile(r"/([a-z-]+)/\{(\w+_id)\}")

Thing = tuple[str, int]


class Members(Protocol):
    """The two questions, as the room of surveys answers them."""

    def seen_surveys(self, session: Session, person: Person) -> Seen: ...

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

    def role(self, request: Request, person: Person) -> ActingRole:
        """The least that the person is in the surveys that the request is about; of none: the account's role.

        Raises:
            NotFound: something named is not there, or the person does not see it; the answer is the same.
        """
        roles = [self._role_at(person, thing) for thing in things_of(request)]
        return min(roles, key=RANK.__getitem__, default=person.role)

    def seen(self, session: Session, person: Person) -> Seen:
        """The surveys that a person sees, for lists; None for all."""
        return self._members.seen_surveys(session, person)

    def forget(self) -> None:
        """Read afresh; called after every change of an account or of a survey's members."""
        with self._lock:
            self._known.clear()
            self._age += 1

    def _role_at(self, person: Person, thing: Thing) -> ActingRole:
        key = (person.id, thing)
        with self._lock:
            known, age = self._known.get(key), self._age
        if known is not None:
            return known
        table, id_ = thing
        with self._services.reading() as session:
            role = self._members.roles_by_thing(session, person, table, [id_]).get(id_)
        if role is None:
            raise missing(_word(table), id_)
        with self._lock:
            # What was read before a change must not be believed after it.
            if age == self._age:
                self._known[key] = role
        return role


def things_of(request: Request) -> Iterator[Thing]:
    """What a request names that belongs to a survey; malformed numbers are left to the route's own check."""
    for kind, name in _NAMED.findall(request.scope["route"].path):
        if kind in APART:
            continue
        yield from _thing(THINGS[kind], str(request.path_params[name]))
    for name, table in ASKED_FOR.items():
        for value in dict.fromkeys(request.query_params.getlist(name)):
            yield from _thing(table, value)


def _thing(table: str, value: str) -> Iterator[Thing]:
    try:
        id_ = int(value)
    except ValueError:
        return
    if 1 <= id_ <= _MOST_ID:
        yield table, id_


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
    "line_heights": "height",
}
