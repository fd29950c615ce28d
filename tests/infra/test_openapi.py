"""The description of the API: complete, typed, and kept to under random requests (schemathesis)."""

import json
import os
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from copy import deepcopy
from itertools import islice
from pathlib import Path
from typing import Any

import pytest
from fastapi import FastAPI
from hypothesis import HealthCheck, given, seed, settings
from hypothesis.errors import Unsatisfiable

from sightline.app import describe
from sightline.commands.openapi import main
from sightline.infra.web.openapi import Api
from tests.support.app import Client


@pytest.fixture(scope="module")
def description() -> dict[str, Any]:
    """Made once: it takes seconds."""
    return describe()


def operations(document: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    return [
        (f"{method} {path}", operation)
        for path, methods in document["paths"].items()
        for method, operation in methods.items()
    ]


@pytest.mark.once
def test_every_operation_is_named_once_described_and_typed(description: dict[str, Any]) -> None:
    names = Counter(operation["operationId"] for _, operation in operations(description))
    assert [name for name, count in names.items() if count > 1] == []
    for place, operation in operations(description):
        assert operation.get("description"), place
        good = {code: answer for code, answer in operation["responses"].items() if code.startswith("2")}
        assert good, place
        for answer in good.values():
            schema = answer.get("content", {}).get("application/json", {}).get("schema")
            assert schema != {}, place
        assert set(operation["responses"]) - set(good) - {"304"} == {"default"}, place
        assert operation["responses"]["default"]["content"]["application/json"]["schema"] == {
            "$ref": "#/components/schemas/ErrorBody"
        }, place


@pytest.mark.once
def test_the_description_is_the_app_s(
    app: FastAPI,
    tmp_path: Path,
    description: dict[str, Any],
    monkeypatch: pytest.MonkeyPatch,
    described_once: Callable[[Api], dict[str, Any]],
) -> None:
    monkeypatch.setattr(Api, "openapi", described_once)
    monkeypatch.setattr("sightline.commands.openapi.describe", lambda: description)
    target = tmp_path / "build" / "openapi.json"
    assert main([str(target)]) == 0
    assert json.loads(target.read_text()) == app.openapi() == description
    assert main([]) == 2


# Signing in and out would end the test's own session; all others may do what they like to the test's store.
SKIPPED = "/api/session"
# What the server answers on purpose; 500, 503 and 507 say that something is wrong with the server itself.
ERRORS = (400, 401, 403, 404, 405, 409, 412, 413, 415, 422, 429)
# `make hostile` asks for many more of each operation, by a seed of its own.
ASKED, SEED = os.environ.get("SIGHTLINE_REQUESTS_EACH"), int(os.environ.get("SIGHTLINE_REQUESTS_SEED", "1"))
# One request of every sixth operation; one, and three, of each.
ASKED_EACH = (
    [(int(ASKED), 1)]
    if ASKED
    else [(1, 6), *(pytest.param(each, 1, marks=pytest.mark.proof) for each in (1, 3))]
)
QUIET = settings(deadline=None, database=None, suppress_health_check=list(HealthCheck))


@pytest.mark.once  # what is sent and answered does not depend on the database
@pytest.mark.parametrize(("each", "every"), ASKED_EACH)
@pytest.mark.parametrize("mode", ["positive", "negative"])
def test_no_request_breaks_the_server(
    admin: Client, recording_id: int, mode: str, each: int, every: int, description: dict[str, Any]
) -> None:
    """Requests by the description, and against it: never a 500, always what it promises."""
    import requests
    import schemathesis
    from schemathesis.specs.openapi.checks import response_schema_conformance, status_code_conformance

    tried = Counter[str]()

    def ask(case: Any) -> None:
        asked = requests.Request(**case.as_transport_kwargs(base_url="http://testserver")).prepare()
        asked.headers.update({"X-Sightline": "1", "Tus-Resumable": "1.0.0"})
        response = admin.http.request(
            str(asked.method), str(asked.url), content=asked.body, headers=dict(asked.headers)
        )
        tried[case.operation.label] += 1
        assert response.status_code < 400 or response.status_code in ERRORS, (
            case.as_curl_command(),
            response.text,
        )
        if mode == "positive" or response.status_code >= 400:
            case.validate_response(response, checks=(status_code_conformance, response_schema_conformance))

    described = schemathesis.openapi.from_dict(deepcopy(description))
    for found in islice(described.get_all_operations(), None, None, every):
        operation = found.ok()
        if operation.path.startswith(SKIPPED):
            continue
        cases = operation.as_strategy(generation_mode=schemathesis.GenerationMode(mode))
        # An operation without any input has no request against its description.
        with suppress(Unsatisfiable):
            seed(SEED)(settings(QUIET, max_examples=each)(given(case=cases)(ask)))()
    assert len(tried) > 55 / every
    print(f"{mode} requests answered: {tried.total()}")
