"""Photographs of a survey's set-up: added, captioned, put in order, taken out and brought back."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Form, Query, Response, UploadFile
from pydantic import Field

from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import In
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, Writing
from sightline.infra.web.named import PhotographId
from sightline.infra.web.pictures import PHOTOGRAPH
from sightline.infra.web.uploaded import clean_name, whole_file
from sightline.surveys.photographs import service, store
from sightline.surveys.photographs.records import Photograph, PhotographFacts
from sightline.surveys.photographs.store import MOST_CAPTION, MOST_PHOTOGRAPHS

router = APIRouter()

MOST_BYTES = 64_000_000
Caption = Annotated[str, Field(max_length=MOST_CAPTION)]
Version = Annotated[int, Field(ge=1, le=2**31 - 1)]


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotographBody(PhotographFacts):
    """A photograph with the address of its picture."""

    url: str


class CaptionIn(In):
    caption: Caption
    version: Version


class OrderIn(In):
    ids: list[PhotographId] = Field(
        max_length=MOST_PHOTOGRAPHS, description="Every photograph once, first one first."
    )


def body_of(one: Photograph) -> PhotographBody:
    """A photograph as it goes out, with its address."""
    return filled_from(PhotographBody, one, url=f"/api/photographs/{one.id}.jpg")


@router.get("/surveys/{survey_id}/photographs")
def list_photographs(survey_id: PathId, who: Viewer, session: Reading) -> list[PhotographBody]:
    """The photographs of the set-up in their order."""
    return [body_of(one) for one in store.list_photographs(session, survey_id)]


@router.post("/surveys/{survey_id}/photographs", status_code=201)
def add_photograph(
    survey_id: PathId,
    file: UploadFile,
    who: Operator,
    services: Wired,
    caption: Annotated[str, Form(max_length=MOST_CAPTION)] = "",
) -> PhotographBody:
    """A JPEG, PNG, WebP or TIFF file; kept as a JPEG of at most 1600 pixels a side, without its metadata."""
    name = clean_name(file.filename or "photograph")
    content = whole_file(file, MOST_BYTES, name)
    return body_of(
        service.store_photograph(services, survey_id, name, content, caption.replace("\x00", ""), who.id)
    )


@router.put("/surveys/{survey_id}/photographs/order")
def order_photographs(
    survey_id: PathId, body: OrderIn, who: Operator, session: Writing
) -> list[PhotographBody]:
    """Put the photographs into this order, on the page, in the package and in the report."""
    return [body_of(one) for one in store.order_photographs(session, survey_id, body.ids, actor=who.id)]


@router.put("/photographs/{photograph_id}")
def caption_photograph(
    photograph_id: PathId, body: CaptionIn, who: Operator, session: Writing
) -> PhotographBody:
    """Another caption."""
    made = store.change_photograph_caption(
        session, photograph_id, body.caption, version=body.version, actor=who.id
    )
    return body_of(made)


@router.delete("/photographs/{photograph_id}", status_code=204)
def remove_photograph(
    photograph_id: PathId, who: Operator, session: Writing, version: Annotated[Version, Query()]
) -> None:
    """Take a photograph out; it can be brought back."""
    store.remove_photograph(session, photograph_id, version=version, actor=who.id)


@router.post("/photographs/{photograph_id}/restore")
def restore_photograph(photograph_id: PathId, who: Operator, session: Writing) -> PhotographBody:
    """Bring a photograph back that was taken out."""
    return body_of(store.restore_photograph(session, photograph_id, actor=who.id))


@router.get("/photographs/{photograph_id}.jpg", response_class=Response, responses=PHOTOGRAPH)
def photograph_file(photograph_id: PathId, who: Viewer, services: Wired) -> Response:
    """The photograph as JPEG, which no browser keeps."""
    with services.reading() as session:
        one = store.get_photograph(session, photograph_id)
    return Response(service.photograph_content(services, one), media_type="image/jpeg")
