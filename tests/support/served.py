"""The app behind a real socket, in a thread of the test's own process."""

import socket
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Thread

import uvicorn

from sightline.app import create_app
from sightline.infra.services import Services
from tests.support.waiting import until


@contextmanager
def served(services: Services) -> Iterator[int]:
    """The port at which it answers. Nothing runs beside the routes: no jobs."""
    app = create_app(services=services)
    server = uvicorn.Server(uvicorn.Config(app, log_level="critical", lifespan="off"))
    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        until(lambda: server.started)
        try:
            yield int(listening.getsockname()[1])
        finally:
            server.should_exit = True
            thread.join()
