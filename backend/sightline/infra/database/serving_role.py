"""The PostgreSQL role that serves: it reads and writes rows, and owns no table, so no trigger either."""

from typing import Any

from psycopg import sql
from pydantic import SecretStr
from sqlalchemy import Connection, text

_THERE = text("SELECT FROM pg_roles WHERE rolname = :role")
_SCHEMA = text("SELECT current_schema()")
_RIGHTS = (
    "GRANT USAGE ON SCHEMA {schema} TO {role}",
    "GRANT SELECT, INSERT, UPDATE, DELETE ON ALL TABLES IN SCHEMA {schema} TO {role}",
    "GRANT USAGE, SELECT, UPDATE ON ALL SEQUENCES IN SCHEMA {schema} TO {role}",
)


def give_rights(connection: Connection, role: str, password: SecretStr | None) -> None:
    """Let a role serve this installation's schema; with a password it is made, or gets that one.

    For whoever owns the schema; may be done again, and has to be after each migration. The password leaves
    this process as a hash, so that no log of the server holds it.
    """
    driver: Any = connection.connection.driver_connection

    def run(words: str, **parts: sql.Composable) -> None:
        connection.exec_driver_sql(sql.SQL(words).format(**parts).as_string(driver))

    name = sql.Identifier(role)
    if password is not None:
        given = password.get_secret_value().encode()
        hashed = driver.pgconn.encrypt_password(given, role.encode(), b"scram-sha-256").decode()
        there = connection.execute(_THERE, {"role": role}).first() is not None
        verb = "ALTER" if there else "CREATE"
        run(f"{verb} ROLE {{role}} LOGIN PASSWORD {{hashed}}", role=name, hashed=sql.Literal(hashed))
    schema = sql.Identifier(connection.execute(_SCHEMA).scalar_one())
    for right in _RIGHTS:
        run(right, schema=schema, role=name)
