"""The migrations make exactly the tables that the code knows, on an empty database, with one head."""

import subprocess
import sys
from typing import Any

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory
from sqlalchemy import CheckConstraint, Engine, inspect, text

import sightline.app
from sightline.errors import BadInput
from sightline.infra.database.engine import migrate
from sightline.infra.database.migrations import alembic_config
from sightline.infra.database.revisions import newest_revision
from sightline.infra.database.types import metadata

pytestmark = pytest.mark.dialect

assert sightline.app  # importing it brings in the tables of every slice


def ours(_object: Any, name: str | None, kind: str, reflected: bool, _compared: Any) -> bool:
    return not (kind == "table" and reflected and str(name).startswith("procrastinate_"))


def test_the_tables_are_those_of_the_code(engine: Engine) -> None:
    with engine.connect() as connection:
        options = {"compare_type": True, "include_object": ours}
        context = MigrationContext.configure(connection, opts=options)
        assert compare_metadata(context, metadata) == []


def test_the_checks_are_those_of_the_code(engine: Engine) -> None:
    found = inspect(engine)
    for table in metadata.sorted_tables:
        declared = {str(c.name) for c in table.constraints if isinstance(c, CheckConstraint)}
        assert {c["name"] for c in found.get_check_constraints(table.name)} == declared, table.name


def test_no_number_is_given_out_again_where_rows_go_and_their_numbers_stay(engine: Engine) -> None:
    if engine.dialect.name == "sqlite":  # PostgreSQL never does
        with engine.connect() as connection:
            made = text("SELECT name FROM sqlite_master WHERE sql LIKE '%AUTOINCREMENT%'")
            counted = set(connection.execute(made).scalars())
        assert counted == {"uploads", "calibration_images"}
        assert counted == {
            one.name for one in metadata.sorted_tables if one.kwargs.get("sqlite_autoincrement")
        }


def test_every_constraint_is_named(engine: Engine) -> None:
    found = inspect(engine)
    for table in metadata.sorted_tables:
        keys = found.get_foreign_keys(table.name)
        named = [*keys, *found.get_unique_constraints(table.name), *found.get_check_constraints(table.name)]
        assert all(one["name"] or _named_at_column(engine, table.name, one) for one in named), table.name
        # SQLAlchemy writes AUTOINCREMENT at the column, without the key's name
        nameless = engine.dialect.name == "sqlite" and table.kwargs.get("sqlite_autoincrement")
        assert found.get_pk_constraint(table.name)["name"] == (None if nameless else f"pk_{table.name}")
        assert len(keys) == len(table.foreign_key_constraints), table.name


def _named_at_column(engine: Engine, table: str, key: Any) -> bool:
    """SQLite's inspector does not see the name of a key that came with its column; its text has it."""
    if engine.dialect.name != "sqlite":
        return False
    with engine.connect() as connection:
        made = connection.execute(text("SELECT sql FROM sqlite_master WHERE name = :table"), {"table": table})
        (column,) = key["constrained_columns"]
        return f"CONSTRAINT fk_{table}_{column} REFERENCES {key['referred_table']}" in made.scalar_one()


@pytest.mark.once
def test_there_is_one_head_and_names_say_what_is_done() -> None:
    scripts = ScriptDirectory.from_config(alembic_config())
    assert len(scripts.get_heads()) == 1
    assert all(script.doc and len(script.revision) > 8 for script in scripts.walk_revisions())
    # What a start reads off the files must be what Alembic says.
    assert scripts.get_heads() == [newest_revision()]


def test_nothing_to_migrate_needs_no_alembic(engine: Engine) -> None:
    """Its import would be half of a start."""
    url = engine.url.render_as_string(hide_password=False)
    program = (
        "import sys; from sightline.infra.database import engine as d; "
        f"d.migrate(d.make_engine({url!r})); sys.exit('alembic' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_migrating_again_changes_nothing(engine: Engine) -> None:
    migrate(engine)
    with engine.connect() as connection:
        assert connection.execute(text("SELECT count(*) FROM alembic_version")).scalar_one() == 1


def test_a_newer_database_is_left_alone(engine: Engine) -> None:
    with engine.begin() as connection:
        then = connection.execute(text("SELECT version_num FROM alembic_version")).scalar_one()
        connection.execute(text("UPDATE alembic_version SET version_num = '9999_future'"))
    try:
        with pytest.raises(BadInput, match="newer version"):
            migrate(engine)
    finally:
        with engine.begin() as connection:
            connection.execute(text("UPDATE alembic_version SET version_num = :then"), {"then": then})


def test_missing_migrations_are_named(engine: Engine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SIGHTLINE_MIGRATIONS", "/nowhere")
    with pytest.raises(BadInput, match="SIGHTLINE_MIGRATIONS"):
        migrate(engine)
