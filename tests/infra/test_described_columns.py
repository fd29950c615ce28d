"""PostgreSQL: what the columns of a result are is told when somebody looks, and not after every statement."""

import psycopg
import pytest
from sqlalchemy import text

from sightline.infra.services import Services

pytestmark = pytest.mark.dialect


def test_columns_are_described_when_somebody_looks(
    services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    if services.engine.dialect.name == "sqlite":
        pytest.skip("of PostgreSQL's driver")
    described: list[int] = []
    column = psycopg.Column

    def counted(cursor: object, at: int) -> psycopg.Column:
        described.append(at)
        return column(cursor, at)  # type: ignore[arg-type]

    monkeypatch.setattr("psycopg._cursor_base.Column", counted)
    with services.reading() as session:
        driver = session.connection().connection.driver_connection
        assert isinstance(driver, psycopg.Connection)
        with driver.cursor() as cursor:
            described.clear()
            cursor.execute("SELECT 1 AS one, 'b' AS two")
            assert not described
            assert [(one.name, one.type_display) for one in cursor.description or ()] == [
                ("one", "int4"),
                ("two", "text"),
            ]
            assert described == [0, 1]
            cursor.execute("CREATE TEMPORARY TABLE nothing (id integer)")
            assert cursor.description is None
            cursor.execute("SELECT FROM pg_roles")
            assert cursor.description is not None and list(cursor.description) == []
        row = session.execute(text("SELECT 1 AS one, 'b' AS two")).one()
        assert (row.one, row.two) == (1, "b")
