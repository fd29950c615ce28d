"""Which vehicles a package and its report are of: by lighting, by sets of classes, by classes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, get_args

from sightline.enums import Category, ClassSet, Lighting


@dataclass(frozen=True, slots=True)
class Selection:
    """Vehicles of one lighting, None for any, and of any of these sets or classes, none named for all."""

    lighting: Lighting | None = None
    class_sets: tuple[ClassSet, ...] = ()
    categories: tuple[Category, ...] = ()

    @property
    def is_all(self) -> bool:
        return not (self.lighting or self.class_sets or self.categories)

    def holds(self, lighting: str, category: str, class_set: str) -> bool:
        """Whether a vehicle is of it; its lighting, class and set are empty where they are not known."""
        if self.lighting is not None and lighting != self.lighting:
            return False
        if not self.class_sets and not self.categories:
            return True
        return class_set in self.class_sets or category in self.categories

    def stored(self) -> dict[str, Any]:
        """As a job, a row and the audit chain hold it."""
        return {
            "lighting": self.lighting,
            "class_sets": list(self.class_sets),
            "categories": list(self.categories),
        }


def selection_of(stored: dict[str, Any]) -> Selection:
    """From what `stored` gave; each word once, in the usual order."""
    return Selection(
        stored.get("lighting"),
        tuple(word for word in get_args(ClassSet) if word in stored.get("class_sets", ())),
        tuple(word for word in get_args(Category) if word in stored.get("categories", ())),
    )
