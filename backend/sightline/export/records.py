"""An export."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.infra.audit.records import Who
from sightline.results.selection import Selection


@dataclass(frozen=True, slots=True, kw_only=True)
class ExportFacts:
    """What is told of a package."""

    id: int
    created_at: datetime
    created_by: Who | None
    size_bytes: int
    sha256: str
    audit_count: Annotated[int, Field(description="How many events the audit chain in it has.")]
    audit_head: Annotated[str, Field(description="The last hash of that chain; keep it elsewhere.")]
    selection: Annotated[Selection, Field(description="The vehicles that its statistics are of.")]
    language: Annotated[str, Field(description="That of its figures and its report.")]


@dataclass(frozen=True, slots=True, kw_only=True)
class Export(ExportFacts):
    """A package in the media store."""

    survey_id: int
    media_key: str
