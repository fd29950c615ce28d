"""The router that is found at once is the one that is found by trying all."""

import re
from typing import Any

import pytest
from fastapi.routing import APIRoute
from starlette.routing import Match

from sightline.app import ROUTERS, api_routes
from sightline.infra.web.nearest import Nearest

pytestmark = pytest.mark.once


def _scope(method: str, path: str) -> dict[str, Any]:
    return {"type": "http", "method": method, "path": path, "root_path": "", "headers": []}


def _first_of_all(method: str, path: str) -> Any:
    """The first router that answers it whole, each one asked."""
    for router in api_routes()[1:]:
        if router.matches(_scope(method, path))[0] is Match.FULL:
            return router
    return None


def test_every_route_is_found_and_no_other() -> None:
    nearest = api_routes()[0]
    assert isinstance(nearest, Nearest)
    routes = [one for _, router in ROUTERS for one in router.routes if isinstance(one, APIRoute)]
    assert len(routes) > 200
    for route in routes:
        path = "/api" + re.sub(r"{[^}]*}", "7", route.path)
        for method in route.methods:
            match, child = nearest.matches(_scope(method, path))
            assert match is Match.FULL, (method, path)
            assert child["sightline.nearest"] is _first_of_all(method, path)


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("TRACE", "/api/surveys"),
        ("GET", "/api/nothing"),
        ("GET", "/api"),
        ("GET", "/"),
        ("GET", "/api/surveys/7/"),
        ("GET", "/people/7"),
    ],
)
def test_what_no_route_answers_whole_is_left_to_the_routes_behind(method: str, path: str) -> None:
    assert api_routes()[0].matches(_scope(method, path)) == (Match.NONE, {})
