"""In front of the routes: the routers that may answer a path, found at once instead of tried one by one.

There are some fifty routers with four hundred routes, and a path is held against their patterns one after the
other; for a click that took longer than its geometry. This finds by the words at the fixed places of a path
those few routers that have such a route. Whatever they do not answer whole goes on to the routes behind, as
if this were not there: another method, a path that nobody has.
"""

from collections.abc import Iterable, Mapping

from starlette.routing import BaseRoute, Match
from starlette.types import Receive, Scope, Send

_CHOSEN = "sightline.nearest"
#: What is told of a path: how many parts it has, and its second part (the first is always "api").
_Shape = tuple[int, str]


class Nearest(BaseRoute):
    """The first of the routers near a path that answers it whole, in their order."""

    def __init__(self, routers: Iterable[tuple[BaseRoute, Iterable[str]]]) -> None:
        """Each router with the patterns of its paths; one of any length (`{name:path}`) is left out."""
        near: dict[_Shape, list[BaseRoute]] = {}
        for router, patterns in routers:
            for shape in dict.fromkeys(shape_of(one) for one in patterns if ":" not in one):
                near.setdefault(shape, []).append(router)
        self._near: Mapping[_Shape, list[BaseRoute]] = near

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        if scope["type"] == "http":
            for router in self._near.get(shape_of(scope["path"]), ()):
                match, child = router.matches(scope)
                if match is Match.FULL:
                    return match, {**child, _CHOSEN: router}
        return Match.NONE, {}

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        router: BaseRoute = scope[_CHOSEN]
        await router.handle(scope, receive, send)


def shape_of(path: str) -> _Shape:
    """By what a path or a pattern is found; a pattern's second part is a word, never a number."""
    parts = path.split("/", 3)
    return path.count("/"), parts[2] if len(parts) > 2 else ""
