"""The words that figures and report call things by."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.enums import Category, ClassSet, Correction, Direction, StatisticsTarget, Target
from sightline.results.selection import Selection

TARGETS: dict[Target, str] = {
    "driver_eye": "driver’s eye",
    "taillight": "taillight, lower limit",
    "headlight": "headlight",
    "roof": "roof",
    "other": "other",
}
EYES = {
    "driver_eye_near": "driver’s eye, driver on the near side",
    "driver_eye_far": "driver’s eye, driver on the far side",
}
MANY: dict[StatisticsTarget, str] = {
    "driver_eye": "drivers’ eyes",
    "taillight": "taillights’ lower limits",
    "headlight": "headlights",
    "roof": "roofs",
}
GROUPS: dict[str, str] = {"daytime": "daytime", "low_light": "low light", "overall": "overall"}
LIGHTING: dict[str, str] = {"daytime": "daytime", "low_light": "low light", "": "lighting unknown"}
CATEGORIES: dict[Category, str] = {
    "hatchback": "hatchback",
    "saloon": "saloon",
    "estate": "estate",
    "suv": "SUV",
    "multi_purpose": "multi-purpose vehicle",
    "pickup": "pick-up",
    "van": "van",
    "lorry": "lorry",
    "tractor_unit": "tractor unit",
    "bus": "bus",
    "recreational_vehicle": "recreational vehicle",
    "trailer": "trailer or caravan",
    "motorcycle": "motorcycle",
    "other": "other",
}
LANES: dict[Direction, str] = {"right": "to the right", "left": "to the left"}
CLASS_SETS: dict[ClassSet, str] = {
    "passenger_cars": "passenger cars",
    "light_trucks": "light trucks and multi-purpose",
    "heavy": "heavy vehicles",
}
GROUPINGS: dict[str, str] = {"class_set": "set of classes"}
CORRECTIONS: dict[Correction, str] = {
    "inset": "corrected by inset",
    "shift": "corrected by shift",
    "none": "not corrected",
    "regression": "corrected by regression",
    "deconvolution": "corrected by deconvolution",
}


def heading(word: str) -> str:
    """With a capital."""
    return word[:1].upper() + word[1:]


def target_words(word: str) -> str:
    """A target or an inset as a package names it, for people; one that is not known by its own name."""
    known = [*TARGETS.items(), *EYES.items()]
    return next((words for name, words in known if name == word), word)


def group_word(grouping: str, word: str) -> str:
    """A group of vehicles, for people."""
    known: dict[str, Mapping[Any, str]] = {
        "lighting": LIGHTING,
        "category": CATEGORIES,
        "class_set": CLASS_SETS,
        "lane": LANES,
    }
    return known.get(grouping, {}).get(word, word)


def selection_words(selection: Selection) -> str | None:
    """What a package or report is of: "low light; passenger cars, SUV"; None for the whole survey."""
    if selection.is_all:
        return None
    classes = [
        *(CLASS_SETS[one] for one in selection.class_sets),
        *(CATEGORIES[one] for one in selection.categories),
    ]
    lighting = [] if selection.lighting is None else [LIGHTING[selection.lighting]]
    days = (("filmed from", selection.filmed_from), ("filmed up to", selection.filmed_to))
    filmed = [f"{words} {day.isoformat()}" for words, day in days if day is not None]
    return "; ".join([*lighting, *([", ".join(classes)] if classes else []), *filmed])
