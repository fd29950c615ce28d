"""Which vehicles a package and its report are of: by lighting, sets of classes, classes, days of filming."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import date
from typing import Any, get_args

from sightline.enums import Category, ClassSet, Lighting
from sightline.errors import BadInput


@dataclass(frozen=True, slots=True)
class Selection:
    """Vehicles of one lighting, None for any, of any of these sets or classes, none named for all, and filmed
    on these days, the last included, by the clocks of the place.
    """

    lighting: Lighting | None = None
    class_sets: tuple[ClassSet, ...] = ()
    categories: tuple[Category, ...] = ()
    filmed_from: date | None = None
    filmed_to: date | None = None

    @property
    def is_all(self) -> bool:
        limits = (self.lighting, self.class_sets, self.categories, self.filmed_from, self.filmed_to)
        return not any(limits)

    def holds(self, lighting: str, category: str, class_set: str, filmed_at: str) -> bool:
        """Whether a vehicle is of it; what is not known of it is empty."""
        if self.lighting is not None and lighting != self.lighting:
            return False
        if (self.filmed_from or self.filmed_to) and not self._filmed(filmed_at[:10]):
            return False
        if not self.class_sets and not self.categories:
            return True
        return class_set in self.class_sets or category in self.categories

    def _filmed(self, day: str) -> bool:
        first, last = (one and one.isoformat() for one in (self.filmed_from, self.filmed_to))
        return bool(day) and (first or day) <= day <= (last or day)

    def stored(self) -> dict[str, Any]:
        """As a job, a row and the audit chain hold it."""
        return {
            "lighting": self.lighting,
            "class_sets": list(self.class_sets),
            "categories": list(self.categories),
            "filmed_from": _text(self.filmed_from),
            "filmed_to": _text(self.filmed_to),
        }


def require_days(selection: Selection) -> None:
    """Raise BadInput where its last day lies before its first: nothing would count, without a word."""
    if selection.filmed_from and selection.filmed_to and selection.filmed_to < selection.filmed_from:
        raise BadInput("results-last-day-lies-before-first-exchange")


def _text(day: date | None) -> str | None:
    return None if day is None else day.isoformat()


def _day(stored: date | str | None) -> date | None:
    return date.fromisoformat(stored) if isinstance(stored, str) else stored


def selection_of(stored: dict[str, Any]) -> Selection:
    """From what `stored` gave; each word once, in the usual order."""
    return Selection(
        stored.get("lighting"),
        tuple(word for word in get_args(ClassSet) if word in stored.get("class_sets", ())),
        tuple(word for word in get_args(Category) if word in stored.get("categories", ())),
        _day(stored.get("filmed_from")),
        _day(stored.get("filmed_to")),
    )
