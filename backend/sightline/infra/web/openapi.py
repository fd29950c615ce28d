"""What the API says of itself."""

from collections.abc import Iterator
from importlib.metadata import version
from typing import Any

from fastapi import FastAPI
from fastapi.routing import APIRoute

from sightline.infra.web.bodies import ErrorBody

TITLE = "Sightline"
VERSION = version("sightline").partition("+")[0]
DESCRIPTION = (
    "Heights of vehicles from roadside video, with their uncertainty and an audit trail. "
    "Sign in with POST /api/session; every request that changes something carries the header "
    "`X-Sightline: 1`. With an `Idempotency-Key` of its own it may be sent again when no answer came: it is "
    "stored once, and answered as the first time. "
    'Every error is `{"error": {"kind", "code", "values", "message"}}` with one '
    "sentence that says what is wrong and what to do."
)


class Api(FastAPI):
    """The application, whose description says that an answer is whole.

    What is answered is a record, and a record's field is always there: that it can be left out where the
    record is made (its default) is no business of the reader's.
    """

    def openapi(self) -> dict[str, Any]:
        if self.openapi_schema is None:
            found = super().openapi()
            schemas = found["components"]["schemas"]
            operations = [operation for path in found["paths"].values() for operation in path.values()]
            taken = _reached([one.get("requestBody") for one in operations], schemas)
            for name in _reached([one["responses"] for one in operations], schemas) - taken:
                if name != ErrorBody.__name__ and "properties" in schemas[name]:
                    schemas[name]["required"] = list(schemas[name]["properties"])
        return super().openapi()


def _reached(part: Any, schemas: dict[str, Any]) -> set[str]:
    """The names of the schemas that a part of the description refers to, and those that they refer to."""
    names: set[str] = set()
    waiting = list(_references(part))
    while waiting:
        name = waiting.pop()
        if name not in names:
            names.add(name)
            waiting += _references(schemas[name])
    return names


def _references(part: Any) -> Iterator[str]:
    if isinstance(part, dict):
        if isinstance(part.get("$ref"), str):
            yield part["$ref"].rpartition("/")[2]
        part = list(part.values())
    if isinstance(part, list):
        for one in part:
            yield from _references(one)


def operation_id(route: APIRoute) -> str:
    """Short, stable names for generated clients: the name of the function."""
    return route.name
