"""The frame table of a recording, in and out as arrays."""

import hashlib
from typing import Any

import numpy as np
import numpy.typing as npt
from sqlalchemy import bindparam, delete, select, update
from sqlalchemy.orm import Session

from sightline.errors import NotFound
from sightline.infra.by_name import record_of
from sightline.media.video.frame_table import FrameTable
from sightline.recordings.frames.records import Frame
from sightline.recordings.frames.tables import frames

_SQLITE_INSERT = 'INSERT INTO frames (recording_id, n, pts, time_s, "key", crc32) VALUES (?, ?, ?, ?, ?, ?)'
_COPY = 'COPY frames (recording_id, n, pts, time_s, "key", crc32) FROM STDIN'


def get_frame_table(session: Session, recording_id: int) -> FrameTable:
    """The whole table; without rows where nothing was ingested."""
    columns = (frames.c.pts, frames.c.time_s, frames.c.key, frames.c.crc32)
    wanted = select(*columns).where(frames.c.recording_id == recording_id).order_by(frames.c.n)
    rows = session.execute(wanted).all()
    pts, time_s, key, crc32 = zip(*rows, strict=True) if rows else ((), (), (), ())
    return FrameTable(
        pts=np.array(pts, np.int64),
        time_s=np.array(time_s, np.float64),
        key=np.array(key, np.bool_),
        crc32=np.array(crc32, np.uint32),
    )


def get_frame(session: Session, recording_id: int, n: int) -> Frame:
    """One frame. Raises NotFound."""
    query = select(frames).where(frames.c.recording_id == recording_id, frames.c.n == n)
    row = session.execute(query).one_or_none()
    if row is None:
        raise missing_frame(recording_id, n)
    return record_of(Frame, row._mapping)


def missing_frame(recording_id: int, n: int) -> NotFound:
    """The error for a frame that is not there."""
    return NotFound("recordings-frame-outside", recording_id=recording_id, n=n)


def replace_frames(session: Session, recording_id: int, found: FrameTable) -> None:
    """Put a recording's whole frame table in the place of the one before (one bulk statement)."""
    remove_frames(session, recording_id)
    columns = (found.pts.tolist(), found.time_s.tolist(), found.key.tolist(), found.crc32.tolist())
    rows = [(recording_id, n, *values) for n, values in enumerate(zip(*columns, strict=True))]
    if not rows:
        return
    connection = session.connection()
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql(_SQLITE_INSERT, rows)
        return
    driver: Any = connection.connection.driver_connection
    with driver.cursor() as cursor, cursor.copy(_COPY) as copy:
        for row in rows:
            copy.write_row(row)


def change_times(session: Session, recording_id: int, time_s: npt.NDArray[np.float64]) -> None:
    """Give the frames of a recording other times (N,), s; numbers, stamps and checksums stay."""
    of_frame = (frames.c.recording_id == recording_id) & (frames.c.n == bindparam("at"))
    change = update(frames).where(of_frame).values(time_s=bindparam("then_s"))
    session.connection().execute(change, [{"at": n, "then_s": t} for n, t in enumerate(time_s.tolist())])


def remove_frames(session: Session, recording_id: int) -> None:
    """Take a recording's frame table out."""
    session.execute(delete(frames).where(frames.c.recording_id == recording_id))


def frame_table_fingerprint(frame_table: FrameTable) -> str:
    """sha256 over all four columns; kept in the audit event of the ingest."""
    digest = hashlib.sha256()
    kinds: tuple[tuple[Any, str], ...] = (
        (frame_table.pts, "<i8"),
        (frame_table.time_s, "<f8"),
        (frame_table.key, "?"),
        (frame_table.crc32, "<u4"),
    )
    for array, kind in kinds:
        digest.update(np.ascontiguousarray(array, dtype=kind).tobytes())
    return digest.hexdigest()
