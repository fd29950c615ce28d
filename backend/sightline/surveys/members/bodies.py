"""Members of a survey as they come in and go out."""

from sightline.enums import SurveyRole
from sightline.infra.web.bodies import In, Out


class MemberBody(Out):
    person_id: int
    name: str
    role: SurveyRole
    active: bool


class MembersBody(Out):
    open_to_all: bool
    members: tuple[MemberBody, ...]


class MemberRole(In):
    role: SurveyRole


class Openness(In):
    open_to_all: bool
