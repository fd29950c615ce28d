"""What a survey is."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, get_args

from sightline.enums import USUALLY_ASKED, AskedTarget, Lighting
from sightline.geometry.insets import ROOF_OF_CLASS, USUAL_INSETS
from sightline.geometry.sides import TrafficFacts
from sightline.infra.meaning import explained_as
from sightline.messages import say_or
from sightline.statistics.sampling import Sampling
from sightline.surveys.classes import VehicleClass
from sightline.surveys.place import Place


@dataclass(frozen=True, slots=True)
class Inset:
    """How far a target lies behind the side plane, metres, and its standard uncertainty; `code`: by which its
    note, if it is the program's, is said in other languages, None where a person wrote it.
    """

    inset_m: float
    u_inset_m: float
    note: str = ""
    code: str | None = field(default=None, compare=False)


#: The insets of a survey that says none: estimates.
USUAL: dict[str, Inset] = {name: Inset(*usual, code=name) for name, usual in USUAL_INSETS.items()}
_CODES: dict[str, str] = {one.note: name for name, one in USUAL.items()}


def note_in(note: str, language: str) -> str:
    """The note of an inset of a package, which has no codes: the program's in a language, else as it is."""
    return say_or(f"inset-note-{_CODES.get(note)}", note, language)


def _inset(values: Mapping[str, Any]) -> Inset:
    """As it is stored; one of before there were codes gets it by its note."""
    return Inset(**{"code": _CODES.get(values.get("note", "")), **values})


def insets_of(told: Mapping[str, Mapping[str, Any]]) -> dict[str, Inset]:
    """A survey's insets as its row or an event of it has them; one from before roofs had insets by class has
    the one of all, one from before a target was known its usual one.
    """
    found = {name: _inset(values) for name, values in told.items()}
    roofs = (*ROOF_OF_CLASS.values(), "roof_unknown")
    return {**USUAL, **{name: found["roof"] for name in roofs}, **found}


@dataclass(frozen=True, slots=True)
class Asked:
    """The targets that a vehicle is to have, by lighting."""

    daytime: tuple[AskedTarget, ...] = USUALLY_ASKED["daytime"]
    low_light: tuple[AskedTarget, ...] = USUALLY_ASKED["low_light"]

    def of(self, lighting: Lighting | None) -> tuple[AskedTarget, ...]:
        """Those of one vehicle, in the usual order; all of both where its lighting is unknown."""
        both = {*self.daytime, *self.low_light}
        by_lighting = self.daytime if lighting == "daytime" else self.low_light
        wanted = both if lighting is None else by_lighting
        return tuple(target for target in get_args(AskedTarget) if target in wanted)


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("survey")
class SurveyContent:
    """What people say of a survey, but for its insets."""

    name: str
    site: str
    description: str
    traffic: TrafficFacts
    place: Place
    asked: Asked
    classes: tuple[VehicleClass, ...]
    sampling: Sampling


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("survey")
class SurveyFacts(SurveyContent):
    """A survey but for its insets; its progress: `results`."""

    id: int
    is_demo: bool
    simulated: bool
    open_to_all: bool
    version: int
    created_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class Survey(SurveyFacts):
    """A survey with its insets by `InsetName`."""

    insets: Mapping[str, Inset]
