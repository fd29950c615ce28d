"""The catalogue of models: completing what is typed, correcting and retiring, a CSV in and out."""

from typing import Annotated

from fastapi import APIRouter, Depends, File, Query, Response, UploadFile
from pydantic import Field

from sightline.enums import OnConflict, SizeUnit
from sightline.infra.web.bodies import Finite, In, Text, of_record
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, Writing
from sightline.infra.web.uploaded import whole_file
from sightline.vehicles.catalogue import store
from sightline.vehicles.catalogue.csv import catalogue_csv
from sightline.vehicles.catalogue.import_csv import (
    MOST_BYTES,
    Choices,
    columns_chosen,
    import_csv,
    plan_import,
)
from sightline.vehicles.catalogue.records import (
    CatalogueEntry,
    CataloguePage,
    CatalogueRow,
    Imported,
    ImportPlan,
)

router = APIRouter()

Year = Annotated[int, Field(ge=1885, le=2100)]
Source = Annotated[str, Field(max_length=1000)]
Sent = Annotated[UploadFile, File(description="CSV in UTF-8.")]
Column = Annotated[
    list[str],
    Query(max_length=100, description="field=header: what a column is taken for; =header leaves it out."),
]
Conflicting = Annotated[OnConflict, Query(description="What becomes of sizes that differ.")]
Unit = Annotated[SizeUnit | None, Query(description="Of sizes whose column names none, or metres.")]


_LOWER_EDGE = Annotated[Finite, Field(description="Of the lower edge.")]
_GIVEN = {"year_*": Year, "u_*": Finite, "*light_m": _LOWER_EDGE, "*_m": Finite, "*_source": Source}


@of_record(CatalogueRow, given=_GIVEN, optional=True)
class ModelIn(In):
    make: Annotated[str, Field(min_length=1, max_length=store.MOST_MAKE)]
    model: Annotated[str, Field(min_length=1, max_length=store.MOST_MODEL)]
    source: Text = ""


class CorrectedModel(ModelIn):
    version: Annotated[int, Field(ge=1, le=2**31 - 1)]


class Retired(In):
    version: Annotated[int, Field(ge=1, le=2**31 - 1)]
    retired: bool


@router.get("/catalogue")
def search_catalogue(
    who: Viewer,
    session: Reading,
    q: Annotated[str, Query(max_length=200, description="Beginnings of words: “corv li”.")] = "",
) -> tuple[CatalogueEntry, ...]:
    """At most 20 models of which every word typed begins a word; none that is retired."""
    return store.search_catalogue(session, q)


@router.get("/catalogue/page")
def page_of_catalogue(
    who: Viewer,
    session: Reading,
    q: Annotated[str, Query(max_length=200)] = "",
    retired: bool = False,
    offset: Annotated[int, Query(ge=0, le=10_000_000)] = 0,
) -> CataloguePage:
    """50 models from an offset, and how many there are."""
    return store.page_of_catalogue(session, q, retired=retired, offset=offset)


@router.get("/catalogue/export", response_class=Response)
def export_catalogue(who: Viewer, session: Reading) -> Response:
    """The whole catalogue as CSV, without retired models."""
    content = catalogue_csv(store.all_of_catalogue(session))
    headers = {"Content-Disposition": 'attachment; filename="sightline-catalogue.csv"'}
    return Response(content, media_type="text/csv; charset=utf-8", headers=headers)


@router.post("/catalogue", status_code=201)
def add_to_catalogue(body: ModelIn, who: Operator, session: Writing) -> CatalogueEntry:
    """One more model."""
    return store.add_catalogue_row(session, CatalogueRow(**body.model_dump()), actor=who.id)


@router.put("/catalogue/{entry_id}")
def correct_model(entry_id: PathId, body: CorrectedModel, who: Operator, session: Writing) -> CatalogueEntry:
    """Other values in a model's place."""
    row = CatalogueRow(**body.model_dump(exclude={"version"}))
    return store.correct_catalogue_row(session, entry_id, row, version=body.version, actor=who.id)


@router.post("/catalogue/{entry_id}/retire")
def retire_model(entry_id: PathId, body: Retired, who: Operator, session: Writing) -> CatalogueEntry:
    """No longer offer a model, or offer it again."""
    return store.retire_catalogue_row(
        session, entry_id, version=body.version, retired=body.retired, actor=who.id
    )


def _read_sent_file(
    file: Sent,
    column: Column = [],  # noqa: B006
    unit: Unit = None,
    on_conflict: Conflicting = "keep",
) -> tuple[bytes, str, Choices]:
    name = file.filename or "The file"
    return whole_file(file, MOST_BYTES, name), name, Choices(columns_chosen(column), unit, on_conflict)


#: A file's content, its name, and how it is read.
Given = Annotated[tuple[bytes, str, Choices], Depends(_read_sent_file)]


@router.post("/catalogue/import/preview")
def preview_catalogue_import(who: Operator, services: Wired, given: Given) -> ImportPlan:
    """What an import of this file would do; nothing is stored."""
    with services.reading() as session:
        return plan_import(session, *given)


@router.post("/catalogue/import")
def import_catalogue(who: Operator, services: Wired, given: Given) -> Imported:
    """The rows of a CSV; those that cannot be used are named with their reason, the others are stored."""
    with services.writing() as session:
        return import_csv(session, *given, actor=who.id)
