"""Requests are numbered, counted and logged; being able to work is another thing than being there."""

import json
import logging
import os
import socket
import sys
import threading
import urllib.request
from typing import Any

import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st
from prometheus_client import CollectorRegistry, generate_latest

from sightline.errors import BadInput
from sightline.infra.log import REQUEST, JsonLines
from sightline.infra.services import Services
from sightline.infra.web import health, metrics
from sightline.infra.web.metrics import serve_metrics
from sightline.infra.web.turns import Turns
from sightline.infra.web.watching import number_of
from sightline.media.store.s3 import StorageAway
from tests.support.app import Client
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.once


def figures(app: FastAPI) -> dict[str, float]:
    lines = generate_latest(app.state.metrics).decode().splitlines()
    return {
        name: float(value)
        for name, _, value in (line.rpartition(" ") for line in lines if not line.startswith("#"))
    }


def test_requests_are_counted_by_their_route(app: FastAPI, viewer: Client, survey_id: int) -> None:
    for _ in range(3):
        viewer.seen(f"/surveys/{survey_id}")
    viewer.get("/surveys/999")
    viewer.http.get("/api/no/such/thing")
    viewer.http.request("BREW", "/api/surveys")
    found = figures(app)
    one = 'sightline_requests_total{method="GET",route="/api/surveys/{survey_id}",status="%s"}'
    assert (found[one % 200], found[one % 404]) == (3, 1)
    assert not any("999" in name or "BREW" in name or "no/such" in name for name in found)
    assert found["sightline_requests_under_way"] == 0
    assert (
        found['sightline_jobs{state="queued"}'] >= 0
        and found['sightline_requests_waiting{turn="writing"}'] == 0
    )
    seconds = 'sightline_request_seconds_count{method="GET",route="/api/surveys/{survey_id}"}'
    assert found[seconds] == 4


def test_a_request_has_a_number_in_answer_and_log(viewer: Client, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, logger="sightline.requests"):
        answer = viewer.http.get("/api/surveys", headers={"X-Request-Id": "proxy-7"})
    assert answer.headers["x-request-id"] == "proxy-7"
    told: Any = caplog.records[-1]
    assert told.fields["path"] == "/api/surveys" and told.fields["status"] == 200
    assert len(viewer.http.get("/api/surveys").headers["x-request-id"]) == 16


@given(st.text(max_size=80))
def test_no_number_breaks_a_line(given: str) -> None:
    number = number_of(given)
    assert 1 <= len(number) <= 64 and all(
        sign.isascii() and (sign.isalnum() or sign in "_.-") for sign in number
    )


def test_a_line_is_one_object() -> None:
    token = REQUEST.set("abc")
    try:
        raise ValueError("two\nlines")
    except ValueError:
        record = logging.LogRecord("x", logging.ERROR, "f", 1, "it broke: %s", ("here",), sys.exc_info())
        line = JsonLines().format(record)
    finally:
        REQUEST.reset(token)
    told = json.loads(line)
    assert "\n" not in line and told["message"] == "it broke: here" and told["request"] == "abc"
    assert told["level"] == "error" and "two\nlines" in told["traceback"]


def test_alive_is_not_ready(viewer: Client, services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = {"ok": True, "database": None, "media": None, "disk": None, "writing": None}
    assert viewer.http.get("/api/ready").json() == whole

    def away(_key: str) -> bool:
        raise StorageAway("store-no-answer", key="k", name="Timeout")

    monkeypatch.setattr(services.media, "exists", away)
    answer = viewer.http.get("/api/ready")
    assert answer.status_code == 503 and "did not answer" in answer.json()["media"]
    assert viewer.http.get("/api/health").status_code == 200


def test_a_part_that_is_silent_is_told_within_its_seconds(
    viewer: Client, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = threading.Event()
    monkeypatch.setattr(health, "ASK_S", 0.2)
    monkeypatch.setattr(services.media, "exists", lambda _key: ended.wait(NEVER_S))
    told = viewer.http.get("/api/ready")
    ended.set()
    assert told.status_code == 503 and "No answer" in told.json()["media"]
    assert told.json()["database"] is None


def test_a_change_that_hangs_is_told(viewer: Client, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Turns, "longest_s", 16.4)
    told = viewer.http.get("/api/ready")
    assert told.status_code == 503 and "running for 16 s" in told.json()["writing"]


def test_administrators_see_the_state_of_the_system(admin: Client, viewer: Client) -> None:
    state = admin.seen("/system")
    assert state["free_bytes"] > 0 and state["jobs"]["queued"] >= 0 and state["version"]
    assert (state["host"], state["process"]) == (socket.gethostname(), os.getpid())
    assert viewer.get("/system").status_code == 403


def test_prometheus_reads_on_a_port_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    registry, begun, begin = CollectorRegistry(), list[Any](), metrics.start_http_server

    def noted(*given: Any) -> Any:
        begun.append(begin(*given))
        return begun[-1]

    monkeypatch.setattr(metrics, "start_http_server", noted)
    stop = serve_metrics("127.0.0.1", 0, registry)
    port = begun[0][0].server_port
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/metrics", timeout=NEVER_S) as answer:
            assert answer.status == 200
        with pytest.raises(BadInput, match="SIGHTLINE_METRICS_PORT"):
            serve_metrics("127.0.0.1", port, registry)
    finally:
        stop()
