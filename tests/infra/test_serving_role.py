"""The PostgreSQL role that serves and owns nothing: what it does, and what it cannot do."""

from collections.abc import Iterator

import pytest
from sqlalchemy import Engine, create_engine, make_url, text
from sqlalchemy.exc import ProgrammingError

import sightline.job_handlers  # noqa: F401, what may be queued
from sightline.cli import main
from sightline.infra.audit.guards import require_guards
from sightline.infra.audit.verification import verify_records
from sightline.infra.database.engine import make_engine, migrate, reading, session_factory, writing
from sightline.infra.jobs.registry import enqueue
from sightline.surveys.store import create_survey
from tests.conftest import SERVER

pytestmark = [pytest.mark.dialect, pytest.mark.skipif(not SERVER, reason="SQLite has no roles")]


@pytest.fixture
def serving(database_url: str, monkeypatch: pytest.MonkeyPatch) -> Iterator[Engine]:
    """An engine with the account that `sightline migrate` made."""
    role = f"serving of {make_url(database_url).query['options']}"[-60:].replace("=", " ")
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", database_url)
    monkeypatch.setenv("SIGHTLINE_SERVING_ROLE", role)
    monkeypatch.setenv("SIGHTLINE_SERVING_PASSWORD", "with ' and \"")
    owner = create_engine(SERVER, isolation_level="AUTOCOMMIT")
    name = f'"{role}"'
    try:
        assert main(["migrate"]) == 0
        assert main(["migrate"]) == 0
        address = make_url(database_url).set(username=role, password="with ' and \"")
        engine = make_engine(address.render_as_string(hide_password=False))
        yield engine
        engine.dispose()
    finally:
        with owner.connect() as connection:
            connection.execute(text(f"DROP OWNED BY {name}"))
            connection.execute(text(f"DROP ROLE {name}"))
        owner.dispose()


def test_it_serves(serving: Engine) -> None:
    migrate(serving)  # finds nothing to do
    factory = session_factory(serving)
    with writing(factory) as session:
        survey = create_survey(session, name="by a role without tables", actor=None)
    with writing(factory, survey.id) as session:
        enqueue(session, "export", {}, survey_id=survey.id, actor=None)
    with reading(factory) as session:
        assert verify_records(session).problem is None
    with serving.connect() as connection:
        require_guards(connection)


@pytest.mark.parametrize(
    "attack",
    [
        "ALTER TABLE audit_events DISABLE TRIGGER USER",
        "SET session_replication_role TO replica",
        "DROP TABLE audit_events",
        "TRUNCATE reviews",
        "DROP TRIGGER audit_events_refuse_row ON audit_events",
    ],
)
def test_it_cannot_unlock_what_is_written_once(serving: Engine, attack: str) -> None:
    with (
        serving.connect() as connection,
        pytest.raises(ProgrammingError, match=r"must be owner|permission denied"),
    ):
        connection.execute(text(attack))


def test_an_older_schema_is_told_in_one_sentence(
    serving: Engine, engine: Engine, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with engine.begin() as connection:
        before = connection.execute(text("DELETE FROM alembic_version RETURNING version_num")).scalar_one()
    try:
        monkeypatch.setenv("SIGHTLINE_DATABASE_URL", serving.url.render_as_string(hide_password=False))
        assert main(["migrate"]) == 2
        assert "run `sightline migrate` with the account that owns the tables" in capsys.readouterr().err
    finally:
        with engine.begin() as connection:
            connection.execute(text("INSERT INTO alembic_version VALUES (:one)"), {"one": before})
