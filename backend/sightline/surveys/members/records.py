"""A member of a survey."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import Role, SurveyRole


@dataclass(frozen=True, slots=True)
class Member:
    """A person who belongs to a survey, and what they may do there."""

    person_id: int
    name: str
    role: SurveyRole
    active: bool
    account_role: Annotated[
        Role, Field(description="An administrator's role in a survey changes nothing: they do everything.")
    ]


@dataclass(frozen=True, slots=True)
class Candidate:
    """A person who may be made a member, and the role of their account."""

    id: int
    name: str
    account_role: Role
