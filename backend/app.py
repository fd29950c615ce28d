"""create_app(): routers, one error handler, the guard, and the built front end."""

import asyncio
import logging
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from fastapi import FastAPI
from starlette.middleware.gzip import GZipMiddleware

from backend.api import failures, pages
from backend.api.gate import WriteGate
from backend.api.guard import Guard
from backend.api.openapi import DESCRIPTION, TITLE, VERSION, operation_id
from backend.api.routes import include_routes
from backend.api.sign_in import SignIn
from backend.errors import NotFound
from backend.settings import Settings
from backend.storage import people
from backend.storage.records import Person
from backend.work import uploading
from backend.work.people import Attempts
from backend.work.secret import signing_secret
from backend.work.services import Services, open_services

log = logging.getLogger(__name__)


def create_app(settings: Settings | None = None, services: Services | None = None) -> FastAPI:
    """The web app on an already migrated database. With `services` given, they stay open when it ends."""
    settings = settings or (services.settings if services else Settings())
    own = services is None
    services = services or open_services(settings)

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        # Beside the first requests: finishing a large upload takes long, and nobody shall wait for it.
        recovering = asyncio.create_task(asyncio.to_thread(_recover, services))
        yield
        await recovering
        if own:
            services.close()

    app = FastAPI(
        title=TITLE,
        version=VERSION,
        description=DESCRIPTION,
        generate_unique_id_function=operation_id,
        lifespan=lifespan,
        docs_url=None,
        redoc_url=None,
    )
    app.state.services = services
    app.state.write_gate = WriteGate()
    app.state.sign_in = SignIn(
        signing_secret(settings), settings.secure_cookies, lambda id_: _person(services, id_)
    )
    app.state.attempts = Attempts()
    failures.install(app)
    include_routes(app)
    pages.install(app, settings)
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)
    app.add_middleware(Guard)
    return app


def _recover(services: Services) -> None:
    try:
        uploading.recover(services)
    except Exception:
        log.exception("unfinished uploads were not looked through")


def _person(services: Services, person_id: int) -> Person | None:
    with services.reading() as session:
        try:
            return people.get(session, person_id)
        except NotFound:
            return None
