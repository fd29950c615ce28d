"""Rows that people change (`ChangedByEvents`): made, changed, taken out and brought back, with an event each.

A row counts its versions; whoever changes it says which one they saw.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from sqlalchemy import Table, select
from sqlalchemy.orm import Session

from sightline.enums import AuditAction, JsonObject
from sightline.infra.audit import trail
from sightline.infra.audit.vouched import entity_of
from sightline.infra.database.rows import add_rows, change_row, last_change, named_by
from sightline.infra.database.types import GOES_ALONG, now


def make_rows(
    session: Session,
    table: Table,
    contents: Sequence[Mapping[str, Any]],
    *,
    survey_id: int | None,
    untold: Mapping[str, Any] = {},
    actor: int | None,
) -> list[int]:
    """The ids of new rows of contents that their events tell, and when made; `untold`: what else is there."""
    moment = now()
    stamps = {"version": 1, "created_by": actor, "updated_at": moment, "updated_by": actor}
    told = [{**content, "created_at": moment} for content in contents]
    row_ids = add_rows(session, table, [{**stamps, **one, **untold} for one in told])
    events = [(row_id, None, one) for row_id, one in zip(row_ids, told, strict=True)]
    trail.record_many(session, actor, "create", entity_of(table), survey_id, events)
    return row_ids


def alter_row(
    session: Session,
    table: Table,
    before: Mapping[str, Any],
    change: Mapping[str, Any],
    action: AuditAction = "update",
    told: tuple[JsonObject, JsonObject] | None = None,
    *,
    actor: int | None,
) -> None:
    """Change a row to its next version; its event has what changes, before and after, or what is `told`."""
    stamps = {"version": before["version"] + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, table, before["id"], {**change, **stamps})
    then, after = told or trail.changed_fields(before, change, change)
    place = (entity_of(table), before["id"], before.get("survey_id"))
    trail.record(session, actor, action, *place, then, after)


def take_out_row(
    session: Session, table: Table, before: Mapping[str, Any], *named: str, actor: int | None
) -> None:
    """Delete a row softly; `named`: what of it the event tells beside."""
    told = ({**{name: before[name] for name in named}, "deleted": False}, {"deleted": True})
    alter_row(session, table, before, {"deleted_at": now()}, "delete", told, actor=actor)


def take_out_along(session: Session, table: Table, row_id: int, *, actor: int | None) -> None:
    """Delete softly what is nothing without a row that goes."""
    for column in named_by(table, (GOES_ALONG,)):
        rest = select(column.table).where(column == row_id, column.table.c.deleted_at.is_(None))
        for row in session.execute(rest.order_by(column.table.c.id)).mappings().all():
            take_out_row(session, column.table, dict(row), "number", actor=actor)


def bring_back_row(session: Session, table: Table, before: Mapping[str, Any], *, actor: int | None) -> None:
    """Take a soft deletion back."""
    told = ({"deleted": True}, {"deleted": False})
    alter_row(session, table, before, {"deleted_at": None}, "restore", told, actor=actor)


def change_since(session: Session, row: Mapping[str, Any], version: int | None) -> tuple[str, str] | None:
    """Who changed a row last and when, for a sentence, where it is not the seen `version` (None: any)."""
    return None if version in (None, row["version"]) else last_change(session, row)
