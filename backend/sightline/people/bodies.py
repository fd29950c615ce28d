"""Accounts, sign-in and tokens as they come in and go out."""

from typing import Annotated

from pydantic import Field

from sightline.enums import Role, Scope
from sightline.infra.web.bearer import ApiTokenFacts
from sightline.infra.web.bodies import In, Name, Out, example
from sightline.infra.web.person import PersonFacts
from sightline.people.service import MAX_PASSWORD, MIN_PASSWORD
from sightline.people.token_store import MOST_DAYS

Secret = Annotated[str, Field(max_length=1000)]


class Credentials(In):
    model_config = example(email="ada@example.org", password="a few words in a row")

    email: Annotated[str, Field(max_length=320)]
    password: Secret


class LinkToken(In):
    token: Secret


class NewPassword(In):
    current: Secret | None = None
    new: Annotated[str, Field(min_length=MIN_PASSWORD, max_length=MAX_PASSWORD)]


class Me(Out):
    person: PersonFacts
    version: str
    needs_password: bool = Field(
        description="No password yet, or here by a one-time link: the current one is not asked."
    )
    needs_name: bool = Field(description="The first administrator, who was not asked for a name yet.")
    demo_survey_id: int | None


class OwnName(In):
    name: Name


class NewPerson(In):
    name: Name
    email: Annotated[str, Field(min_length=3, max_length=320)]
    role: Role


class PersonChange(In):
    name: Name
    role: Role
    active: bool


class Link(Out):
    link: str = Field(description="Path of the one-time sign-in page, valid 7 days; shown only now.")


class Invited(Link):
    person: PersonFacts


class NewToken(In):
    model_config = example(name="Import on the lab machine", scopes=["read", "upload"], days=90)

    name: Name
    scopes: Annotated[tuple[Scope, ...], Field(min_length=1, max_length=10)]
    days: Annotated[int, Field(ge=1, le=MOST_DAYS, description="Until it ends.")] = 90


class MadeToken(Out):
    token: ApiTokenFacts
    text: str = Field(description="Sent as `Authorization: Bearer TEXT`; shown only now.")
