"""Rows of the catalogue, and what an import of them did."""

from dataclasses import dataclass

from sightline.enums import (
    Category,
)


@dataclass(frozen=True, slots=True)
class CatalogueRow:
    """One model as it comes in; lengths in metres, None where unknown."""

    make: str
    model: str
    year_from: int | None = None
    year_to: int | None = None
    category: Category | None = None
    height_m: float | None = None
    length_m: float | None = None
    width_m: float | None = None
    wheelbase_m: float | None = None
    source: str = ""


@dataclass(frozen=True, slots=True)
class CatalogueEntry:
    id: int
    make: str
    model: str
    year_from: int | None
    year_to: int | None
    category: Category | None
    height_m: float | None
    length_m: float | None
    width_m: float | None
    wheelbase_m: float | None
    source: str


@dataclass(frozen=True, slots=True)
class CatalogueImport:
    added: int
    updated: int
