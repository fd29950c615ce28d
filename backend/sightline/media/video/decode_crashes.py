"""Which recording ended the decoding process, and which is set aside for having done so again and again."""

import threading
import time
from collections.abc import Callable, Iterator, Set
from contextlib import contextmanager

from sightline.errors import BadInput
from sightline.media.video.decode_wire import Limits


class CannotDecode(BadInput):
    """The decoder crashed, hung or ate memory at this frame; the server did not."""

    kind = "cannot_decode"


class CrashTracker:
    """Counts what each recording did. Thread-safe.

    When several recordings were being decoded as the process ended, none is blamed: from then on each of them
    is decoded while none of the others is, until one shows itself or has answered.
    """

    def __init__(self, limits: Limits, clock: Callable[[], float] = time.monotonic) -> None:
        self._limits = limits
        self._clock = clock
        self._lock = threading.Lock()
        self._one_at_a_time = threading.RLock()
        self._suspects: set[str] = set()
        self._kills: dict[str, list[float]] = {}

    def check(self, recording: str) -> None:
        """Raises CannotDecode for a recording that is set aside."""
        with self._lock:
            since = self._clock() - self._limits.aside_s
            kills = [at for at in self._kills.get(recording, ()) if at > since]
        if len(kills) >= self._limits.kills:
            raise CannotDecode("video-set-aside", count=len(kills))

    def died(self, decoding: Set[str]) -> Set[str]:
        """The process ended while these were being decoded: the guilty ones, perhaps none."""
        with self._lock:
            culprits = decoding & self._suspects if len(decoding) > 1 else decoding
            if culprits:
                for recording in culprits:
                    self._kills.setdefault(recording, []).append(self._clock())
            self._suspects |= decoding
            return culprits

    @contextmanager
    def turn(self, recording: str) -> Iterator[None]:
        """While a suspect is decoded no other suspect is."""
        with self._lock:
            suspect = recording in self._suspects
        if not suspect:
            yield
            return
        with self._one_at_a_time:
            yield
        with self._lock:
            if recording not in self._kills:
                self._suspects.discard(recording)
