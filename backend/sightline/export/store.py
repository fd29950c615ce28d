"""Exports: the packages that were made, each with the audit chain's head at that moment."""

from collections.abc import Mapping
from typing import Any

from sqlalchemy.orm import Session

from sightline.export.records import Export
from sightline.export.seal import ACTION, ENTITY
from sightline.infra.audit import trail
from sightline.infra.audit.records import AuditHead
from sightline.infra.audit.written import written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_row, get_row, the_one
from sightline.infra.database.types import now
from sightline.messages import SOURCE
from sightline.results.selection import Selection, selection_of
from sightline.results.tables import exports
from sightline.surveys.tables import surveys


def add_export(
    session: Session,
    survey_id: int,
    *,
    media_key: str,
    size_bytes: int,
    sha256: str,
    head: AuditHead,
    selection: Selection = Selection(),
    language: str = SOURCE,
    actor: int | None,
) -> Export:
    """A package that was written whole, its report in `language`; `head`: the audit head that it carries."""
    get_row(session, surveys, survey_id, "survey")
    content = {"survey_id": survey_id, "media_key": media_key, "size_bytes": size_bytes, "sha256": sha256}
    content |= {"audit_count": head.count, "audit_head": head.hash, "selection": selection.stored()}
    content |= {"language": language}
    export_id = add_row(session, exports, {**content, "created_at": now(), "created_by": actor})
    trail.record(session, actor, "create", "export", export_id, survey_id, None, content)
    return get_export(session, export_id)


def seal_package(session: Session, survey_id: int, after: Mapping[str, Any], *, actor: int | None) -> int:
    """Append a package's seal to the survey's chain, closed until the transaction ends; its number."""
    trail.record(session, actor, ACTION, ENTITY, None, survey_id, None, after)
    return trail.head(session, survey_id).count


def get_export(session: Session, export_id: int) -> Export:
    """One export. Raises NotFound."""
    return the_one(_fetch(session, exports.c.id == export_id), "export", export_id)


def list_exports(session: Session, survey_id: int) -> tuple[Export, ...]:
    """A survey's exports, newest first."""
    return _fetch(session, exports.c.survey_id == survey_id)


def _fetch(session: Session, condition: Any) -> tuple[Export, ...]:
    return tuple(
        record_of(Export, row, selection=selection_of(row["selection"]))
        for row in written_rows(session, exports, condition, newest_first=True)
    )
