"""Photographs of a survey's set-up: their captions and order; taken out ones are kept for undo."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.changing import alter_row, bring_back_row, change_since, make_rows, take_out_row
from sightline.infra.audit.written import written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import change_row, get_row, missing
from sightline.surveys.photographs.records import Photograph
from sightline.surveys.photographs.tables import survey_photographs as photographs
from sightline.surveys.tables import surveys

MOST_PHOTOGRAPHS = 40
MOST_CAPTION = 500


def add_photograph(
    session: Session,
    survey_id: int,
    *,
    name: str,
    media_key: str,
    sha256: str,
    size_bytes: int,
    width_px: int,
    height_px: int,
    caption: str = "",
    actor: int | None,
) -> Photograph:
    """A stored JPEG as the survey's last photograph. Raises NotFound, BadInput for too many of them."""
    get_row(session, surveys, survey_id, "survey")
    require_photograph_room(session, survey_id)
    last = select(func.max(photographs.c.position)).where(photographs.c.survey_id == survey_id)
    content = {
        "name": name,
        "caption": _caption(caption),
        "position": int(session.execute(last).scalar_one() or 0) + 1,
        "media_key": media_key,
        "sha256": sha256,
        "size_bytes": size_bytes,
        "width_px": width_px,
        "height_px": height_px,
    }
    of = {"survey_id": survey_id}
    (new_id,) = make_rows(session, photographs, [content], **of, untold=of, actor=actor)
    return get_photograph(session, new_id)


def require_photograph_room(session: Session, survey_id: int) -> None:
    """Raises BadInput if a survey has as many photographs as it may."""
    if len(list_photographs(session, survey_id)) >= MOST_PHOTOGRAPHS:
        raise BadInput("surveys-photographs-many", most_photographs=MOST_PHOTOGRAPHS)


def get_photograph(session: Session, photograph_id: int, *, deleted: bool = False) -> Photograph:
    """One photograph; a deleted one only if `deleted`. Raises NotFound."""
    found = _fetch_photographs(session, photographs.c.id == photograph_id)
    if not found or (found[0].deleted and not deleted):
        raise missing("photograph", photograph_id)
    return found[0]


def list_photographs(session: Session, survey_id: int) -> tuple[Photograph, ...]:
    """The photographs of a survey in their order."""
    alive = _fetch_photographs(
        session, photographs.c.survey_id == survey_id, photographs.c.deleted_at.is_(None)
    )
    return tuple(sorted(alive, key=lambda one: one.position))


def change_photograph_caption(
    session: Session, photograph_id: int, caption: str, *, version: int, actor: int | None
) -> Photograph:
    """Another caption. Raises NotFound, BadInput, and Conflict if `version` is not the current one."""
    before = _current(session, photograph_id, version)
    alter_row(session, photographs, before, {"caption": _caption(caption)}, actor=actor)
    return get_photograph(session, photograph_id)


def order_photographs(
    session: Session, survey_id: int, ids: Sequence[int], *, actor: int | None
) -> tuple[Photograph, ...]:
    """Put the photographs into the order of `ids`. Raises Conflict if these are not the ones there are."""
    there = [one.id for one in list_photographs(session, survey_id)]
    if sorted(there) != sorted(ids):
        raise Conflict("surveys-photographs-changed")
    for position, photograph_id in enumerate(ids, start=1):
        change_row(session, photographs, photograph_id, {"position": position})
    before, after = {"order": there}, {"order": list(ids)}
    trail.record(session, actor, "order", "photograph", None, survey_id, before, after)
    return list_photographs(session, survey_id)


def remove_photograph(session: Session, photograph_id: int, *, version: int, actor: int | None) -> Photograph:
    """Take a photograph out; `restore` brings it back. Raises NotFound, Conflict."""
    take_out_row(session, photographs, _current(session, photograph_id, version), actor=actor)
    return get_photograph(session, photograph_id, deleted=True)


def restore_photograph(session: Session, photograph_id: int, *, actor: int | None) -> Photograph:
    """Bring a photograph back that was taken out. Raises NotFound, BadInput."""
    before = get_row(session, photographs, photograph_id, "photograph")
    if before["deleted_at"] is None:
        return get_photograph(session, photograph_id)
    require_photograph_room(session, before["survey_id"])
    bring_back_row(session, photographs, before, actor=actor)
    return get_photograph(session, photograph_id)


def _current(session: Session, photograph_id: int, version: int) -> dict[str, Any]:
    row = get_row(session, photographs, photograph_id, "photograph", photographs.c.deleted_at.is_(None))
    if by := change_since(session, row, version):
        raise Conflict("surveys-photograph-changed", name=by[0], when=by[1])
    return row


def _caption(text: str) -> str:
    caption = " ".join(text.split())
    if len(caption) > MOST_CAPTION:
        raise BadInput("surveys-caption-long", most_caption=MOST_CAPTION)
    return caption


def _fetch_photographs(session: Session, *conditions: ColumnElement[bool]) -> tuple[Photograph, ...]:
    rows = written_rows(session, photographs, *conditions)
    return tuple(record_of(Photograph, row, deleted=row["deleted_at"] is not None) for row in rows)
