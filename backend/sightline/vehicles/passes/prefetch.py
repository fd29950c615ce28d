"""Frames around passes, ready before the operator comes to them.

While nobody asks for a picture, the server decodes a few frames around the best frame of each pass of the
recording that was looked at last, the next passes first, into the bounded cache on disk. The decoder for this
is another one than the operator's, and it is told to stop as soon as somebody asks for anything.
"""

import logging
import threading
import time

from sightline.errors import SightlineError
from sightline.infra.database.engine import SessionFactory, reading
from sightline.infra.services import Services
from sightline.media.video.frames import FrameServer
from sightline.media.video.window import NoLongerWanted
from sightline.recordings.frames.stills import OpenRecording, Stills, stills_of
from sightline.vehicles.store import list_vehicles_of_recording

log = logging.getLogger(__name__)

AROUND = 2
QUIET_S = 0.7
AGAIN_S = 120.0
MOST_PASSES = 80
MOST_BYTES = 256 * 1024**2


class PassPrefetcher:
    """One thread at a time, only while there is something to do. Thread-safe."""

    def __init__(self, sessions: SessionFactory, stills: Stills, server: FrameServer) -> None:
        self._sessions = sessions
        self._stills = stills
        self._server = server
        self._lock = threading.Lock()
        self._stopped = threading.Event()
        self._thread: threading.Thread | None = None
        self._place: tuple[int, int] | None = None
        self._asked_at = 0.0
        self._done: dict[int, float] = {}

    def asked(self, recording_id: int, n: int) -> None:
        """Somebody wants to see this frame: stop, and go on from there once it is quiet."""
        now = time.monotonic()
        with self._lock:
            self._asked_at = now
            self._place = (recording_id, n)
            waiting = now - self._done.get(recording_id, -AGAIN_S) < AGAIN_S
            if waiting or self._thread is not None or self._stopped.is_set():
                return
            self._thread = threading.Thread(target=self._run, name="frames-ahead", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """Stop for good."""
        self._stopped.set()
        thread = self._thread
        if thread is not None:
            thread.join(5)

    def _run(self) -> None:
        while self._quiet():
            with self._lock:
                assert self._place is not None
                recording_id, n = self._place
                if recording_id in self._done and time.monotonic() - self._done[recording_id] < AGAIN_S:
                    break
            try:
                if self._prepare(recording_id, n):
                    self._done[recording_id] = time.monotonic()
            except SightlineError as error:
                log.info("frames of recording %s were not prepared: %s", recording_id, error.message)
                self._done[recording_id] = time.monotonic()
            except Exception:
                log.exception("frames of recording %s were not prepared", recording_id)
                break
        with self._lock:
            self._thread = None

    def _quiet(self) -> bool:
        """Wait until nobody has asked for a while; False when the server ends."""
        while not self._stopped.is_set():
            left = self._asked_at + QUIET_S - time.monotonic()
            if left <= 0:
                return True
            self._stopped.wait(left)
        return False

    def _prepare(self, recording_id: int, n: int) -> bool:
        """Whether all was done that is to be done; False when somebody asked meanwhile."""
        opened = self._stills.open(recording_id)
        since = self._asked_at
        room = MOST_BYTES
        for frame in self._frames(opened, n):
            if room <= 0:
                break
            try:
                room -= self._server.prepare(opened.media, frame, lambda: self._undisturbed(since))
            except NoLongerWanted:
                return False
        return True

    def _undisturbed(self, since: float) -> bool:
        return self._asked_at == since and not self._stopped.is_set()

    def _frames(self, opened: OpenRecording, n: int) -> list[int]:
        """Frames around the best frames of the passes, those behind frame n first."""
        recording = opened.recording
        with reading(self._sessions) as session:
            found = list_vehicles_of_recording(session, recording.id)
        best = [
            one.best_frame if one.best_frame is not None else (one.first_frame + one.last_frame) // 2
            for one in found
        ]
        best = sorted(best, key=lambda frame: (frame < n, frame))[:MOST_PASSES]
        last = len(opened.media) - 1
        return [m for at in best for m in range(max(0, at - AROUND), min(last, at + AROUND) + 1)]


def prefetch_around_passes(services: Services) -> None:
    """From now on, whoever asks for a frame has those around the passes prepared."""
    stills_of(services).on_request = services.part(_make_prefetcher).asked


def _make_prefetcher(services: Services) -> PassPrefetcher:
    return PassPrefetcher(services.sessions, stills_of(services), services.frames)
