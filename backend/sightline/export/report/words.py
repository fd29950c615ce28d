"""The words that figures and report call things by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import date
from functools import reduce
from typing import Any

from sightline.enums import (
    Category,
    ClassSet,
    Direction,
    ReferenceSource,
    StatisticsTarget,
    Target,
)
from sightline.export.report.said import Called, said
from sightline.results.selection import Selection

_TARGETS_KEYS: dict[Target, str] = {
    "driver_eye": "report-driver-eye",
    "taillight": "report-taillight",
    "headlight": "report-headlight",
    "roof": "report-roof",
    "other": "report-other",
}
TARGETS = Called(_TARGETS_KEYS)
EYES = Called(
    {
        "roof": "report-roof-car",
        "roof_van": "report-roof-van",
        "roof_box": "report-roof-box",
        "roof_unknown": "report-roof-unknown",
        "driver_eye_near": "report-eye-near",
        "driver_eye_far": "report-eye-far",
    }
)
_MANY_KEYS: dict[StatisticsTarget, str] = {
    "driver_eye": "report-driver-eyes",
    "taillight": "report-taillights",
    "headlight": "report-headlights",
    "roof": "report-roofs",
}
MANY = Called(_MANY_KEYS)
_GROUPS_KEYS: dict[str, str] = {
    "daytime": "report-daytime",
    "low_light": "report-low-light",
    "overall": "report-overall",
}
GROUPS = Called(_GROUPS_KEYS)
_LIGHTING_KEYS: dict[str, str] = {
    "daytime": "report-daytime",
    "low_light": "report-low-light",
    "": "report-lighting-unknown",
}
LIGHTING = Called(_LIGHTING_KEYS)
_SOURCES_KEYS: dict[ReferenceSource, str] = {
    "counter": "report-by-speedometer",
    "radar": "report-by-radar",
    "laser": "report-by-laser",
    "gps": "report-by-gps",
    "loop": "report-by-loop",
    "tape": "report-by-tape",
    "other": "report-other",
}
SOURCES = Called(_SOURCES_KEYS)
_CATEGORIES_KEYS: dict[Category, str] = {
    "hatchback": "report-hatchback",
    "saloon": "report-saloon",
    "estate": "report-estate",
    "suv": "report-suv",
    "multi_purpose": "report-multi-purpose",
    "pickup": "report-pickup",
    "van": "report-van",
    "lorry": "report-lorry",
    "tractor_unit": "report-tractor-unit",
    "bus": "report-bus",
    "recreational_vehicle": "report-recreational",
    "trailer": "report-trailer",
    "motorcycle": "report-motorcycle",
    "other": "report-other",
}
CATEGORIES = Called(_CATEGORIES_KEYS)
_LANES_KEYS: dict[Direction, str] = {"right": "report-to-the-right", "left": "report-to-the-left"}
LANES = Called(_LANES_KEYS)
_CLASS_SETS_KEYS: dict[ClassSet, str] = {
    "passenger_cars": "report-passenger-cars",
    "light_trucks": "report-light-trucks",
    "heavy": "report-heavy",
}
CLASS_SETS = Called(_CLASS_SETS_KEYS)
_GROUPINGS_KEYS: dict[str, str] = {
    "class_set": "report-by-class-set",
    "category": "report-by-category",
    "site": "report-by-site",
    "operator": "report-by-operator",
}
GROUPINGS = Called(_GROUPINGS_KEYS)
_STATES_KEYS: dict[str, str] = {
    "rejected": "report-rejected",
    "withdrawn": "report-withdrawn",
    "not_measurable": "report-not-measurable",
    "to_review": "report-to-review",
    "not_selected": "report-not-selected",
    "check_target": "report-check-target",
    "out_of_sample": "report-out-of-sample-state",
}
STATES = Called(_STATES_KEYS)


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


def apart(words: Sequence[str]) -> str:
    """Words or sentences with semicolons between, as the language writes them."""
    return reduce(lambda first, second: said("report-apart", first=first, second=second), words)


def date_words(day: date) -> str:
    """A day as the language writes it."""
    return said("report-date", **day_parts(day))


def day_parts(day: date) -> dict[str, str]:
    """Year, month and day, as sentences take them."""
    return {"year": f"{day.year:04d}", "month": f"{day.month:02d}", "day": f"{day.day:02d}"}


def selection_words(selection: Selection) -> str | None:
    """What a package or report is of: "low light; passenger cars, SUV"; None for the whole survey."""
    if selection.is_all:
        return None
    classes = [
        *(CLASS_SETS[one] for one in selection.class_sets),
        *(CATEGORIES[one] for one in selection.categories),
    ]
    lighting = [] if selection.lighting is None else [LIGHTING[selection.lighting]]
    days = (("report-filmed-since", selection.filmed_from), ("report-filmed-until", selection.filmed_to))
    filmed = [said(key, day=date_words(day)) for key, day in days if day is not None]
    if selection.hour_from is not None or selection.hour_to is not None:
        begins, ends = (f"{hour:02d}:00" for hour in (selection.hour_from or 0, selection.hour_to or 24))
        filmed.append(said("report-filmed-hours", begins=begins, ends=ends))
    return apart([*lighting, *([", ".join(classes)] if classes else []), *filmed])
