"""Rows of the catalogue, and what an import finds in a file and does with it."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, get_args

from pydantic import Field

from sightline.enums import CatalogueChange, Category, ModelSize, SizeUnit
from sightline.messages.said import Said

SIZES: tuple[ModelSize, ...] = get_args(ModelSize)


@dataclass(frozen=True, slots=True)
class CatalogueRow:
    """One model as it comes in; None where unknown. Heights of lamps are those of their lower edges.

    `source`: where the sizes come from, unless a size has a source of its own.
    """

    make: str
    model: str
    year_from: int | None = None
    year_to: int | None = None
    category: Category | None = None
    height_m: float | None = None
    length_m: float | None = None
    width_m: float | None = None
    wheelbase_m: float | None = None
    taillight_m: float | None = None
    headlight_m: float | None = None
    u_height_m: float | None = None
    u_length_m: float | None = None
    u_width_m: float | None = None
    u_wheelbase_m: float | None = None
    u_taillight_m: float | None = None
    u_headlight_m: float | None = None
    height_source: str | None = None
    length_source: str | None = None
    width_source: str | None = None
    wheelbase_source: str | None = None
    taillight_source: str | None = None
    headlight_source: str | None = None
    source: str = ""

    def size(self, name: ModelSize) -> float | None:
        """Metres."""
        value: float | None = getattr(self, f"{name}_m")
        return value

    def built_in(self, year: int | None) -> bool:
        """Whether it may have been built in this year; None: unknown, so it may."""
        return year is None or (self.year_from or year) <= year <= (self.year_to or year)

    def source_of(self, name: ModelSize) -> str:
        """Where a size comes from."""
        own: str | None = getattr(self, f"{name}_source")
        return own or self.source


@dataclass(frozen=True, slots=True)
class CatalogueEntry(CatalogueRow):
    """A stored model; `retired_at`: no longer offered, kept for what it was used for."""

    id: int = 0
    version: int = 1
    retired_at: datetime | None = None


@dataclass(frozen=True, slots=True)
class CataloguePage:
    total: int
    entries: tuple[CatalogueEntry, ...]


@dataclass(frozen=True, slots=True)
class CatalogueImport:
    added: int
    updated: int


@dataclass(frozen=True)
class ImportColumn:
    """A column of a file and what it is taken for; field None: left out."""

    header: str
    field: str | None
    unit: Annotated[SizeUnit | None, Field(description="Of a size or its uncertainty.")]
    problem: Annotated[Said | None, Field(description="Why its unit is doubtful.")]


@dataclass(frozen=True)
class ImportRow:
    """What an import does with one line, and why."""

    line: int
    make: str
    model: str
    year_from: int | None
    change: CatalogueChange
    words: Said | None


@dataclass(frozen=True)
class ImportPlan:
    """What an import would do: nothing is stored yet. `rows`: those to look at, the first of many."""

    columns: tuple[ImportColumn, ...]
    counts: dict[CatalogueChange, int]
    rows: tuple[ImportRow, ...]
    stored: Annotated[int, Field(description="How many models would be added or changed.")]
    problem: Annotated[Said | None, Field(description="Why nothing of the file can be stored as it is.")]


@dataclass(frozen=True)
class Imported(CatalogueImport):
    """What came of an import."""

    plan: ImportPlan
