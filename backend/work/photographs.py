"""Photographs of a survey's set-up: taken in as a plain small JPEG, and given out again."""

import tempfile
from pathlib import Path

from backend.errors import Damaged, NotFound
from backend.media.images import jpeg
from backend.media.store import key_of, sha256_of
from backend.storage import photographs, surveys
from backend.storage.records import Photograph
from backend.work.packaging import sha256_hex
from backend.work.services import Services

MOST_SIDE_PX = 1600
JPEG_QUALITY = 88
# Of its own, so that no calibration image with the same content can take the file along when it goes.
_SUFFIX = "-setup.jpg"


def add(
    services: Services, survey_id: int, name: str, content: bytes, caption: str, actor: int
) -> Photograph:
    """Store a picture made anew from its pixels, so that nothing that a camera wrote into the file, such as
    the place, goes along. Raises BadInput, naming the file, for what is no picture; NotFound, NoRoom.
    """
    with services.reading() as session:
        surveys.get(session, survey_id)
        photographs.check_room(session, survey_id)
    picture = services.frames.image_bgr(content, name, MOST_SIDE_PX)
    height, width = picture.shape[:2]
    key, sha256, size = _keep(services, jpeg(picture, JPEG_QUALITY))
    with services.writing() as session:
        return photographs.add(
            session,
            survey_id,
            name=name,
            caption=caption,
            media_key=key,
            sha256=sha256,
            size_bytes=size,
            width_px=int(width),
            height_px=int(height),
            actor=actor,
        )


def _keep(services: Services, content: bytes) -> tuple[str, str, int]:
    """Into the media store; the key, the hash, the size in bytes. Raises NoRoom."""
    with tempfile.TemporaryDirectory(prefix="photograph-", dir=services.scratch) as folder:
        path = Path(folder) / "content"
        path.write_bytes(content)
        sha256 = sha256_of(path)
        key = key_of(sha256, _SUFFIX)
        services.media.put_file(key, path)
    return key, sha256, len(content)


def content_of(services: Services, photograph: Photograph) -> bytes:
    """The JPEG as it was taken in. Raises Damaged if it is missing or another."""
    try:
        content = services.media.local_path(photograph.media_key).read_bytes()
    except (NotFound, OSError):
        content = b""
    if sha256_hex(content) != photograph.sha256:
        raise Damaged(
            f"The file of the photograph “{photograph.name}” is missing or was changed; take it out of the "
            "survey and add it again."
        )
    return content
