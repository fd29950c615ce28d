"""What surveys take, and what is said of one."""

from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.geometry.insets import INSET_CHOICES
from sightline.infra.web.bodies import In, Name, Out, Text

Metres = Annotated[float, Field(ge=-10, le=10, allow_inf_nan=False)]
Uncertainty = Annotated[float, Field(ge=0, le=10, allow_inf_nan=False)]


class InsetBody(Out):
    inset_m: Metres
    u_inset_m: Uncertainty
    note: Annotated[str, Field(max_length=1000)] = ""


class InsetIn(In):
    inset_m: Metres
    u_inset_m: Uncertainty
    note: Annotated[str, Field(max_length=1000)] = ""


class Insets(Out):
    roof: InsetBody
    driver_eye: InsetBody
    taillight: InsetBody
    headlight: InsetBody
    other: InsetBody


class InsetChanges(In):
    """Targets left out keep their inset."""

    roof: InsetIn | None = None
    driver_eye: InsetIn | None = None
    taillight: InsetIn | None = None
    headlight: InsetIn | None = None
    other: InsetIn | None = None


class InsetChoice(Out):
    words: str
    inset_m: float
    u_inset_m: float


def inset_choices() -> dict[str, list[InsetChoice]]:
    """Per target what can be told apart by looking at the vehicle; the same for every survey."""
    return {
        target: [InsetChoice(words=words, inset_m=inset, u_inset_m=u) for words, inset, u in choices]
        for target, choices in INSET_CHOICES.items()
    }


class SurveyFacts(Out):
    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    insets: Insets
    inset_choices: dict[str, list[InsetChoice]] = Field(default_factory=inset_choices)


class NewSurvey(In):
    name: Name
    site: Annotated[str, Field(max_length=200)] = ""
    description: Text = ""


class SurveyChange(NewSurvey):
    version: int = Field(
        description="The version that was changed; another's change in between is a conflict."
    )
    insets: InsetChanges | None = None
