"""Migrations by Alembic; imported only where the database is not at the newest revision."""

from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory
from sqlalchemy import Connection

from sightline.errors import BadInput
from sightline.infra.database.revisions import migrations_folder, stored_revision


def alembic_config() -> Config:
    """Alembic's configuration, without any ini file."""
    folder = migrations_folder()
    if not (folder / "env.py").is_file():
        raise BadInput("database-no-migrations", folder=folder)
    config = Config()
    config.set_main_option("script_location", str(folder).replace("%", "%%"))
    return config


def upgrade(connection: Connection, to: str = "head") -> None:
    """Migrate up to a revision in the connection's transaction. Raises BadInput if it is newer still.

    What the database is at is asked again here: whoever held the lock before may have migrated.
    """
    config = alembic_config()
    known = {script.revision for script in ScriptDirectory.from_config(config).walk_revisions()}
    current = stored_revision(connection)
    if {current, to} - known - {None, "head"}:
        raise BadInput("database-newer-version")
    config.attributes["connection"] = connection
    command.upgrade(config, to)
