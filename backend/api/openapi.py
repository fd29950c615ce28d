"""Writes the API's description, for the front end's types: python -m backend.api.openapi FILE."""

import json
import sys
from importlib.metadata import version
from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.routing import APIRoute

from backend.api.routes import include_routes

TITLE = "Sightline"
VERSION = version("sightline")
DESCRIPTION = (
    "Heights of vehicles from roadside video, with their uncertainty and an audit trail. "
    "Sign in with POST /api/session; every request that changes something carries the header "
    '`X-Sightline: 1`. Every error is `{"error": {"code", "message"}}` with one sentence that says '
    "what is wrong and what to do."
)


def operation_id(route: APIRoute) -> str:
    """Short, stable names for generated clients: the name of the function."""
    return route.name


def describe() -> dict[str, Any]:
    """The OpenAPI document, without opening a database or a media store."""
    app = FastAPI(
        title=TITLE, version=VERSION, description=DESCRIPTION, generate_unique_id_function=operation_id
    )
    include_routes(app)
    return app.openapi()


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print("Name the file to write: python -m backend.api.openapi FILE", file=sys.stderr)
        return 2
    target = Path(arguments[0])
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(describe(), indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
