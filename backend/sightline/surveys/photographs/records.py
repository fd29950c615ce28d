"""A photograph of the set-up."""

from dataclasses import dataclass, field
from datetime import datetime

from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotographFacts:
    """A picture of a survey's set-up; `sha256` and the size are of the JPEG that is kept."""

    id: int
    survey_id: int
    name: str
    caption: str
    sha256: str
    size_bytes: int
    width_px: int
    height_px: int
    version: int
    created_at: datetime
    created_by: Who | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Photograph(PhotographFacts):
    """One with its place among the others and where its JPEG is."""

    position: int
    media_key: str
    deleted: bool


@dataclass(frozen=True)
class PhotographFile:
    """A picture of the set-up: `content` is a PNG or JPEG file."""

    caption: str
    content: bytes = field(repr=False)
