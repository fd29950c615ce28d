"""Stills made while nobody waits, of the frames that the operator's next steps will show."""

import logging
import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from sightline.errors import SightlineError
from sightline.media.video.caches import MemoryCache
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import CancelCheck, NoLongerWanted

if TYPE_CHECKING:
    from sightline.media.video.decode_host import DecodeHost

log = logging.getLogger("sightline.decode")

AHEAD = 6
BEHIND = 2
# the share of the cache that one place in a recording may fill
SHARE = 4
# up to so far it is a step, beyond a jump
STEP = 12
# after so many steps back in a row, frames in front of the window are decoded as well
BACKWARDS = 3
THREADS = 2
IDLE_S = 10.0
MOST_FAILED = 1000
_LOOK_S = 0.05
_END_S = 5.0


@dataclass(eq=False)
class _Item:
    """A still to be made; unless `decode`, only of a frame that is decoded already."""

    key: str
    media: RecordingMedia
    n: int
    decode: bool
    done: threading.Event = field(default_factory=threading.Event)
    dropped: bool = False


class Prefetcher:
    """Fills a cache of JPEGs, nearest in the direction of travel first: one thread decodes, one encodes.

    Thread-safe. Its threads pause while somebody waits for a frame that is not here, and end after a while
    without work, or by `close`.
    """

    def __init__(
        self, jpegs: MemoryCache[bytes], pictures: "DecodeHost", key_of: Callable[[RecordingMedia, int], str]
    ) -> None:
        self._jpegs = jpegs
        self._pictures = pictures
        self._key_of = key_of
        self._change = threading.Condition()
        self._plan: deque[_Item] = deque()
        self._coming: dict[str, _Item] = {}
        self._failed: dict[str, None] = {}
        self._waiting = 0
        self._threads = 0
        self._closed = False
        self._last: tuple[str, int, int] = ("", 0, 0)

    def asked(self, media: RecordingMedia, n: int, size_bytes: int) -> None:
        """Somebody got frame n, of so many bytes: prepare what comes next."""
        with self._change:
            run = self._steps_in_a_row(media, n)
            deep = min(AHEAD, max(2, self._jpegs.most_bytes // SHARE // max(1, size_bytes)))
            self._plan = deque(self._next(media, n, run, deep))
            self._closed = False
            for _ in range(min(THREADS - self._threads, len(self._plan))):
                self._threads += 1
                threading.Thread(target=self._run, name="stills-onward", daemon=True).start()
            self._change.notify_all()

    def coming(self, key: str, wanted: CancelCheck) -> bytes | None:
        """The still if it is just being made, as soon as it is; None if it is not or came to nothing."""
        with self._change:
            item = self._coming.get(key)
        if item is None:
            return None
        while not item.done.wait(_LOOK_S):
            if not wanted():
                return None
        return self._jpegs.get(key)

    @contextmanager
    def first(self) -> Iterator[None]:
        """While the block runs somebody waits for the decoder: whatever is made ahead is put off."""
        with self._change:
            self._waiting += 1
            for item in self._coming.values():
                item.dropped = True
        try:
            yield
        finally:
            with self._change:
                self._waiting -= 1
                self._change.notify_all()

    def close(self) -> None:
        """End the threads, and wait for them a while; `asked` starts them again."""
        with self._change:
            self._closed = True
            self._plan.clear()
            for item in self._coming.values():
                item.dropped = True
            self._change.notify_all()
            self._change.wait_for(lambda: self._threads == 0 or not self._closed, _END_S)

    def _steps_in_a_row(self, media: RecordingMedia, n: int) -> int:
        """How many requests in a row went on (positive) or back (negative) by steps; 0 after a jump."""
        identity, before, run = self._last
        move = n - before if identity == media.identity else STEP + 1
        if move == 0:
            return run
        if abs(move) > STEP:
            run = 0
        elif move > 0:
            run = max(run, 0) + 1
        else:
            run = min(run, 0) - 1
        self._last = (media.identity, n, run)
        return run

    def _next(self, media: RecordingMedia, n: int, run: int, deep: int) -> Iterator[_Item]:
        """What is missing around frame n, best first; it ends before a frame that could not be made."""
        way = -1 if run < 0 else 1
        decode = way > 0 or run <= -BACKWARDS
        ahead = [(n + way * k, decode) for k in range(1, deep + 1)]
        behind = [(n - way * k, False) for k in range(1, min(BEHIND, deep - 1) + 1)]
        for m, decodes in ahead + behind:
            if not 0 <= m < len(media):
                continue
            key = self._key_of(media, m)
            if key in self._failed:
                return
            if key not in self._jpegs and key not in self._coming:
                yield _Item(key, media, m, decodes)

    def _run(self) -> None:
        while True:
            with self._change:
                busy = self._change.wait_for(self._may_go_on, IDLE_S)
                if self._closed or not busy:
                    self._threads -= 1
                    self._change.notify_all()
                    return
                item = self._plan.popleft()
                if item.key in self._jpegs or item.key in self._coming:
                    continue
                self._coming[item.key] = item
            try:
                self._make(item)
            except NoLongerWanted:
                pass
            except SightlineError as error:
                self._give_up(item, error.message)
            except Exception as error:
                self._give_up(item, repr(error))
            finally:
                with self._change:
                    self._coming.pop(item.key, None)
                item.done.set()

    def _may_go_on(self) -> bool:
        return self._closed or bool(self._plan and not self._waiting)

    def _make(self, item: _Item) -> None:
        if not item.decode and item.n not in self._pictures.warm(item.media):
            return
        data = self._pictures.still(item.media, item.n, lambda: not item.dropped, "plain")
        self._jpegs.put(item.key, data)

    def _give_up(self, item: _Item, why: str) -> None:
        """A frame that cannot be made is not tried again unless somebody asks: it may end the decoder."""
        log.info("frame %d was not made ahead: %s", item.n, why)
        with self._change:
            self._plan.clear()
            self._failed[item.key] = None
            while len(self._failed) > MOST_FAILED:
                del self._failed[next(iter(self._failed))]
