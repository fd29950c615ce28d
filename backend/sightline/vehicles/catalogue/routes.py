"""The catalogue of models: completing what is typed, one more model, or a whole CSV."""

from typing import Annotated

from fastapi import APIRouter, File, Query, UploadFile
from pydantic import Field

from sightline.enums import Category
from sightline.infra.web.bodies import Finite, In, Out, Text
from sightline.infra.web.deps import Operator, Reading, Viewer, Wired, Writing
from sightline.vehicles.catalogue import store
from sightline.vehicles.catalogue.import_csv import MOST_BYTES, import_csv
from sightline.vehicles.catalogue.records import CatalogueRow

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


class EntryBody(Out):
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


class SkippedBody(Out):
    line: int
    reason: str


class ImportedBody(Out):
    added: int
    updated: int
    skipped: list[SkippedBody]


@router.get("/catalogue")
def search_catalogue(
    who: Viewer,
    session: Reading,
    q: Annotated[str, Query(max_length=200, description="Beginnings of words: “corv li”.")] = "",
) -> list[EntryBody]:
    """At most 20 models of which every word typed begins a word."""
    return [EntryBody.model_validate(entry) for entry in store.search_catalogue(session, q)]


@router.post("/catalogue", status_code=201)
def add_to_catalogue(body: NewEntry, who: Operator, session: Writing) -> EntryBody:
    """One more model."""
    return EntryBody.model_validate(
        store.add_catalogue_row(session, CatalogueRow(**body.model_dump()), actor=who.id)
    )


@router.post("/catalogue/import")
def import_catalogue(
    who: Operator, services: Wired, file: Annotated[UploadFile, File(description="CSV in UTF-8.")]
) -> ImportedBody:
    """The rows of a CSV; those that cannot be used are named with their reason, the others are stored."""
    data = file.file.read(MOST_BYTES + 1)
    with services.writing() as session:
        found = import_csv(session, data, file.filename or "The file", actor=who.id)
    return ImportedBody.model_validate(found)
