"""Fields that more than one body has, with their units and limits."""

from typing import Annotated

from pydantic import Field

from sightline.infra.web.bodies import Finite, In

SigmaPx = Annotated[Finite, Field(gt=0, le=100, description="Standard uncertainty of each coordinate, px.")]


InsetM = Annotated[
    Finite, Field(ge=-10, le=10, description="How far the target lies behind the side plane, m.")
]


UInsetM = Annotated[Finite, Field(ge=0, le=10)]


Revision = Annotated[int, Field(ge=1, le=2**31 - 1, description="The revision that you saw.")]


SeenRevision = Annotated[int, Field(ge=0, le=2**31 - 1, description="The revision that you saw; 0: none.")]


Word = Annotated[str, Field(max_length=200)]


class AtRevision(In):
    revision: Revision
