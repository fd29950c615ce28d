"""Bytes into the media store."""

import tempfile
from pathlib import Path

from backend.media.store import key_of, sha256_of
from backend.work.services import Services


def keep(services: Services, content: bytes, suffix: str) -> str:
    """Put bytes into the media store; the key. Raises NoRoom."""
    with tempfile.TemporaryDirectory(prefix="image-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        key = key_of(sha256_of(path), suffix)
        services.media.put_file(key, path)
    return key
