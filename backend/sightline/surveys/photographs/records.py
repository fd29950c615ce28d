"""A photograph of the set-up."""

from dataclasses import dataclass, field
from datetime import datetime

from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class Photograph:
    """A picture of a survey's set-up; `sha256` and the size are of the JPEG that is kept."""

    id: int
    survey_id: int
    name: str
    caption: str
    position: int
    media_key: str
    sha256: str
    size_bytes: int
    width_px: int
    height_px: int
    version: int
    created_at: datetime
    created_by: Who | None
    deleted: bool


@dataclass(frozen=True)
class PhotographFile:
    """A picture of the set-up: `content` is a PNG or JPEG file."""

    caption: str
    content: bytes = field(repr=False)
