"""Frames of stored recordings without a query for each: facts and frame table are kept in memory."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from cachetools import LRUCache

from sightline.enums import Display
from sightline.errors import Damaged, NotFound
from sightline.infra.database.engine import SessionFactory, reading
from sightline.infra.services import BELIEVED_S, Services
from sightline.media.store.local import MediaStore
from sightline.media.video.frames import FrameServer
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import CancelCheck, is_always_wanted
from sightline.recordings.frames.store import get_frame_table
from sightline.recordings.records import Recording
from sightline.recordings.store import get_ready_recording

MOST = 32


@dataclass(frozen=True, eq=False)
class OpenRecording:
    """A ready recording with its frame table in memory. `time_s` (N,) counts from the first frame."""

    recording: Recording
    media: RecordingMedia
    time_s: npt.NDArray[np.float64]
    looked_at_s: float


@dataclass(frozen=True)
class Still:
    """One encoded picture of frame n with the identity of the frame."""

    content: bytes
    n: int
    pts: int
    crc: int


class Stills:
    """Thread-safe. Every method raises NotFound for a recording or frame that is not there, Damaged if the
    file does not give the frame whose checksum is in the table, BadInput while the recording is not ready.
    """

    def __init__(
        self,
        sessions: SessionFactory,
        store: MediaStore,
        server: FrameServer,
        timer: Callable[[], float] = time.monotonic,
    ) -> None:
        self._sessions = sessions
        self._store = store
        self._server = server
        self._timer = timer
        self._open: LRUCache[int, OpenRecording] = LRUCache(MOST)
        self._lock = threading.Lock()
        #: Hears which frame of which recording somebody wants to see, before it is decoded.
        self.on_request: Callable[[int, int], None] | None = None

    def open(self, recording_id: int) -> OpenRecording:
        """The recording's facts and frame table, read from the database at most every two seconds."""
        with self._lock:
            known = self._open.get(recording_id)
        if known is not None and self._timer() - known.looked_at_s < BELIEVED_S:
            return known
        fresh = self._read_recording(recording_id, known)
        with self._lock:
            self._open[recording_id] = fresh
        return fresh

    def announce_request(self, recording_id: int, n: int) -> None:
        """Somebody wants to see frame n: what prepares frames stops, and goes on from there."""
        if self.on_request is not None:
            self.on_request(recording_id, n)

    def still(
        self, recording_id: int, n: int, display: Display = "plain", wanted: CancelCheck = is_always_wanted
    ) -> Still:
        """Frame n as JPEG, upright; "bright" is to look at only. NoLongerWanted once `wanted` says no."""
        opened = self._with_frame(recording_id, n)
        content = self._server.still(opened.media, n, wanted, display)
        return Still(content, n, int(opened.media.pts[n]), int(opened.media.crc[n]))

    def crop(
        self,
        recording_id: int,
        n: int,
        rectangle: tuple[int, int, int, int],
        display: Display = "plain",
        wanted: CancelCheck = is_always_wanted,
    ) -> Still:
        """A rectangle (x, y, w, h) of frame n as PNG; black where it reaches out of the picture."""
        opened = self._with_frame(recording_id, n)
        content = self._server.crop_png(opened.media, n, *rectangle, display=display, wanted=wanted)
        return Still(content, n, int(opened.media.pts[n]), int(opened.media.crc[n]))

    def gray(self, recording_id: int, n: int) -> npt.NDArray[np.uint8]:
        """Frame n as luminance, (height_px, width_px), upright."""
        return self._server.gray(self._with_frame(recording_id, n).media, n)

    def ready(self, recording_id: int) -> list[tuple[int, int]]:
        """Runs (first, last) of the frames that are answered without decoding."""
        return self._server.ready(self.open(recording_id).media)

    def crc(self, recording_id: int, n: int) -> int:
        """The checksum of frame n as the table has it, for an answer without a picture."""
        return int(self._with_frame(recording_id, n).media.crc[n])

    def forget(self, recording_id: int) -> None:
        """Read the recording afresh next time; called after an ingest or a change."""
        with self._lock:
            self._open.pop(recording_id, None)

    def close(self) -> None:
        """Let go of what is in memory."""
        with self._lock:
            self._open.clear()

    def _with_frame(self, recording_id: int, n: int) -> OpenRecording:
        opened = self.open(recording_id)
        if not 0 <= n < len(opened.media):
            raise NotFound("video-frame-outside", n=n, last=len(opened.media) - 1)
        return opened

    def _read_recording(self, recording_id: int, known: OpenRecording | None) -> OpenRecording:
        with reading(self._sessions) as session:
            recording = get_ready_recording(session, recording_id)
            # A distant store may have dropped its local copy; asking for the path brings it back.
            path = self._store.local_path(file_key(recording))
            same = known is not None and path == known.media.path and _same_frames(known.recording, recording)
            if known is not None and same:
                return OpenRecording(recording, known.media, known.time_s, self._timer())
            table = get_frame_table(session, recording_id)
        if len(table) != recording.frame_count:
            raise Damaged("recordings-frame-table-incomplete", name=recording.name)
        stream = None if "working_copy" in recording.report else recording.stream_number
        media = RecordingMedia(path, table.pts, table.crc32, table.key, stream)
        return OpenRecording(recording, media, table.time_s, self._timer())


def stills_of(services: Services) -> Stills:
    """The process's frames of stored recordings."""
    return services.part(_make_stills)


def _make_stills(services: Services) -> Stills:
    return Stills(services.sessions, services.media, services.frames)


def _same_frames(then: Recording, now: Recording) -> bool:
    """Whether the frame table in memory still holds: the same content, read with the same outcome."""

    def read(one: Recording) -> tuple[object, ...]:
        return one.sha256, one.frame_count, one.report, one.stream_number

    return read(then) == read(now)


def file_key(recording: Recording) -> str:
    """The stored file that the frame table numbers: the upload, or its working copy."""
    return str(recording.report.get("working_copy") or recording.media_key)
