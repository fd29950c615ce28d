"""create_app(): routers, one error handler, the guard, and the built front end."""

import asyncio
import logging
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import cache
from importlib import import_module
from typing import Any

import anyio
from fastapi import APIRouter, FastAPI
from fastapi.params import Form
from fastapi.routing import APIRoute
from prometheus_client import CollectorRegistry
from starlette.middleware.gzip import GZipMiddleware
from starlette.routing import BaseRoute, compile_path

import sightline.job_handlers
from sightline.errors import NotFound
from sightline.infra.audit import trail
from sightline.infra.clock_watch import ClockWatch
from sightline.infra.services import Services
from sightline.infra.web import error_handlers, pages
from sightline.infra.web.access import Access
from sightline.infra.web.ballast import Ballast, RoomForDeleting
from sightline.infra.web.bearer import Bearers
from sightline.infra.web.bodies import ErrorBody
from sightline.infra.web.cookie import SignIn
from sightline.infra.web.guard import FormRoute, Guard, SignedInFirst
from sightline.infra.web.idempotency import Idempotency
from sightline.infra.web.metrics import InstallationMetrics
from sightline.infra.web.nearest import Nearest
from sightline.infra.web.openapi import DESCRIPTION, TITLE, VERSION, Api, operation_id
from sightline.infra.web.person import Person
from sightline.infra.web.secret import signing_secret
from sightline.infra.web.spoken import Spoken
from sightline.infra.web.turns import READERS, Turns
from sightline.infra.web.watching import RequestMetrics, Watching
from sightline.infra.web.write_gate import WriteGate
from sightline.people.service import Attempts, Tokens
from sightline.people.store import get_person
from sightline.recordings.ingest_job import correct_durations
from sightline.recordings.uploads.service import recover_uploads
from sightline.surveys.members import store as members
from sightline.surveys.store import demo_survey_id
from sightline.vehicles.passes.prefetch import prefetch_around_passes

log = logging.getLogger(__name__)

#: Every router of the API: its tag and its module, in the order in which the work goes.
_ROUTES = (
    ("health", "infra.web.health"),
    ("session", "people.session_routes"),
    ("tokens", "people.token_routes"),
    ("people", "people.routes"),
    ("surveys", "results.overview.routes"),
    ("surveys", "results.sampling.routes"),
    ("members", "surveys.members.routes"),
    ("photographs", "surveys.photographs.routes"),
    ("cameras", "cameras.routes"),
    ("calibrations", "cameras.calibrations.routes"),
    ("calibrations", "recordings.calibrating.routes"),
    ("boards", "cameras.printing.routes"),
    ("uploads", "recordings.uploads.routes"),
    ("recordings", "recordings.routes"),
    ("frames", "recordings.frames.routes"),
    ("planning", "cameras.planning.routes"),
    ("poses", "poses.routes"),
    ("checks", "quality.checks.routes"),
    ("adjustment", "quality.adjusting.routes"),
    ("drift", "quality.drift.routes"),
    ("assist", "measurements.assist.routes"),
    ("following", "measurements.following.routes"),
    ("geometry", "measurements.preview.routes"),
    ("vehicles", "measurements.sheets.routes"),
    ("passes", "vehicles.passes.routes"),
    ("proposals", "vehicles.proposing.routes"),
    ("passes", "measurements.sheets.passes_routes"),
    ("catalogue", "vehicles.catalogue.routes"),
    ("measurements", "measurements.routes"),
    ("computings", "scans.again.routes"),
    ("reviews", "reviews.routes"),
    ("lots", "reviews.lots.routes"),
    ("repeats", "quality.repeats.routes"),
    ("which model", "quality.which_model.routes"),
    ("scans", "scans.routes"),
    ("scans_vehicles", "scans.vehicles.routes"),
    ("rigs", "scans.rig.routes"),
    ("scans_references", "scans.references.routes"),
    ("live", "scans.live.routes"),
    ("line_heights", "scans.heights.routes"),
    ("scans_statistics", "scans.statistics.routes"),
    ("statistics", "results.routes"),
    ("sightdistance", "results.sightdistance.routes"),
    ("exports", "export.routes"),
    ("evidence", "export.evidence.routes"),
    ("studies", "studies.routes"),
    ("audit", "results.audited.routes"),
    ("audit", "infra.audit.routes"),
    ("samples", "demo.routes"),
    ("jobs", "infra.jobs.routes"),
)
ROUTERS: tuple[tuple[str, APIRouter], ...] = tuple(
    (tag, import_module(f"sightline.{place}").router) for tag, place in _ROUTES
)


@cache
def api_routes() -> tuple[BaseRoute, ...]:
    """Every router under /api; each answers errors with the one error body.

    One for the process: FastAPI makes the models of a router's requests when first asked (0.3 s for all), and
    each test of a route makes an app of its own.
    """
    api = APIRouter(generate_unique_id_function=operation_id)
    for tag, router in ROUTERS:
        api.include_router(
            router,
            prefix="/api",
            tags=[tag],
            responses={"default": {"model": ErrorBody, "description": "Error"}},
        )
    paths = (
        [f"/api{one.path}" for one in router.routes if isinstance(one, APIRoute)] for _, router in ROUTERS
    )
    return (Nearest(zip(api.routes, paths, strict=True)), *api.routes)


@cache
def form_routes() -> tuple[FormRoute, ...]:
    """Where a form may come, with a file: every other body is bounded like JSON."""
    return tuple(
        (method, compile_path(f"/api{route.path}")[0])
        for _, router in ROUTERS
        for route in router.routes
        if isinstance(route, APIRoute) and route.body_field and isinstance(route.body_field.field_info, Form)
        for method in sorted(route.methods or ())
    )


def describe() -> dict[str, Any]:
    """The OpenAPI document, without opening a database or a media store."""
    return Api(title=TITLE, version=VERSION, description=DESCRIPTION, routes=[*api_routes()]).openapi()


def create_app(services: Services) -> FastAPI:
    """The web app on an already migrated database. `services` stay open when it ends."""
    settings = services.settings
    prefetch_around_passes(services)

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        # Beside the first requests: finishing a large upload takes long, and nobody shall wait for it.
        recovering = asyncio.create_task(asyncio.to_thread(_recover, services, app.state.clock, ballast))
        yield
        await recovering

    app = Api(
        title=TITLE,
        version=VERSION,
        description=DESCRIPTION,
        routes=[*api_routes()],
        lifespan=lifespan,
        docs_url=None,
        redoc_url=None,
    )
    app.state.services = services
    app.state.clock = ClockWatch()
    app.state.write_gate = WriteGate()
    app.state.readers = Turns(READERS)
    app.state.asking = anyio.CapacityLimiter(sightline.infra.web.health.MOST_ASKING)
    secret = signing_secret(settings)
    app.state.sign_in = SignIn(secret, settings.secure_cookies, lambda id_: _person(services, id_))
    app.state.access = Access(services, members)
    app.state.attempts = Attempts(services)
    app.state.bearers = Bearers(Tokens(services, app.state.attempts))
    app.state.demo_survey_id = demo_survey_id
    error_handlers.install(app)
    ballast = Ballast(settings.data_dir)
    pages.install(app)
    app.add_middleware(SignedInFirst, forms=form_routes())
    app.add_middleware(Idempotency, services=services, secret=secret)
    app.add_middleware(Spoken)
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)
    app.add_middleware(RoomForDeleting, ballast=ballast)
    app.add_middleware(Guard, forms=form_routes())
    app.state.metrics = CollectorRegistry()
    turns = {"reading": app.state.readers, "writing": app.state.write_gate}
    app.state.metrics.register(InstallationMetrics(services, turns))
    app.add_middleware(Watching, metrics=RequestMetrics(app.state.metrics), clock=app.state.clock)
    return app


def _recover(services: Services, clock: ClockWatch, ballast: Ballast) -> None:
    try:
        if not services.read_only:
            ballast.take()
        with services.reading() as session:
            clock.begin_behind(trail.newest_moment(session))
        recover_uploads(services)
    except Exception:
        log.exception("unfinished uploads were not looked through")
    try:
        correct_durations(services)
    except Exception:
        log.exception("durations of recordings were not looked through")


def _person(services: Services, person_id: int) -> Person | None:
    with services.reading() as session:
        try:
            return get_person(session, person_id)
        except NotFound:
            return None
