"""From an upload to a recording: bytes are gathered, stored once, and an ingest is queued.

A kill at any point loses nothing. The length of the part on disk is the truth about how far an upload is.
Everything after the last byte can be done again: the media store keeps one file per content, and the
recording, the end of the upload and the ingest job are one transaction.
"""

import logging
from collections.abc import Iterable
from datetime import timedelta
from pathlib import Path

from sightline.enums import UploadPurpose
from sightline.errors import Conflict, NoRoom, NotFound, SightlineError, TooMany
from sightline.infra.database import Session
from sightline.infra.database.types import now
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go, store_file, suffix_of
from sightline.media.store import upload_parts
from sightline.media.store.local import free_bytes, key_of
from sightline.recordings.ingest_job import queue_ingest
from sightline.recordings.store import create_recording, get_recording
from sightline.recordings.uploads.records import Upload
from sightline.recordings.uploads.store import (
    create_upload,
    finish_upload,
    get_upload,
    remove_upload,
    strip_arrived,
    unfinished_uploads,
)

log = logging.getLogger(__name__)

GIVEN_UP_S = 7 * 24 * 3600.0
#: one that was announced and of which no byte came, or whose bytes are gone (a restored database has none)
NEVER_CAME_S = 24 * 3600.0
#: of one person at a time, unfinished
MOST_ANNOUNCED = 200


def upload_folder(services: Services) -> Path:
    """Where parts are gathered."""
    return services.settings.uploads_dir


def begin_upload(
    services: Services,
    survey_id: int,
    filename: str,
    size_bytes: int,
    actor: int,
    *,
    purpose: UploadPurpose = "video",
) -> Upload:
    """Announce a file. Raises, before any byte is sent: NotFound, BadInput (empty), NoRoom, TooMany."""
    try:
        with services.reading() as session:
            _require_room_beside(services, session, size_bytes, actor)
    except (NoRoom, TooMany):
        give_up_uploads(services, maker=actor)
    with services.writing() as session:
        _require_room_beside(services, session, size_bytes, actor)
        upload = create_upload(
            session,
            survey_id,
            filename=filename,
            size_bytes=size_bytes,
            media_key="",
            purpose=purpose,
            actor=actor,
        )
        # What lies under this number is no upload's: a commit failed, or the database was put back.
        upload_parts.discard(upload_folder(services), part_name(upload.id))
        # Inside the transaction: no room for the part, no row either.
        upload_parts.create(upload_folder(services), part_name(upload.id), size_bytes)
    return upload


def _require_room_beside(services: Services, session: Session, size_bytes: int, actor: int) -> None:
    """Raise NoRoom or TooMany where a file has no room beside what the person has announced and not sent.

    Of others nothing counts: whoever announces much shuts out nobody else.
    """
    announced = unfinished_uploads(session, maker=actor)
    if len(announced) >= MOST_ANNOUNCED:
        raise TooMany("recordings-too-many-uploads", most=MOST_ANNOUNCED)
    to_come = sum(one.size_bytes - _bytes_here(services, one) for one in announced)
    if not to_come:
        return  # whether it fits by itself is asked where its part is made
    upload_folder(services).mkdir(parents=True, exist_ok=True)
    free = free_bytes(upload_folder(services))
    if size_bytes + to_come > free:
        raise NoRoom(
            "recordings-uploads-no-room",
            needed_mb=size_bytes / 1e6,
            to_come_mb=to_come / 1e6,
            free_mb=max(0, free) / 1e6,
        )


def upload_arrived(services: Services, upload: Upload) -> int:
    """How many bytes are safely here. Raises NotFound when the part is gone."""
    if upload.finished_at is not None:
        return upload.size_bytes
    return upload_parts.offset(upload_folder(services), part_name(upload.id))


def uploads_under_way(services: Services, survey_id: int) -> list[tuple[Upload, int]]:
    """A survey's uploads that can go on, each with how many bytes have arrived; 0 where the part is gone."""
    with services.reading() as session:
        waiting = unfinished_uploads(session, survey_id)
    return [(upload, _bytes_here(services, upload)) for upload in waiting]


def _bytes_here(services: Services, upload: Upload) -> int:
    try:
        return upload_arrived(services, upload)
    except NotFound:
        return 0


def take_bytes(services: Services, upload: Upload, at: int, chunks: Iterable[bytes]) -> int:
    """Write chunks behind byte `at`; the new offset. What arrived stays, whatever breaks.

    Raises Conflict (another offset, another writer, finished), BadInput (more than announced), NoRoom.
    """
    if upload.finished_at is not None:
        raise Conflict("recordings-upload-finished")
    return upload_parts.append(upload_folder(services), part_name(upload.id), upload.size_bytes, at, chunks)


def upload_arrived_whole(services: Services, upload: Upload, actor: int | None) -> int | None:
    """What follows from the last byte, sent by `actor`: a recording (its id), or a waiting strip.

    May be done again, and gives the same. The bytes are stored by their content, what they became is noted,
    and the part is let go of. Raises Conflict while bytes are missing, and where the recording was deleted,
    NoRoom.
    """
    with services.reading() as session:
        now_is = get_upload(session, upload.id)
        if now_is.finished_at is not None:
            return _became(session, now_is)
    whole = upload_parts.finish(upload_folder(services), part_name(upload.id), upload.size_bytes)
    # A strip goes when its scan is read, so it is never one file with what stays.
    word = "-strip" if upload.purpose == "strip" else ""
    key = key_of(whole.sha256, word + suffix_of(upload.filename))
    # Linked where the store can: a copy would need the room twice. The part is discarded further down.
    recording_id = store_file(
        services,
        upload.survey_id,
        key,
        whole.path,
        lambda session: _note(session, upload.id, actor, key, whole),
        actor=actor,
        link=True,
    )
    upload_parts.discard(upload_folder(services), part_name(upload.id))
    return recording_id


def _note(
    session: Session, upload_id: int, actor: int | None, key: str, whole: upload_parts.FinishedUpload
) -> int | None:
    """Note what the bytes became, unless another request, or another try of this one, was faster."""
    upload = get_upload(session, upload_id)
    if upload.finished_at is not None:
        return _became(session, upload)
    if upload.purpose == "strip":
        strip_arrived(session, upload_id, media_key=key, sha256=whole.sha256, actor=actor)
        return None
    recording = create_recording(
        session,
        upload.survey_id,
        name=upload.filename,
        media_key=key,
        sha256=whole.sha256,
        size_bytes=whole.size,
        actor=actor,
    )
    finish_upload(session, upload_id, recording_id=recording.id, actor=actor)
    queue_ingest(session, recording, actor)
    return recording.id


def _became(session: Session, upload: Upload) -> int | None:
    """The recording of a finished upload; None of a strip. Raises Conflict where it was deleted."""
    if upload.recording_id is None:
        return None
    try:
        return get_recording(session, upload.recording_id).id
    except NotFound as gone:
        raise Conflict("recordings-upload-of-deleted") from gone


def abandon_upload(services: Services, upload_id: int, actor: int | None) -> None:
    """Forget an upload that became nothing, and its bytes. Raises Conflict for any other."""
    with services.writing() as session:
        gone = remove_upload(session, upload_id, actor=actor)
        let_go(session, gone.survey_id, [gone.media_key], actor)
    upload_parts.discard(upload_folder(services), part_name(upload_id))


def recover_uploads(services: Services) -> None:
    """After a start: finish uploads that were complete when it was killed, give up abandoned ones."""
    give_up_uploads(services)
    with services.reading() as session:
        waiting = unfinished_uploads(session)
    for upload in waiting:
        try:
            if _bytes_here(services, upload) == upload.size_bytes:
                upload_arrived_whole(services, upload, upload.created_by.id if upload.created_by else None)
        except SightlineError as error:
            log.warning("upload %s cannot be finished: %s", upload.id, error.message)


def give_up_uploads(services: Services, *, maker: int | None = None) -> None:
    """Forget uploads, of one person or of all: no byte came for a day, or nothing was added for a week."""
    with services.reading() as session:
        waiting = unfinished_uploads(session, maker=maker)
    for upload in waiting:
        silent_s = upload_parts.silent_s(upload_folder(services), part_name(upload.id))
        old = now() - upload.created_at > timedelta(seconds=NEVER_CAME_S)
        never_came = old and _bytes_here(services, upload) == 0
        if (silent_s or 0.0) < GIVEN_UP_S and not never_came:
            continue
        try:
            abandon_upload(services, upload.id, None)
        except SightlineError as error:
            log.warning("upload %s cannot be given up: %s", upload.id, error.message)
    if maker is None:
        upload_parts.sweep(upload_folder(services), GIVEN_UP_S)


def part_name(upload_id: int) -> str:
    """The name of an upload's part in the folder of parts."""
    return f"upload-{upload_id}"
