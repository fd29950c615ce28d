"""create_app(): routers, one error handler, the guard, and the built front end."""

import asyncio
import logging
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import cache
from typing import Any

import anyio
from fastapi import APIRouter, FastAPI
from fastapi.routing import APIRoute
from prometheus_client import CollectorRegistry
from starlette.middleware.gzip import GZipMiddleware
from starlette.routing import BaseRoute

import sightline.cameras.calibrations.routes
import sightline.cameras.planning.routes
import sightline.cameras.printing.routes
import sightline.cameras.routes
import sightline.demo.routes
import sightline.export.evidence.routes
import sightline.export.routes
import sightline.infra.audit.routes
import sightline.infra.jobs.routes
import sightline.infra.web.health
import sightline.job_handlers
import sightline.measurements.assist.routes
import sightline.measurements.following.routes
import sightline.measurements.preview.routes
import sightline.measurements.routes
import sightline.measurements.sheets.passes_routes
import sightline.measurements.sheets.routes
import sightline.people.routes
import sightline.people.session_routes
import sightline.people.token_routes
import sightline.poses.routes
import sightline.quality.adjusting.routes
import sightline.quality.checks.routes
import sightline.quality.drift.routes
import sightline.quality.repeats.routes
import sightline.quality.which_model.routes
import sightline.recordings.calibrating.routes
import sightline.recordings.frames.routes
import sightline.recordings.routes
import sightline.recordings.uploads.routes
import sightline.results.audited.routes
import sightline.results.overview.routes
import sightline.results.routes
import sightline.results.sampling.routes
import sightline.results.sightdistance.routes
import sightline.reviews.lots.routes
import sightline.reviews.routes
import sightline.scans.again.routes
import sightline.scans.heights.routes
import sightline.scans.live.routes
import sightline.scans.references.routes
import sightline.scans.rig.routes
import sightline.scans.routes
import sightline.scans.statistics.routes
import sightline.scans.vehicles.routes
import sightline.studies.routes
import sightline.surveys.members.routes
import sightline.surveys.photographs.routes
import sightline.vehicles.catalogue.routes
import sightline.vehicles.passes.routes
import sightline.vehicles.proposing.routes
from sightline.errors import NotFound
from sightline.infra.audit import trail
from sightline.infra.clock_watch import ClockWatch
from sightline.infra.services import Services, open_services
from sightline.infra.web import error_handlers, pages
from sightline.infra.web.access import Access
from sightline.infra.web.ballast import Ballast, RoomForDeleting
from sightline.infra.web.bearer import Bearers
from sightline.infra.web.bodies import ErrorBody
from sightline.infra.web.cookie import SignIn
from sightline.infra.web.guard import Guard
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
from sightline.settings import Settings
from sightline.surveys.members import store as members
from sightline.surveys.store import demo_survey_id
from sightline.vehicles.passes.prefetch import prefetch_around_passes

log = logging.getLogger(__name__)

#: Every router of the API with its tag, in the order in which the work goes.
ROUTERS: tuple[tuple[str, APIRouter], ...] = (
    ("health", sightline.infra.web.health.router),
    ("session", sightline.people.session_routes.router),
    ("tokens", sightline.people.token_routes.router),
    ("people", sightline.people.routes.router),
    ("surveys", sightline.results.overview.routes.router),
    ("surveys", sightline.results.sampling.routes.router),
    ("members", sightline.surveys.members.routes.router),
    ("photographs", sightline.surveys.photographs.routes.router),
    ("cameras", sightline.cameras.routes.router),
    ("calibrations", sightline.cameras.calibrations.routes.router),
    ("calibrations", sightline.recordings.calibrating.routes.router),
    ("boards", sightline.cameras.printing.routes.router),
    ("uploads", sightline.recordings.uploads.routes.router),
    ("recordings", sightline.recordings.routes.router),
    ("frames", sightline.recordings.frames.routes.router),
    ("planning", sightline.cameras.planning.routes.router),
    ("poses", sightline.poses.routes.router),
    ("checks", sightline.quality.checks.routes.router),
    ("adjustment", sightline.quality.adjusting.routes.router),
    ("drift", sightline.quality.drift.routes.router),
    ("assist", sightline.measurements.assist.routes.router),
    ("following", sightline.measurements.following.routes.router),
    ("geometry", sightline.measurements.preview.routes.router),
    ("vehicles", sightline.measurements.sheets.routes.router),
    ("passes", sightline.vehicles.passes.routes.router),
    ("proposals", sightline.vehicles.proposing.routes.router),
    ("passes", sightline.measurements.sheets.passes_routes.router),
    ("catalogue", sightline.vehicles.catalogue.routes.router),
    ("measurements", sightline.measurements.routes.router),
    ("computings", sightline.scans.again.routes.router),
    ("reviews", sightline.reviews.routes.router),
    ("lots", sightline.reviews.lots.routes.router),
    ("repeats", sightline.quality.repeats.routes.router),
    ("which model", sightline.quality.which_model.routes.router),
    ("scans", sightline.scans.routes.router),
    ("scans_vehicles", sightline.scans.vehicles.routes.router),
    ("rigs", sightline.scans.rig.routes.router),
    ("scans_references", sightline.scans.references.routes.router),
    ("live", sightline.scans.live.routes.router),
    ("line_heights", sightline.scans.heights.routes.router),
    ("scans_statistics", sightline.scans.statistics.routes.router),
    ("statistics", sightline.results.routes.router),
    ("sightdistance", sightline.results.sightdistance.routes.router),
    ("exports", sightline.export.routes.router),
    ("evidence", sightline.export.evidence.routes.router),
    ("studies", sightline.studies.routes.router),
    ("audit", sightline.results.audited.routes.router),
    ("audit", sightline.infra.audit.routes.router),
    ("samples", sightline.demo.routes.router),
    ("jobs", sightline.infra.jobs.routes.router),
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


def describe() -> dict[str, Any]:
    """The OpenAPI document, without opening a database or a media store."""
    return Api(title=TITLE, version=VERSION, description=DESCRIPTION, routes=[*api_routes()]).openapi()


def create_app(settings: Settings | None = None, services: Services | None = None) -> FastAPI:
    """The web app on an already migrated database. With `services` given, they stay open when it ends."""
    settings = settings or (services.settings if services else Settings())
    own = services is None
    services = services or open_services(settings, serving=True)
    prefetch_around_passes(services)

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        # Beside the first requests: finishing a large upload takes long, and nobody shall wait for it.
        recovering = asyncio.create_task(asyncio.to_thread(_recover, services, app.state.clock, ballast))
        yield
        await recovering
        if own:
            services.close()

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
    pages.install(app, settings)
    app.add_middleware(Idempotency, services=services, secret=secret)
    app.add_middleware(Spoken)
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)
    app.add_middleware(RoomForDeleting, ballast=ballast)
    app.add_middleware(Guard)
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
