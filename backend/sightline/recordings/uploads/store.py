"""Uploads on their way in (tus), and what became of each."""

from typing import Any

from sqlalchemy import ColumnElement, delete
from sqlalchemy.orm import Session

from sightline.enums import UploadPurpose
from sightline.errors import Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.written import written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_row, change_row, get_row, the_one
from sightline.infra.database.types import now
from sightline.recordings.uploads.records import Upload
from sightline.recordings.uploads.tables import uploads
from sightline.surveys.tables import surveys


def create_upload(
    session: Session,
    survey_id: int,
    *,
    filename: str,
    size_bytes: int,
    media_key: str,
    purpose: UploadPurpose = "video",
    actor: int | None,
) -> Upload:
    """An upload of which nothing has arrived; `media_key` is where its bytes are gathered."""
    get_row(session, surveys, survey_id, "survey")
    content: dict[str, Any] = {"survey_id": survey_id, "filename": filename, "size_bytes": size_bytes}
    if purpose != "video":
        content["purpose"] = purpose
    stamps = {"media_key": media_key, "created_at": now(), "created_by": actor}
    upload_id = add_row(session, uploads, {**content, **stamps})
    trail.record(session, actor, "create", "upload", upload_id, survey_id, None, content)
    return get_upload(session, upload_id)


def get_upload(session: Session, upload_id: int) -> Upload:
    """One upload. Raises NotFound."""
    return the_one(_fetch_uploads(session, uploads.c.id == upload_id), "upload", upload_id)


def unfinished_uploads(
    session: Session, survey_id: int | None = None, *, maker: int | None = None
) -> tuple[Upload, ...]:
    """The uploads that can go on, of one survey or of all, by one person or by all."""
    wanted = {uploads.c.survey_id: survey_id, uploads.c.created_by: maker}
    asked = (column == value for column, value in wanted.items() if value is not None)
    return _fetch_uploads(session, uploads.c.finished_at.is_(None), *asked)


def finish_upload(session: Session, upload_id: int, *, recording_id: int, actor: int | None) -> Upload:
    """All bytes are in and became this recording."""
    before = get_upload(session, upload_id)
    if before.finished_at is not None:
        raise Conflict("recordings-upload-finished")
    change_row(session, uploads, upload_id, {"recording_id": recording_id, "finished_at": now()})
    after = {"recording_id": recording_id}
    trail.record(session, actor, "finish", "upload", upload_id, before.survey_id, None, after)
    return get_upload(session, upload_id)


def strip_arrived(
    session: Session, upload_id: int, *, media_key: str, sha256: str, actor: int | None
) -> Upload:
    """All bytes of a strip are in and stored under `media_key`; it waits for its scan."""
    before = get_upload(session, upload_id)
    if before.finished_at is not None:
        raise Conflict("recordings-upload-awaits-scan")
    after = {"media_key": media_key, "sha256": sha256}
    change_row(session, uploads, upload_id, {**after, "finished_at": now()})
    trail.record(session, actor, "finish", "upload", upload_id, before.survey_id, None, after)
    return get_upload(session, upload_id)


def strips_waiting(session: Session, survey_id: int | None = None) -> tuple[Upload, ...]:
    """The strips that arrived and belong to no scan yet, of one survey or of all."""
    waiting = (uploads.c.purpose == "strip", uploads.c.finished_at.is_not(None), uploads.c.scan_id.is_(None))
    return _fetch_uploads(
        session, *waiting, *([] if survey_id is None else [uploads.c.survey_id == survey_id])
    )


def remove_upload(session: Session, upload_id: int, *, actor: int | None) -> Upload:
    """Give up an upload; the caller removes its part and lets go of its file.

    Raises Conflict for one that became something.
    """
    gone = get_upload(session, upload_id)
    if gone.finished_at is not None and (gone.purpose == "video" or gone.scan_id is not None):
        raise Conflict("recordings-upload-is-recording")
    session.execute(delete(uploads).where(uploads.c.id == upload_id))
    before = {"filename": gone.filename, "size_bytes": gone.size_bytes}
    trail.record(session, actor, "delete", "upload", upload_id, gone.survey_id, before, None)
    return gone


def _fetch_uploads(session: Session, *conditions: ColumnElement[bool]) -> tuple[Upload, ...]:
    return tuple(record_of(Upload, row) for row in written_rows(session, uploads, *conditions))
