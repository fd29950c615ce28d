"""Bytes into the media store, the ending of the key that they get, and files that may go."""

import re
import tempfile
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.services import Services
from sightline.media.store.local import key_of, sha256_of

TIDY = "tidy"
_SUFFIX = re.compile(r"\.[A-Za-z0-9]{1,8}$")


def put_bytes(services: Services, content: bytes, suffix: str) -> str:
    """Put bytes into the media store; the key. Raises NoRoom."""
    with tempfile.TemporaryDirectory(prefix="image-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        key = key_of(sha256_of(path), suffix)
        services.media.put_file(key, path)
    return key


def let_go(session: Session, survey_id: int, keys: Iterable[str | None], actor: int | None) -> None:
    """What named these files is gone: a job of the caller's transaction deletes those that nothing needs.

    Whatever happens to a process or to the store meanwhile, none stays there for ever.
    """
    payload = {"keys": [key for key in keys if key]}
    if payload["keys"]:
        registry.enqueue(session, TIDY, payload, survey_id=survey_id, actor=actor)


def suffix_of(filename: str) -> str:
    """The file name's ending where it is an ordinary one, in lower case; else nothing."""
    ending = _SUFFIX.search(PurePosixPath(filename.replace("\\", "/")).name)
    return ending.group().lower() if ending else ""
