"""The catalogue of models: completing what is typed, one more model, or a whole CSV."""

from typing import Annotated

from fastapi import APIRouter, File, Query, UploadFile
from pydantic import Field

from sightline.enums import Category
from sightline.infra.web.bodies import Finite, In, Text
from sightline.infra.web.deps import Operator, Reading, Viewer, Wired, Writing
from sightline.vehicles.catalogue import store
from sightline.vehicles.catalogue.import_csv import MOST_BYTES, Imported, import_csv
from sightline.vehicles.catalogue.records import CatalogueEntry, CatalogueRow

router = APIRouter()

Metres = Annotated[Finite, Field(gt=0.1, lt=30)]
Year = Annotated[int, Field(ge=1885, le=2100)]


class NewEntry(In):
    make: Annotated[str, Field(min_length=1, max_length=100)]
    model: Annotated[str, Field(min_length=1, max_length=200)]
    year_from: Year | None = None
    year_to: Year | None = None
    category: Category | None = None
    height_m: Metres | None = None
    length_m: Metres | None = None
    width_m: Metres | None = None
    wheelbase_m: Metres | None = None
    source: Text = ""


@router.get("/catalogue")
def search_catalogue(
    who: Viewer,
    session: Reading,
    q: Annotated[str, Query(max_length=200, description="Beginnings of words: “corv li”.")] = "",
) -> tuple[CatalogueEntry, ...]:
    """At most 20 models of which every word typed begins a word."""
    return store.search_catalogue(session, q)


@router.post("/catalogue", status_code=201)
def add_to_catalogue(body: NewEntry, who: Operator, session: Writing) -> CatalogueEntry:
    """One more model."""
    return store.add_catalogue_row(session, CatalogueRow(**body.model_dump()), actor=who.id)


@router.post("/catalogue/import")
def import_catalogue(
    who: Operator, services: Wired, file: Annotated[UploadFile, File(description="CSV in UTF-8.")]
) -> Imported:
    """The rows of a CSV; those that cannot be used are named with their reason, the others are stored."""
    data = file.file.read(MOST_BYTES + 1)
    with services.writing() as session:
        return import_csv(session, data, file.filename or "The file", actor=who.id)
