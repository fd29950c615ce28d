"""Bytes into the media store, and the ending of the key that they get."""

import re
import tempfile
from pathlib import Path, PurePosixPath

from sightline.infra.services import Services
from sightline.media.store.local import key_of, sha256_of

_SUFFIX = re.compile(r"\.[A-Za-z0-9]{1,8}$")


def put_bytes(services: Services, content: bytes, suffix: str) -> str:
    """Put bytes into the media store; the key. Raises NoRoom."""
    with tempfile.TemporaryDirectory(prefix="image-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        key = key_of(sha256_of(path), suffix)
        services.media.put_file(key, path)
    return key


def require_media(services: Services) -> None:
    """Raises Away where the store does not answer: what is deleted then would leave its files there for ever,
    and who asks it under the lock under which files go keeps everybody waiting.
    """
    services.media.exists("00/00/nothing")


def suffix_of(filename: str) -> str:
    """The file name's ending where it is an ordinary one, in lower case; else nothing."""
    ending = _SUFFIX.search(PurePosixPath(filename.replace("\\", "/")).name)
    return ending.group().lower() if ending else ""
