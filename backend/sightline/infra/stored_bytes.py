"""Bytes into the media store."""

import tempfile
from pathlib import Path

from sightline.infra.services import Services
from sightline.media.store.local import key_of, sha256_of


def put_bytes(services: Services, content: bytes, suffix: str) -> str:
    """Put bytes into the media store; the key. Raises NoRoom."""
    with tempfile.TemporaryDirectory(prefix="image-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        key = key_of(sha256_of(path), suffix)
        services.media.put_file(key, path)
    return key
