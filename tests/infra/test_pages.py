"""Addresses of the front end: a reload of any page is answered with the pages, not with a 404."""

import re
from pathlib import Path

from sightline.infra.web.pages import FRONT_END_ROUTE

PLACES = Path(__file__).resolve().parents[2] / "frontend" / "src" / "core" / "places.ts"


def test_the_server_knows_every_route_of_the_front_end() -> None:
    patterns = re.findall(r': \["(/[^"]*)", "\w+", "[^"]+"\],', PLACES.read_text(encoding="utf-8"))
    assert len(patterns) > 10
    unknown = [one for one in patterns if not FRONT_END_ROUTE.match(one.replace(":id", "7").lstrip("/"))]
    assert unknown == []
    assert not FRONT_END_ROUTE.match("surveys/7/nothing")
