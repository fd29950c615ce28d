"""The catalogue as a table: the whole of it, to be imported again, and a survey's models in its package."""

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
    columns: list[Column[CatalogueEntry]] = []
    for name in SIZES:
        said = _WORDS[name]
        columns += [
            metres(f"{name}_m", said),
            metres(f"u_{name}_m", f"standard uncertainty of the {said} (k = 1)"),
            text(f"{name}_source", f"where the {said} comes from, if not from `source`"),
        ]
    return tuple(columns)


CATALOGUE: Table[CatalogueEntry] = Table(
    "catalogue",
    "The models of the catalogue that vehicles are of; the audit chain does not vouch for them.",
    (
        text("make", "manufacturer", required=True),
        text("model", "model", required=True),
        integer("year_from", "first model year"),
        integer("year_to", "last model year"),
        text("category", "body type", enum=get_args(Category)),
        *_sizes(),
        text("source", "where its sizes come from"),
    ),
)


def catalogue_csv(entries: Iterable[CatalogueEntry]) -> bytes:
    """A file that an import reads again."""
    out = io.BytesIO()
    writer = TableWriter(out, CATALOGUE)
    for entry in entries:
        writer.add(entry)
    return out.getvalue()
