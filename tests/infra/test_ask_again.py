"""Who is refused because something is busy or away is told when to ask again."""

import sqlite3

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from sqlalchemy.exc import OperationalError

from sightline.errors import Busy
from sightline.infra.database.engine import DatabaseAway
from sightline.infra.web import error_handlers


@pytest.mark.parametrize(
    "error",
    [
        OperationalError("BEGIN IMMEDIATE", None, sqlite3.OperationalError("database is locked")),
        DatabaseAway("database-busy"),
        Busy("web-server-busy"),
    ],
    ids=lambda error: type(error).__name__,
)
def test_a_held_lock_says_when_to_ask_again(error: Exception) -> None:
    app = FastAPI()
    error_handlers.install(app)

    @app.get("/")
    def fails() -> None:
        raise error

    answer = TestClient(app).get("/")
    assert answer.status_code == 503
    assert answer.headers["Retry-After"] == "2"
    assert answer.json()["error"]["message"].endswith(".")
