"""Around every request: its number, how long it took, a line in the log, and what Prometheus counts."""

import logging
import re
import time
from uuid import uuid4

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram
from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sightline.infra.clock_watch import ClockWatch
from sightline.infra.log import REQUEST

log = logging.getLogger("sightline.requests")

HEADER = "X-Request-Id"
_API = "/api/"
_GIVEN = re.compile(r"[\w.-]{1,64}", re.ASCII)
_SECONDS = (0.005, 0.01, 0.025, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)


class RequestMetrics:
    """Requests by method, route and status; how long they took; how many are under way."""

    def __init__(self, registry: CollectorRegistry) -> None:
        labels = ("method", "route")
        self.answered = Counter(
            "sightline_requests", "Requests answered", (*labels, "status"), registry=registry
        )
        self.seconds = Histogram(
            "sightline_request_seconds",
            "Seconds until the answer had gone",
            labels,
            buckets=_SECONDS,
            registry=registry,
        )
        self.under_way = Gauge(
            "sightline_requests_under_way", "Requests that are being answered", registry=registry
        )


class Watching:
    """The outermost of all: what guards and handlers refuse is counted too."""

    def __init__(self, app: ASGIApp, metrics: RequestMetrics, clock: ClockWatch) -> None:
        self.app, self.metrics, self.clock = app, metrics, clock

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        self.clock.look()
        number = number_of(Headers(scope=scope).get(HEADER))
        status = 500

        async def send_with_number(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                MutableHeaders(scope=message)[HEADER] = number
            await send(message)

        token, started = REQUEST.set(number), time.perf_counter()
        try:
            with self.metrics.under_way.track_inprogress():
                await self.app(scope, receive, send_with_number)
        finally:
            self._note(scope, status, time.perf_counter() - started)
            REQUEST.reset(token)

    def _note(self, scope: Scope, status: int, took_s: float) -> None:
        method, route = known_method(scope["method"]), route_of(scope)
        self.metrics.answered.labels(method, route, str(status)).inc()
        self.metrics.seconds.labels(method, route).observe(took_s)
        fields = {"method": method, "path": scope["path"], "status": status, "took_s": round(took_s, 4)}
        log.info("%s %s %d", method, scope["path"], status, extra={"fields": fields})


def number_of(given: str | None) -> str:
    """The number that a proxy gave the request, or a new one."""
    return given if given is not None and _GIVEN.fullmatch(given) else uuid4().hex[:16]


def known_method(method: str) -> str:
    """So that nobody fills the counters with methods of their own."""
    return method if method in ("GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS") else "other"


def route_of(scope: Scope) -> str:
    """The route's pattern, never its numbers: one counter for all vehicles. Pages and files are one."""
    path = getattr(scope.get("route"), "path", None)
    if path is None or not scope["path"].startswith(_API):
        return "pages"
    return str(path) if path.startswith(_API) else f"/api{path}"
