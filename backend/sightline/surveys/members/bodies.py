"""Members of a survey as they come in and go out."""

from sightline.enums import SurveyRole
from sightline.infra.web.bodies import In, Out, example
from sightline.surveys.members.records import Member


class MembersBody(Out):
    open_to_all: bool
    members: tuple[Member, ...]


class MemberRole(In):
    model_config = example(role="operator")

    role: SurveyRole


class Openness(In):
    open_to_all: bool
