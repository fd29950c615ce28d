"""Which vehicles a package and its report are of: by lighting, sets of classes, classes, time of filming."""

from dataclasses import dataclass
from datetime import date
from typing import Any, get_args

from sightline.enums import Category, ClassSet, Lighting
from sightline.recordings.filming import FilmedWithin


@dataclass(frozen=True, slots=True)
class Selection(FilmedWithin):
    """Vehicles of one lighting, None for any, of any of these sets or classes, none named for all, and filmed
    within these days and hours.
    """

    lighting: Lighting | None = None
    class_sets: tuple[ClassSet, ...] = ()
    categories: tuple[Category, ...] = ()

    @property
    def of_classes(self) -> bool:
        """Whether classes are chosen."""
        return bool(self.class_sets or self.categories)

    @property
    def is_all(self) -> bool:
        return not (self.lighting or self.of_classes or self.limits_time)

    def is_of_kind(self, lighting: str, category: str, class_set: str) -> bool:
        """Whether a vehicle is of it, whenever it was filmed; what is not known of it is empty."""
        if self.lighting is not None and lighting != self.lighting:
            return False
        return not self.of_classes or class_set in self.class_sets or category in self.categories

    def stored(self) -> dict[str, Any]:
        """As a job, a row and the audit chain hold it."""
        return {
            "lighting": self.lighting,
            "class_sets": list(self.class_sets),
            "categories": list(self.categories),
            "filmed_from": _iso_date(self.filmed_from),
            "filmed_to": _iso_date(self.filmed_to),
            "hour_from": self.hour_from,
            "hour_to": self.hour_to,
        }


def _iso_date(day: date | None) -> str | None:
    return None if day is None else day.isoformat()


def _day(stored: date | str | None) -> date | None:
    return date.fromisoformat(stored) if isinstance(stored, str) else stored


def selection_of(stored: dict[str, Any]) -> Selection:
    """From what `stored` gave; each word once, in the usual order."""
    return Selection(
        lighting=stored.get("lighting"),
        class_sets=tuple(word for word in get_args(ClassSet) if word in stored.get("class_sets", ())),
        categories=tuple(word for word in get_args(Category) if word in stored.get("categories", ())),
        filmed_from=_day(stored.get("filmed_from")),
        filmed_to=_day(stored.get("filmed_to")),
        hour_from=stored.get("hour_from"),
        hour_to=stored.get("hour_to"),
    )
