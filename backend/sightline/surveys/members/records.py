"""A member of a survey."""

from dataclasses import dataclass

from sightline.enums import SurveyRole


@dataclass(frozen=True, slots=True)
class Member:
    """A person who belongs to a survey, and what they may do there."""

    person_id: int
    name: str
    role: SurveyRole
    active: bool
