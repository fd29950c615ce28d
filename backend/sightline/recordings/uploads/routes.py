"""Resumable uploads: tus 1.0 (tus.io/protocols/resumable-upload), creation and termination."""

import asyncio
import base64
import binascii
import time
from collections.abc import AsyncGenerator, AsyncIterator, Callable, Iterator
from contextlib import aclosing
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

import anyio.from_thread
import anyio.to_thread
from fastapi import APIRouter, Depends, Header, Request, Response
from starlette.requests import ClientDisconnect

from sightline.enums import UploadPurpose
from sightline.errors import BadInput, SightlineError
from sightline.infra.by_name import filled_from
from sightline.infra.services import Services
from sightline.infra.web.deps import OPEN, PathId, Uploader, Viewer, Wired, require_uploader_still
from sightline.infra.web.uploaded import clean_name
from sightline.recordings.uploads import service, store
from sightline.recordings.uploads.records import Upload

router = APIRouter()

VERSION = "1.0.0"
MAX_BYTES = 2**40
PIECE_BYTES = 1 << 20
#: so long nothing comes until that is said: a newer connection may have taken over
QUIET_S = 0.5
#: how often it is asked whether the person may still send, while bytes come
ASK_AGAIN_S = 2.0
CONTENT_TYPE = "application/offset+octet-stream"


class UnsupportedTusVersion(SightlineError):
    status = 412
    kind = "tus_version"


class UnsupportedMediaType(SightlineError):
    status = 415
    kind = "content_type"


@dataclass(frozen=True, slots=True, kw_only=True)
class UploadBody:
    """An upload that can go on; `mine`: announced by who asks."""

    id: int
    survey_id: int
    filename: str
    size_bytes: int
    offset: int
    purpose: UploadPurpose
    created_at: datetime
    mine: bool


def require_tus_version(tus_resumable: Annotated[str | None, Header()] = None) -> None:
    """Refuse another version of the protocol, as it asks."""
    if tus_resumable != VERSION:
        raise UnsupportedTusVersion("recordings-tus-version")


SPEAKS = Depends(require_tus_version)


@router.options("/uploads", status_code=204, dependencies=[OPEN])
async def upload_abilities() -> Response:
    """What this tus server can do."""
    told = {"Tus-Version": VERSION, "Tus-Extension": "creation,termination", "Tus-Max-Size": str(MAX_BYTES)}
    return Response(status_code=204, headers={"Tus-Resumable": VERSION, **told})


@router.get("/surveys/{survey_id}/uploads")
def list_uploads(survey_id: PathId, who: Viewer, services: Wired) -> list[UploadBody]:
    """Uploads that can go on."""
    under_way = service.uploads_under_way(services, survey_id)
    return [
        filled_from(
            UploadBody, one, offset=arrived, mine=one.created_by is not None and one.created_by.id == who.id
        )
        for one, arrived in under_way
    ]


@router.post("/surveys/{survey_id}/uploads", status_code=201, response_class=Response, dependencies=[SPEAKS])
def create_upload(
    survey_id: PathId,
    who: Uploader,
    services: Wired,
    upload_length: Annotated[int | None, Header(ge=0, le=MAX_BYTES)] = None,
    upload_metadata: Annotated[str | None, Header(max_length=4000)] = None,
) -> Response:
    """Announce a file by its length and name; the answer's Location takes its bytes.

    With the metadata `purpose` = `strip` it becomes no recording but waits for a line-scan recording.
    """
    if upload_length is None:
        raise BadInput("recordings-upload-without-length")
    filename, purpose = filename_of(upload_metadata), purpose_of(upload_metadata)
    upload = service.begin_upload(services, survey_id, filename, upload_length, who.id, purpose=purpose)
    headers = {"Location": f"/api/uploads/{upload.id}", "Tus-Resumable": VERSION, "Upload-Offset": "0"}
    return Response(status_code=201, headers=headers)


@router.head("/uploads/{upload_id}", response_class=Response, dependencies=[SPEAKS])
def upload_offset(upload_id: PathId, who: Uploader, services: Wired) -> Response:
    """How far the upload has come; `Sightline-Finished: 1` once it is a recording or a waiting strip.

    One whose bytes are all here but that is not finished is finished by an empty PATCH behind its last byte.
    """
    upload = _upload(services, upload_id)
    offset = service.upload_arrived(services, upload)
    headers = {"Upload-Length": str(upload.size_bytes), "Cache-Control": "no-store"}
    if upload.finished_at is not None:
        headers["Sightline-Finished"] = "1"
    return Response(status_code=200, headers={**_progress(offset, upload.recording_id), **headers})


@router.patch("/uploads/{upload_id}", status_code=204, dependencies=[SPEAKS])
async def continue_upload(
    upload_id: PathId,
    who: Uploader,
    services: Wired,
    request: Request,
    upload_offset: Annotated[int, Header(ge=0, le=MAX_BYTES)],
) -> Response:
    """Bytes behind `Upload-Offset`. The request that brings the last one answers `Sightline-Recording`."""
    if request.headers.get("content-type") != CONTENT_TYPE:
        raise UnsupportedMediaType("recordings-upload-content-type")
    upload = await anyio.to_thread.run_sync(_upload, services, upload_id)
    pieces = _pieces(request)

    def still_allowed() -> None:
        require_uploader_still(request)

    def take() -> tuple[int, int | None]:
        allowed = _while_allowed(_in_thread(pieces), still_allowed)
        at = service.take_bytes(services, upload, upload_offset, allowed)
        is_whole = at == upload.size_bytes
        return at, service.upload_arrived_whole(services, upload, who.id) if is_whole else None

    try:
        offset, recording_id = await anyio.to_thread.run_sync(take)
    except ClientDisconnect:
        # Nobody hears this answer; what arrived is kept, and the client asks for the offset when it is back.
        return Response(status_code=204, headers={"Tus-Resumable": VERSION})
    finally:
        await pieces.aclose()
    return Response(status_code=204, headers=_progress(offset, recording_id))


@router.delete("/uploads/{upload_id}", status_code=204, dependencies=[SPEAKS])
def give_up_upload(upload_id: PathId, who: Uploader, services: Wired) -> Response:
    """Forget an unfinished upload and what has arrived of it."""
    service.abandon_upload(services, upload_id, who.id)
    return Response(status_code=204, headers={"Tus-Resumable": VERSION})


def _upload(services: Services, upload_id: int) -> Upload:
    with services.reading() as session:
        return store.get_upload(session, upload_id)


def _progress(offset: int, recording_id: int | None) -> dict[str, str]:
    headers = {"Tus-Resumable": VERSION, "Upload-Offset": str(offset)}
    if recording_id is not None:
        headers["Sightline-Recording"] = str(recording_id)
    return headers


async def _pieces(request: Request) -> AsyncGenerator[bytes]:
    """The body in pieces of about a megabyte, the rest of it also if the line breaks; b"" in silence."""
    gathered = bytearray()
    try:
        async with aclosing(_with_silence(request.stream())) as chunks:
            async for chunk in chunks:
                gathered += chunk
                if not chunk:
                    yield b""
                elif len(gathered) >= PIECE_BYTES:
                    yield bytes(gathered)
                    gathered.clear()
    except ClientDisconnect:
        if gathered:
            yield bytes(gathered)
        raise
    if gathered:
        yield bytes(gathered)


async def _with_silence(chunks: AsyncIterator[bytes]) -> AsyncGenerator[bytes]:
    """The chunks that are not empty, and an empty one whenever none came for a while."""
    coming: asyncio.Task[bytes | None] | None = None
    try:
        while True:
            coming = coming or asyncio.create_task(_next(chunks))
            if not (await asyncio.wait({coming}, timeout=QUIET_S))[0]:
                yield b""
                continue
            chunk, coming = coming.result(), None
            if chunk is None:
                return
            if chunk:
                yield chunk
    finally:
        if coming is not None:
            coming.cancel()


def _while_allowed(pieces: Iterator[bytes], still_allowed: Callable[[], None]) -> Iterator[bytes]:
    """The pieces as long as the person may send them: asked every few seconds, and behind the last one."""
    asked = time.monotonic()
    for piece in pieces:
        if time.monotonic() - asked >= ASK_AGAIN_S:
            still_allowed()
            asked = time.monotonic()
        yield piece
    still_allowed()


def _in_thread(pieces: AsyncIterator[bytes]) -> Iterator[bytes]:
    """The same pieces for a worker thread."""
    while True:
        piece = anyio.from_thread.run(_next, pieces)
        if piece is None:
            return
        yield piece


async def _next(pieces: AsyncIterator[bytes]) -> bytes | None:
    return await anext(pieces, None)


def filename_of(metadata: str | None) -> str:
    """The file name in tus's Upload-Metadata ("key base64,key base64"). Raises BadInput."""
    name = _metadata_value(metadata, "filename", "file name")
    if name is None:
        raise BadInput("recordings-upload-without-name")
    return clean_name(name)


def purpose_of(metadata: str | None) -> UploadPurpose:
    """What the file is for: a video unless it is said to be a strip. Raises BadInput."""
    told = _metadata_value(metadata, "purpose", "purpose")
    if told not in (None, "video", "strip"):
        raise BadInput("recordings-upload-purpose")
    return "strip" if told == "strip" else "video"


def _metadata_value(metadata: str | None, wanted: str, word: str) -> str | None:
    for pair in (metadata or "").split(","):
        key, _, value = pair.strip().partition(" ")
        if key != wanted:
            continue
        try:
            return base64.b64decode(value, validate=True).decode("utf-8")
        except (binascii.Error, UnicodeDecodeError) as error:
            raise BadInput("recordings-upload-metadata", word=word) from error
    return None
