"""Deleting stored files that nothing needs any more, as a job: a store that is away is waited for."""

from collections.abc import Mapping
from typing import Any

from sightline.infra.backup.state import needed_media
from sightline.infra.database import Session
from sightline.infra.jobs.registry import JobContext, handler
from sightline.infra.stored_bytes import TIDY
from sightline.media.store.local import made_of
from sightline.recordings.store import recordings_of_content


@handler(TIDY, cancellable=False)
def tidy(context: JobContext) -> Mapping[str, Any]:
    """Delete those of the files that nothing needs. May be done again."""
    services = context.services
    for key in context.payload["keys"]:
        if not services.media.exists(key):  # a store that is away keeps nobody from writing
            continue
        # Nobody can begin to need the file while the lock is held; each file takes it for moments.
        with services.writing() as session:
            if not _is_needed(session, key):
                services.media.delete(key)
    return {}


def _is_needed(session: Session, key: str) -> bool:
    made = made_of(key)
    return bool(needed_media(session, key) if made is None else recordings_of_content(session, *made))
