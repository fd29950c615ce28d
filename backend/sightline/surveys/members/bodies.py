"""Members of a survey as they come in and go out."""

from typing import Annotated

from pydantic import Field

from sightline.enums import Role, SurveyRole
from sightline.infra.web.bodies import In, Out, example


class MemberBody(Out):
    person_id: int
    name: str
    role: SurveyRole
    active: bool
    account_role: Annotated[
        Role, Field(description="An administrator's role in a survey changes nothing: they do everything.")
    ]


class MembersBody(Out):
    open_to_all: bool
    members: tuple[MemberBody, ...]


class MemberRole(In):
    model_config = example(role="operator")

    role: SurveyRole


class Openness(In):
    open_to_all: bool
