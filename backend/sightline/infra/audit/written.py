"""Rows that are written once, each with an event that holds its hash; and rows read with their maker."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sqlalchemy import Column, ColumnElement, Table, select
from sqlalchemy.orm import Session

from sightline.enums import AuditAction
from sightline.infra.audit import trail
from sightline.infra.audit.vouched import entity_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, stored_hash, who
from sightline.infra.database.types import columns_of, now


def written_once(
    session: Session,
    table: Table,
    content: Mapping[str, Any],
    action: AuditAction,
    *,
    survey_id: int | None = None,
    before: Mapping[str, Any] | None = None,
    also: Mapping[str, Any] = {},
    untold: Iterable[str] = (),
    actor: int | None,
) -> int:
    """The id of a new row of `content`, whose event tells it and when it was made, but for what is `untold`,
    and `also`.

    `survey_id`: whose chain has the event, where no column says so; else it is of no survey.
    """
    made = {**content, "created_at": now()}
    row_id = add_row(session, table, {**made, "created_by": actor})
    told = {name: value for name, value in made.items() if name not in untold}
    after = {**told, **also, "content_sha256": stored_hash(session, table, row_id)}
    chain = content.get("survey_id") if survey_id is None else survey_id
    trail.record(session, actor, action, entity_of(table), row_id, chain, before, after)
    return row_id


def written_rows(
    session: Session,
    table: Table,
    *conditions: ColumnElement[bool],
    without: Iterable[str] = (),
    beside: Sequence[Column[Any]] = (),
    of: Table | None = None,
    newest_first: bool = False,
) -> list[dict[str, Any]]:
    """The rows that meet the conditions, in the order of their making, `created_by` being a person;
    `without`: columns that nobody asks for; `beside`: columns of the rows that they are `of`.
    """
    query = (
        select(*columns_of(table, *without), *beside, people.c.name.label("maker"))
        .select_from(table if of is None else table.join(of))
        .outerjoin(people, people.c.id == table.c.created_by)
        .where(*conditions)
        .order_by(table.c.id.desc() if newest_first else table.c.id)
    )
    rows: list[dict[str, Any]] = [dict(row) for row in session.execute(query).mappings()]
    return [{**row, "created_by": who(row["created_by"], row["maker"])} for row in rows]
