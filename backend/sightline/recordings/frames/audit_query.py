"""What the audit chain says of frame tables: the fingerprint that the ingest noted."""

from collections.abc import Iterator

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit.vouched import Event, Fingerprint, register
from sightline.recordings.frames.store import frame_table_fingerprint, get_frame_table
from sightline.recordings.tables import recordings


def _promise(event: Event, promised: dict[int, str]) -> None:
    if event.entity_id is None:
        return
    if "frames_sha256" in event.after:
        promised[event.entity_id] = event.after["frames_sha256"]
    if (event.entity, event.action) == ("recording", "delete"):
        promised.pop(event.entity_id, None)


def _stored_fingerprints(session: Session) -> Iterator[tuple[int, str]]:
    query = select(recordings.c.id).where(
        recordings.c.frame_count.is_not(None), recordings.c.deleted_at.is_(None)
    )
    for recording_id in session.execute(query.order_by(recordings.c.id)).scalars().all():
        yield recording_id, frame_table_fingerprint(get_frame_table(session, recording_id))


register(Fingerprint("frames", _promise, _stored_fingerprints))
