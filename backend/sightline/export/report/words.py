"""The words that figures and report call things by."""

from __future__ import annotations

from sightline.enums import Correction, StatisticsTarget, Target

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
CATEGORIES: dict[str, str] = {"suv": "SUV"}
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
    known = {"lighting": LIGHTING, "category": CATEGORIES}.get(grouping, {})
    return known.get(word, word)
