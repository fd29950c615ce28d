"""All routes of the API, in the order in which the work goes."""

from importlib import import_module
from importlib.util import find_spec

from fastapi import APIRouter, FastAPI

from backend.api.bodies import ErrorBody

MODULES = (
    "health",
    "session",
    "people",
    "surveys",
    "photographs",
    "cameras",
    "calibrations",
    "uploads",
    "recordings",
    "frames",
    "planning",
    "poses",
    "checks",
    "drift",
    "assist",
    "geometry",
    "vehicles",
    "passes",
    "catalogue",
    "measurements",
    "reviews",
    "repeats",
    "scans",
    "scans_vehicles",
    "line_heights",
    "scans_statistics",
    "statistics",
    "exports",
    "audit",
    "jobs",
)
ERRORS = (400, 401, 403, 404, 405, 409, 412, 413, 415, 422, 429, 500, 503, 507)


def include_routes(app: FastAPI) -> None:
    """Put every module's `router` under /api; each answers errors with the one error body."""
    for name in MODULES:
        if find_spec(f"backend.api.{name}") is None:
            continue
        router: APIRouter = import_module(f"backend.api.{name}").router
        app.include_router(
            router, prefix="/api", tags=[name], responses={status: {"model": ErrorBody} for status in ERRORS}
        )
