"""An audit event with the names of what it is about."""

from dataclasses import dataclass

from sightline.enums import Target
from sightline.infra.audit.records import AuditEvent


@dataclass(frozen=True, slots=True)
class Subject:
    """What an event is about, as people call it; null where it has no such thing or it is gone."""

    survey: str | None = None
    name: str | None = None
    vehicle_id: int | None = None
    vehicle: int | None = None
    target: Target | None = None
    measurement_id: int | None = None


@dataclass(frozen=True, slots=True)
class NamedEvent:
    event: AuditEvent
    subject: Subject
