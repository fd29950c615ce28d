"""`sightline serve`: the server, with its own workers beside it."""

from __future__ import annotations

import asyncio
import gc
import logging
import signal
import socket
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import IO, TYPE_CHECKING

import click

from sightline.children import kept_for_good
from sightline.commands.options import data_dir_option, settings_of
from sightline.errors import BadInput

if TYPE_CHECKING:
    import uvicorn
    from fastapi import FastAPI

    from sightline.infra.services import Services
    from sightline.settings import Settings

AFTER_START_S = 0.2


@click.command()
@click.option("--host", help="Address to listen on (SIGHTLINE_HOST; default 127.0.0.1).")
@click.option("--port", type=click.IntRange(0, 65535), help="Port (SIGHTLINE_PORT; default 8000).")
@click.option(
    "--workers",
    type=click.IntRange(0, 64),
    help="Number of worker processes (0: separate workers do the jobs).",
)
@click.option(
    "--demo", "with_demo", is_flag=True, help="Also create the demonstration survey, if it does not exist."
)
@data_dir_option
def serve(
    host: str | None, port: int | None, workers: int | None, with_demo: bool, data_dir: Path | None
) -> None:
    """Migrate the database and start the server; prints its address and, the first time, a sign-in link."""
    run(host, port, workers, with_demo, data_dir)


def run(
    host: str | None, port: int | None, workers: int | None, with_demo: bool, data_dir: Path | None
) -> None:
    """Serve until stopped (SIGINT, SIGTERM). Raises BadInput when the port is taken."""
    from sightline.infra.private import keep_private

    settings = settings_of(data_dir=data_dir, host=host, port=port, workers=workers or None)
    keep_private(settings)
    with ExitStack() as stack:
        listener = stack.enter_context(listen(settings.host, settings.port))
        serve_on(listener, settings, stack, own_worker=workers != 0, with_demo=with_demo)


def listen(host: str, port: int) -> socket.socket:
    """The socket, taken before anything else happens: two servers on one port are noticed at once."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # Named as TCP: only then does asyncio switch Nagle's delay off, which costs 40 ms an answer.
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((host, port))
        # Listening already: whoever connects while we start waits a moment instead of being refused.
        listener.listen(2048)
    except OSError as error:
        listener.close()
        raise BadInput(
            "commands-port-taken", port=port, host=host, why=words_of_system_error(error)
        ) from error
    return listener


def words_of_system_error(error: OSError) -> str:
    """What the system says, as part of a sentence."""
    return (error.strerror or str(error)).lower()


def serve_on(
    listener: socket.socket, settings: Settings, stack: ExitStack, *, own_worker: bool, with_demo: bool
) -> None:
    """Open everything and answer until stopped; the workers start once the server answers."""
    with kept_for_good():
        from sightline.app import create_app
        from sightline.infra.audit.guards import require_guards
        from sightline.infra.database.engine import make_engine, migrate, translate_database_errors
        from sightline.infra.installation import require_alike
        from sightline.infra.jobs.workers import start_child_workers
        from sightline.infra.log import begin_log
        from sightline.infra.page_watch import PageWatch
        from sightline.infra.services import open_services
        from sightline.infra.web.metrics import serve_metrics
        from sightline.infra.web.secret import require_secrets
        from sightline.people.service import first_sign_in_link

    require_secrets(settings)
    settings.data_dir.mkdir(parents=True, exist_ok=True)
    engine = make_engine(settings.database_url)
    if engine.dialect.name == "sqlite":
        stack.enter_context(only_server(settings.data_dir))
    migrate(engine)
    with translate_database_errors(), engine.connect() as connection:
        require_guards(connection)
    engine.dispose()
    services = open_services(settings, serving=True)
    stack.callback(services.close)
    require_alike(services.engine, settings, app=True)
    services.part(PageWatch).require_whole()
    link = first_sign_in_link(services)
    if with_demo:
        request_demonstration(services)
    with kept_for_good():
        app = create_app(services=services)
    begin_log(settings.log_format, logging.INFO if settings.log_format == "json" else logging.WARNING)
    if settings.metrics_port:
        stack.callback(serve_metrics(settings.host, settings.metrics_port, app.state.metrics))

    def answering() -> None:
        # Later: the workers' own start must not take the processor from the server's.
        services.frames.start()
        child = start_child_workers(settings) if own_worker else None
        if child is not None:
            stack.callback(child.stop)

    gc.freeze()
    answer(listener, web_config(app, settings), link, answering, settings.address)


def only_server(folder: Path) -> IO[bytes]:
    """Held while this process lives: on SQLite one server does the writing. Raises BadInput for a second."""
    from sightline.infra.file_lock import take_lock

    try:
        held = take_lock(folder / "server.lock")
    except OSError as error:
        raise BadInput(
            "commands-folder-cannot-written", folder=str(folder), why=words_of_system_error(error)
        ) from error
    if held is None:
        raise BadInput("commands-folder-taken", folder=str(folder))
    return held


def request_demonstration(services: Services) -> None:
    """Queue the demonstration study and survey unless they are there."""
    from sightline.demo.request import request_both

    with services.writing() as session:
        job = request_both(session)
    if job is not None:
        click.echo(
            "The demonstration is being created: a simulated study of four sites and a survey. Both appear "
            "on the home page."
        )


def web_config(app: FastAPI, settings: Settings) -> uvicorn.Config:
    """How uvicorn answers; who says that it is a proxy is believed only where the settings name it."""
    import uvicorn

    return uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        proxy_headers=bool(settings.proxies),
        forwarded_allow_ips=settings.proxies,
        server_header=False,
        timeout_graceful_shutdown=3,
        # longer than browsers and proxies (Caddy: 120 s) keep a connection that rests: who closes it first
        # may cut off a request that is just being sent
        timeout_keep_alive=150,
    )


def answer(
    listener: socket.socket,
    config: uvicorn.Config,
    link: str | None,
    answering: Callable[[], None] | None = None,
    site: str = "",
) -> None:
    """Say where we are and run the web server until it is told to stop.

    `site` is the address that people know it by, where it is another than the one it listens on;
    `answering` is called a moment after requests are taken: whoever waited for the start comes first.
    """
    import uvicorn

    class Server(uvicorn.Server):
        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            if answering is not None:
                asyncio.get_running_loop().call_later(AFTER_START_S, answering)

    host, port = listener.getsockname()[:2]
    shown = "localhost" if host in ("127.0.0.1", "::1", "0.0.0.0", "::") else host
    address = f"http://{shown}:{port}"
    click.echo(f"Sightline is at {address} (stop with Ctrl+C).")
    if link is not None:
        click.echo(f"First sign-in (one-time link): {site.rstrip('/') or address}{link}")
    # uvicorn raises the signal that ended it once more: taken as Ctrl+C, so that what we opened is closed.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with suppress(KeyboardInterrupt):
        Server(config).run(sockets=[listener])
