"""Files into the media store with the row that needs them, their keys' ending, and files that may go."""

import logging
import re
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path, PurePosixPath
from typing import TypeVar

from sightline.infra.database import Session
from sightline.infra.idempotency.request import beside_request
from sightline.infra.jobs import registry
from sightline.infra.services import Services
from sightline.media.store.local import key_of, sha256_of

Made = TypeVar("Made")

log = logging.getLogger(__name__)

TIDY = "tidy"
_SUFFIX = re.compile(r"\.[A-Za-z0-9]{1,8}$")


def store_file(
    services: Services,
    survey_id: int,
    key: str,
    path: Path,
    note: Callable[[Session], Made],
    *,
    actor: int | None,
    link: bool = False,
) -> Made:
    """Store a file and `note` in one transaction what it became; what `note` gives.

    What had the same content may be deleted meanwhile, with its file, so whether it is there is asked inside
    that transaction: from there on it stays. Where nothing is noted, a job deletes the file unless something
    else needs it; a database that does not take the job either, or a process killed before that, leaves it.
    Raises NoRoom, Away, and what `note` raises.
    """
    while True:
        try:
            services.media.put_file(key, path, link=link)  # may be there though its answer was lost
            with services.writing() as session:
                if services.media.exists(key):
                    return note(session)
        except Exception:
            _let_go_unnoted(services, survey_id, key, actor)
            raise


def _let_go_unnoted(services: Services, survey_id: int, key: str, actor: int | None) -> None:
    """Raises nothing: what the caller met is what is said."""
    try:
        with beside_request(), services.writing() as session:
            let_go(session, survey_id, [key], actor)
    except Exception:
        log.exception("%s stays in the media store", key)


def store_bytes(
    services: Services,
    survey_id: int,
    content: bytes,
    suffix: str,
    note: Callable[[Session, str], Made],
    *,
    actor: int,
) -> Made:
    """`store_file` of bytes; `note` is told the key that they have."""
    with tempfile.TemporaryDirectory(prefix="image-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        key = key_of(sha256_of(path), suffix)
        return store_file(services, survey_id, key, path, lambda session: note(session, key), actor=actor)


def let_go(session: Session, survey_id: int, keys: Iterable[str | None], actor: int | None) -> None:
    """What named these files is gone: a job of the caller's transaction deletes those that nothing needs.

    Once that is committed, none stays there for ever, whatever happens to a process or to the store.
    """
    payload = {"keys": [key for key in keys if key]}
    if payload["keys"]:
        registry.enqueue(session, TIDY, payload, survey_id=survey_id, actor=actor)


def suffix_of(filename: str) -> str:
    """The file name's ending where it is an ordinary one, in lower case; else nothing."""
    ending = _SUFFIX.search(PurePosixPath(filename.replace("\\", "/")).name)
    return ending.group().lower() if ending else ""
