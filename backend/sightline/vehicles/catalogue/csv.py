"""The catalogue as a table: the whole of it, to be imported again, and a survey's models in its package."""

from __future__ import annotations

import io
from collections.abc import Iterable
from typing import get_args

from sightline.enums import Category, ModelSize
from sightline.infra.csv_package.columns import integer, metres, text
from sightline.infra.csv_package.files import TableWriter
from sightline.infra.csv_package.schema import Column, Table
from sightline.vehicles.catalogue.records import SIZES, CatalogueEntry

_WORDS: dict[ModelSize, str] = {
    "height": "height of the roof",
    "length": "length",
    "width": "width without mirrors",
    "wheelbase": "wheelbase",
    "taillight": "height of the lower edge of the taillights",
    "headlight": "height of the lower edge of the headlights",
}


def _sizes() -> tuple[Column[CatalogueEntry], ...]:
    """Each size with its standard uncertainty and its source."""
    found: list[Column[CatalogueEntry]] = []
    for name in SIZES:
        said = _WORDS[name]
        found += [
            metres(f"{name}_m", said, lambda entry, name=name: entry.size(name)),  # type: ignore[misc]
            metres(
                f"u_{name}_m",
                f"standard uncertainty of the {said} (k = 1)",
                lambda entry, name=name: getattr(entry, f"u_{name}_m"),  # type: ignore[misc]
            ),
            text(
                f"{name}_source",
                f"where the {said} comes from, if not from `source`",
                lambda entry, name=name: getattr(entry, f"{name}_source"),  # type: ignore[misc]
            ),
        ]
    return tuple(found)


CATALOGUE: Table[CatalogueEntry] = Table(
    "catalogue",
    "The models of the catalogue that vehicles are of; the audit chain does not vouch for them.",
    (
        text("make", "manufacturer", lambda entry: entry.make, required=True),
        text("model", "model", lambda entry: entry.model, required=True),
        integer("year_from", "first model year", lambda entry: entry.year_from),
        integer("year_to", "last model year", lambda entry: entry.year_to),
        text("category", "kind of body", lambda entry: entry.category, enum=get_args(Category)),
        *_sizes(),
        text("source", "where its sizes come from", lambda entry: entry.source),
    ),
)


def catalogue_csv(entries: Iterable[CatalogueEntry]) -> bytes:
    """A file that an import reads again."""
    out = io.BytesIO()
    writer = TableWriter(out, CATALOGUE)
    for entry in entries:
        writer.add(entry)
    return out.getvalue()
