"""Photographs of a survey's set-up: taken in as a plain small JPEG, and given out again."""

from sightline.errors import Damaged, NotFound
from sightline.infra.csv_package.schema import sha256_hex
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.stored_bytes import store_bytes
from sightline.media.images import jpeg
from sightline.surveys.photographs.records import Photograph
from sightline.surveys.photographs.store import add_photograph, require_photograph_room
from sightline.surveys.store import get_survey

MOST_SIDE_PX = 1600
JPEG_QUALITY = 88
# Of its own, so that no calibration image with the same content can take the file along when it goes.
_SUFFIX = "-setup.jpg"


def store_photograph(
    services: Services, survey_id: int, name: str, content: bytes, caption: str, actor: int
) -> Photograph:
    """Store a picture made anew from its pixels, so that nothing that a camera wrote into the file, such as
    the place, goes along. Raises BadInput, naming the file, for what is no picture; NotFound, NoRoom.
    """
    with services.reading() as session:
        get_survey(session, survey_id)
        require_photograph_room(session, survey_id)
    picture = services.frames.image_bgr(content, name, MOST_SIDE_PX)
    height, width = picture.shape[:2]
    kept = jpeg(picture, JPEG_QUALITY)

    def note(session: Session, key: str) -> Photograph:
        return add_photograph(
            session,
            survey_id,
            name=name,
            caption=caption,
            media_key=key,
            sha256=sha256_hex(kept),
            size_bytes=len(kept),
            width_px=int(width),
            height_px=int(height),
            actor=actor,
        )

    return store_bytes(services, survey_id, kept, _SUFFIX, note, actor=actor)


def photograph_content(services: Services, photograph: Photograph) -> bytes:
    """The JPEG as it was taken in. Raises Damaged if it is missing or another."""
    try:
        content = services.media.local_path(photograph.media_key).read_bytes()
    except (NotFound, OSError):
        content = b""
    if sha256_hex(content) != photograph.sha256:
        raise Damaged("surveys-photograph-missing", name=photograph.name)
    return content
