"""Whether the server is there, whether it can work, and how it is doing."""

import os
import shutil
import socket
from collections.abc import Callable

import anyio
import anyio.to_thread
from fastapi import APIRouter, Request, Response
from pydantic import Field
from sqlalchemy import text

from sightline.children import resident_bytes
from sightline.enums import JobState
from sightline.errors import SightlineError
from sightline.infra.clock_watch import ClockSetBack
from sightline.infra.jobs.store import count_jobs
from sightline.infra.licences import Library, libraries
from sightline.infra.page_watch import PageWatch
from sightline.infra.services import Services
from sightline.infra.version import code_version
from sightline.infra.web.ballast import try_to_write
from sightline.infra.web.bodies import Out
from sightline.infra.web.deps import OPEN, Admin, Wired
from sightline.infra.web.error_handlers import FULL
from sightline.infra.web.turns import Turns
from sightline.infra.web.write_gate import WriteGate

router = APIRouter()
#: seconds that each part has to answer in
ASK_S = 2.0
#: seconds after which a change that is under way is taken for stuck
STUCK_S = 15.0
#: questions to parts that hang, at the same time: they take no thread from requests
MOST_ASKING = 12


class Health(Out):
    ok: bool
    version: str


class Readiness(Out):
    ok: bool
    database: str | None = Field(description="Why the database cannot be used; null: it can.")
    media: str | None = Field(description="Why the media store cannot be used; null: it can.")
    disk: str | None = Field(description="Why nothing can be written into the data folder; null: it can.")
    writing: str | None = Field(description="Why no change can be made just now; null: it can.")


class SystemState(Out):
    """What an administrator wants to know of a running installation: of this one of its app processes."""

    version: str
    host: str = Field(description="Name of the machine of this process.")
    process: int
    database: str = Field(description="sqlite or postgresql")
    database_connections: int = Field(description="In use just now, by this process.")
    media: str = Field(description="Where videos are kept, without any password.")
    free_bytes: int = Field(description="On the disk of the data folder.")
    readers_waiting: int
    writers_waiting: int
    decoder: int | None = Field(description="Process that decodes stills; null while none is needed.")
    memory_bytes: int | None = Field(description="Held by this process; null where it cannot be told.")
    jobs: dict[JobState, int]
    clock_set_back: ClockSetBack | None = Field(
        description="The last time that this machine's clock went back; null: it did not since the start."
    )


@router.get("/health", dependencies=[OPEN])
async def health() -> Health:
    """Answers as soon as the server is up; needs no sign-in."""
    return Health(ok=True, version=code_version())


@router.get("/ready", dependencies=[OPEN])
async def ready(services: Wired, request: Request, response: Response) -> Readiness:
    """Whether database and media store answer and the disk takes a file: 503 where one does not.

    Each has two seconds. A proxy then asks another process.
    """
    gate: WriteGate = request.app.state.write_gate
    threads: anyio.CapacityLimiter = request.app.state.asking
    held_s = gate.turns.longest_s
    readiness = Readiness(ok=True, database=None, media=None, disk=None, writing=None)
    if held_s > STUCK_S:
        readiness.writing = SightlineError("web-writer-stuck", seconds=round(held_s)).message
    async with anyio.create_task_group() as asking:
        for name, ask in (("database", database_trouble), ("media", _media), ("disk", _disk)):
            asking.start_soon(_ask_within, readiness, name, ask, services, threads)
    readiness.ok = not any((readiness.database, readiness.media, readiness.disk, readiness.writing))
    response.status_code = 200 if readiness.ok else 503
    return readiness


@router.get("/system")
def system(who: Admin, services: Wired, request: Request) -> SystemState:
    """How the installation is doing."""
    readers: Turns = request.app.state.readers
    with services.reading() as session:
        jobs = count_jobs(session)
    pool = services.engine.pool
    return SystemState(
        version=code_version(),
        host=socket.gethostname(),
        process=os.getpid(),
        database=services.engine.dialect.name,
        database_connections=int(getattr(pool, "checkedout", int)()),
        media=services.settings.media_url.partition("?")[0],
        free_bytes=shutil.disk_usage(services.settings.data_dir).free,
        readers_waiting=readers.waiting,
        writers_waiting=request.app.state.write_gate.waiting,
        decoder=services.frames.process_id,
        memory_bytes=resident_bytes(),
        jobs=jobs,
        clock_set_back=request.app.state.clock.set_back,
    )


@router.get("/system/licences")
def licences(who: Admin) -> tuple[Library, ...]:
    """The libraries that the server runs on, with the licences that they state."""
    return libraries()


async def _ask_within(
    readiness: Readiness,
    name: str,
    ask: Callable[[Services], str | None],
    services: Services,
    threads: anyio.CapacityLimiter,
) -> None:
    """What one part says goes into the answer; its silence does too."""
    said: str | None = SightlineError("web-part-silent", seconds=round(ASK_S)).message
    with anyio.move_on_after(ASK_S):
        said = await anyio.to_thread.run_sync(ask, services, abandon_on_cancel=True, limiter=threads)
    setattr(readiness, name, said)


def database_trouble(services: Services) -> str | None:
    """Why the database cannot be read, or takes no commit; None: it can. SQLite's disk is tried by itself."""
    try:
        with services.reading() as session:
            session.execute(text("SELECT 1"))
        if services.engine.dialect.name == "postgresql":
            services.sync()
        services.part(PageWatch).require_whole()
    except SightlineError as error:
        return error.message
    return None


def _media(services: Services) -> str | None:
    try:
        services.media.exists("00/00/nothing")
    except SightlineError as error:
        return error.message
    return None


def _disk(services: Services) -> str | None:
    if services.read_only:
        return None  # it was started to read what lies there
    try:
        has_room = try_to_write(services.settings.data_dir)
    except OSError as error:
        return SightlineError("web-disk-not-writable", why=error.strerror or str(error)).message
    return None if has_room else FULL.message
