"""Alembic's entry: runs on the connection that `migrate` hands over, in its transaction."""

from typing import Any

from alembic import context

from sightline.infra.database.types import metadata


def ours(_object: Any, name: str | None, kind: str, reflected: bool, _compared: Any) -> bool:
    """Whether a table is the program's own; on PostgreSQL Procrastinate has its own in the same schema."""
    return not (kind == "table" and reflected and name is not None and name.startswith("procrastinate_"))


connection = context.config.attributes["connection"]
context.configure(
    connection=connection,
    target_metadata=metadata,
    include_object=ours,
    compare_type=True,
    render_as_batch=connection.dialect.name == "sqlite",
    transactional_ddl=True,
)
with context.begin_transaction():
    context.run_migrations()
