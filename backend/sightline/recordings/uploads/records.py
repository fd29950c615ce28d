"""An upload under way."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import UploadPurpose
from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class Upload:
    """A file on its way in; how much of it has arrived is the length of its part on disk.

    A video becomes a recording; a strip waits, with its content's `sha256`, for the scan that it belongs to.
    """

    id: int
    survey_id: int
    filename: str
    size_bytes: int
    media_key: str
    created_at: datetime
    created_by: Who | None
    recording_id: int | None
    finished_at: datetime | None
    purpose: UploadPurpose = "video"
    sha256: str | None = None
    scan_id: int | None = None
