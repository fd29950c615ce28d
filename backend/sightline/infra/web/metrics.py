"""What Prometheus reads on a port of its own: requests, turns, jobs, decoder, connections."""

from collections.abc import Callable, Iterator, Mapping
from typing import Protocol
from wsgiref.simple_server import WSGIServer

from prometheus_client import CollectorRegistry, start_http_server
from prometheus_client.core import GaugeMetricFamily, Metric
from prometheus_client.registry import Collector

from sightline.errors import BadInput, SightlineError
from sightline.infra.jobs.store import count_jobs
from sightline.infra.services import Services
from sightline.infra.version import code_version


class Queue(Protocol):
    """Where requests wait for their turn."""

    @property
    def waiting(self) -> int: ...


class InstallationMetrics(Collector):
    """Read when it is asked for; what cannot be read just then is left out."""

    def __init__(self, services: Services, turns: Mapping[str, Queue]) -> None:
        self._services, self._turns = services, turns

    def collect(self) -> Iterator[Metric]:
        version = GaugeMetricFamily("sightline_version", "This program", labels=("version",))
        version.add_metric((code_version(),), 1)
        yield version
        waiting = GaugeMetricFamily(
            "sightline_requests_waiting", "Requests that wait for their turn", labels=("turn",)
        )
        for name, one in self._turns.items():
            waiting.add_metric((name,), one.waiting)
        yield waiting
        pool = self._services.engine.pool
        connections = GaugeMetricFamily(
            "sightline_database_connections", "Connections to the database in use"
        )
        connections.add_metric((), float(getattr(pool, "checkedout", int)()))
        yield connections
        decoder = GaugeMetricFamily("sightline_decoder_running", "Whether the child that decodes stills runs")
        decoder.add_metric((), float(self._services.frames.process_id is not None))
        yield decoder
        yield from self._jobs()

    def _jobs(self) -> Iterator[Metric]:
        try:
            with self._services.reading() as session:
                counts = count_jobs(session)
        except SightlineError:
            return
        jobs = GaugeMetricFamily("sightline_jobs", "Jobs by state", labels=("state",))
        for state, count in counts.items():
            jobs.add_metric((state,), count)
        yield jobs


def serve_metrics(host: str, port: int, registry: CollectorRegistry) -> Callable[[], None]:
    """Answer Prometheus on a port of its own; what ends it. Raises BadInput where the port is taken."""
    try:
        server, thread = start_http_server(port, host, registry)
    except OSError as error:
        why = (error.strerror or str(error)).lower()
        raise BadInput("commands-metrics-port-taken", port=port, host=host, why=why) from error

    def stop() -> None:
        _end(server)
        thread.join(5)

    return stop


def _end(server: WSGIServer) -> None:
    server.shutdown()
    server.server_close()
