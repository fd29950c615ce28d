"""The frame table and its pictures: stills, lossless crops, thumbnails; immutable and checked."""

from collections.abc import Callable
from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query, Request, Response

from sightline.enums import Display
from sightline.infra.services import Services
from sightline.infra.web.bodies import Out
from sightline.infra.web.deps import PathFrame, PathId, Viewer, Wired
from sightline.infra.web.disconnect import CancelCheck, run_unless_cancelled
from sightline.infra.web.pictures import JPEG, PNG, answer_not_modified, is_held, jpeg_once, picture_response
from sightline.recordings.frames.stills import Still, stills_of
from sightline.recordings.ingest_job import thumbnail

router = APIRouter()

MOST_ROWS = 20_000
Side = Annotated[int, Query(ge=1, le=4096)]
Shown = Annotated[Display, Query(description="bright: to look at only, never measured on.")]
Place = Annotated[int, Query(ge=-100_000, le=100_000)]


class ReadyFrames(Out):
    """Runs of frames, [first, last], that are answered without decoding."""

    runs: list[tuple[int, int]]


class FrameRows(Out):
    """Frames `first`, `first + 1`, ...: columns of equal length."""

    first: int
    pts: list[int]
    time_s: list[float]
    crc: list[int]
    key: list[bool]


@router.get("/recordings/{recording_id}/frames")
def frame_table(
    recording_id: PathId,
    who: Viewer,
    services: Wired,
    first: Annotated[int, Query(ge=0, le=2**31 - 1)] = 0,
    count: Annotated[int, Query(ge=1, le=MOST_ROWS)] = 5000,
) -> FrameRows:
    """A piece of the frame table; empty behind its end."""
    opened = stills_of(services).open(recording_id)
    span = slice(first, first + count)
    return FrameRows(
        first=first,
        pts=opened.media.pts[span].tolist(),
        time_s=np.round(opened.time_s[span], 9).tolist(),
        crc=opened.media.crc[span].tolist(),
        key=opened.media.key[span].tolist(),
    )


@router.get("/recordings/{recording_id}/frames/ready")
def ready_frames(recording_id: PathId, who: Viewer, services: Wired) -> ReadyFrames:
    """What is loaded on the server, for the timeline."""
    return ReadyFrames(runs=stills_of(services).ready(recording_id))


@router.get("/recordings/{recording_id}/frames/{n}.jpg", response_class=Response, responses=JPEG)
async def still(
    recording_id: PathId,
    n: PathFrame,
    who: Viewer,
    services: Wired,
    request: Request,
    display: Shown = "plain",
) -> Response:
    """Frame n as JPEG; what the browser has of it is confirmed (304) without decoding anything."""

    def still(wanted: CancelCheck) -> Still:
        stills_of(services).announce_request(recording_id, n)
        return stills_of(services).still(recording_id, n, display, wanted)

    return await _answer_picture(request, services, recording_id, n, _display(display), "image/jpeg", still)


@router.get("/recordings/{recording_id}/frames/{n}/crop.png", response_class=Response, responses=PNG)
async def crop(
    recording_id: PathId,
    n: PathFrame,
    x: Place,
    y: Place,
    w: Side,
    h: Side,
    who: Viewer,
    services: Wired,
    request: Request,
    display: Shown = "plain",
) -> Response:
    """A rectangle of frame n, lossless; black where it reaches out of the picture."""

    def cut(wanted: CancelCheck) -> Still:
        return stills_of(services).crop(recording_id, n, (x, y, w, h), display, wanted)

    kind = f"-{x}.{y}.{w}.{h}{_display(display)}"
    return await _answer_picture(request, services, recording_id, n, kind, "image/png", cut)


def _display(display: Display) -> str:
    return "" if display == "plain" else f"-{display}"


async def _answer_picture(
    request: Request,
    services: Services,
    recording_id: int,
    n: int,
    kind: str,
    media_type: str,
    make: Callable[[CancelCheck], Still],
) -> Response:
    """A picture of frame n, of some kind; what the browser has of it is confirmed without decoding."""

    def work(wanted: CancelCheck) -> Response:
        etag = f'"{stills_of(services).crc(recording_id, n):08x}{kind}"'
        return (
            answer_not_modified(etag) if is_held(request, etag) else picture(make(wanted), media_type, etag)
        )

    return await run_unless_cancelled(request, work)


@router.get("/recordings/{recording_id}/thumbs/{frame}.jpg", response_class=Response, responses=JPEG)
def thumb(recording_id: PathId, frame: PathFrame, who: Viewer, services: Wired, request: Request) -> Response:
    """The thumbnail of a frame that has one."""
    etag = f'"t{stills_of(services).crc(recording_id, frame):08x}"'
    return jpeg_once(request, etag, lambda: thumbnail(services, recording_id, frame))


def picture(still: Still, media_type: str, etag: str) -> Response:
    """A still as it goes out, with the identity of its frame."""
    identity = {"Sightline-Frame": str(still.n), "Sightline-Pts": str(still.pts)}
    return picture_response(still.content, media_type, etag, identity)
