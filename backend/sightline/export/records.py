"""An export."""

from dataclasses import dataclass
from datetime import datetime

from sightline.infra.audit.records import Who
from sightline.results.selection import Selection


@dataclass(frozen=True, slots=True)
class Export:
    id: int
    survey_id: int
    created_at: datetime
    created_by: Who | None
    media_key: str
    size_bytes: int
    sha256: str
    audit_count: int
    audit_head: str
    selection: Selection
    language: str
