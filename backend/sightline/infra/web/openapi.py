"""What the API says of itself."""

from importlib.metadata import version

from fastapi.routing import APIRoute

TITLE = "Sightline"
VERSION = version("sightline").partition("+")[0]
DESCRIPTION = (
    "Heights of vehicles from roadside video, with their uncertainty and an audit trail. "
    "Sign in with POST /api/session; every request that changes something carries the header "
    '`X-Sightline: 1`. Every error is `{"error": {"code", "message"}}` with one sentence that says '
    "what is wrong and what to do."
)


def operation_id(route: APIRoute) -> str:
    """Short, stable names for generated clients: the name of the function."""
    return route.name
