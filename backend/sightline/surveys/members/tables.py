"""Who belongs to which survey, and as what."""

from sqlalchemy import Column, ForeignKey, String, Table, UniqueConstraint

from sightline.enums import SurveyRole
from sightline.infra.database.types import enum_check, identity, metadata

# What stands now; who came, changed and went is told by the survey's audit chain.
survey_members = Table(
    "survey_members",
    metadata,
    identity(),
    Column("survey_id", ForeignKey("surveys.id"), nullable=False),
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    Column("role", String(20), nullable=False),
    UniqueConstraint("survey_id", "person_id"),
    enum_check("role", SurveyRole),
)
