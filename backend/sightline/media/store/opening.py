"""The media store that an address names."""

from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from sightline.errors import BadInput
from sightline.media.store.local import LocalStore, MediaStore


def open_store(media_url: str, cache_dir: Path | None = None, cache_bytes: int = 20 << 30) -> MediaStore:
    """The store that an address names: a folder (path or file:///path) or s3://bucket/prefix.

    S3: `?endpoint=https://host:port&region=name` choose another server than Amazon's; credentials come from
    the usual AWS_ variables or files. `cache_dir` is needed for S3 and holds at most `cache_bytes`.
    Raises BadInput.
    """
    parts = urlsplit(media_url)
    if parts.scheme == "s3":
        from sightline.media.store.s3 import S3Store

        if cache_dir is None:
            raise BadInput("store-no-cache")
        return S3Store(media_url, cache_dir, cache_bytes)
    if parts.scheme == "file":
        return LocalStore(Path(url2pathname(parts.path)))
    if "://" in media_url or not media_url:
        raise BadInput("store-address-form", media_url=repr(media_url))
    return LocalStore(Path(media_url))
