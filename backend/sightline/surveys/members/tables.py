"""Who belongs to which survey, and as what."""

from sqlalchemy import Column, ForeignKey, String, UniqueConstraint

from sightline.enums import SurveyRole
from sightline.infra.database.types import enum_check, numbered_table

# What stands now; who came, changed and went is told by the survey's audit chain.
survey_members = numbered_table(
    "survey_members",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False),
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    Column("role", String(20), nullable=False),
    UniqueConstraint("survey_id", "person_id"),
    enum_check("role", SurveyRole),
)
