"""What Prometheus reads on a port of its own: requests, turns, jobs, decoder, connections."""

from collections.abc import Callable, Iterable, Iterator, Mapping
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
        yield _gauge("sightline_version", "This program", "version", [(code_version(), 1)])
        waiting = [(name, one.waiting) for name, one in self._turns.items()]
        yield _gauge("sightline_requests_waiting", "Requests that wait for their turn", "turn", waiting)
        in_use = float(getattr(self._services.engine.pool, "checkedout", int)())
        yield GaugeMetricFamily(
            "sightline_database_connections", "Connections to the database in use", value=in_use
        )
        runs = float(self._services.frames.process_id is not None)
        yield GaugeMetricFamily(
            "sightline_decoder_running", "Whether the child that decodes stills runs", value=runs
        )
        try:
            with self._services.reading() as session:
                counts = count_jobs(session)
        except SightlineError:
            return
        yield _gauge("sightline_jobs", "Jobs by state", "state", counts.items())


def _gauge(name: str, what: str, label: str, values: Iterable[tuple[str, float]]) -> Metric:
    """A value for each that the label tells apart."""
    gauge = GaugeMetricFamily(name, what, labels=(label,))
    for labelled, value in values:
        gauge.add_metric((labelled,), value)
    return gauge


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
