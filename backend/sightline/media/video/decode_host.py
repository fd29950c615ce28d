"""The server's side of decoding in a child process: asks, waits, and outlives whatever the child dies of.

One child holds the warm decoders of all open recordings, in threads. When it crashes, hangs or takes too much
memory it is ended; what it was decoding then is refused in one sentence, everything else is asked again of a
new child, and a recording that does so repeatedly is set aside.
"""

import hashlib
import itertools
import logging
import signal
import socket
import subprocess
import sys
import threading
import time
from collections import OrderedDict
from collections.abc import Set
from concurrent.futures import Future
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection

import numpy as np
from numpy.typing import NDArray

from sightline.children import child_environment
from sightline.enums import Display
from sightline.errors import SightlineError
from sightline.media.video.decode_child import TOO_MUCH_MEMORY
from sightline.media.video.decode_crashes import CannotDecode, CrashTracker
from sightline.media.video.decode_wire import Header, Limits, Link, error_of, pack_media
from sightline.media.video.picture import Bgr, Gray
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import CancelCheck, NoLongerWanted, Rectangle, is_always_wanted
from sightline.messages.said import Said

log = logging.getLogger("sightline.decode")

ENTRY = "sightline.media.video.decode_child"
MOST_KNOWN = 32
TRIES = 4
START_S = 60.0
_LOOK_S = 0.05
# decoding has no use for their pools
_ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
_GIGABYTE = 1024**3
Reply = tuple[Header, bytes]


class _Died(Exception):
    """The child ended in the middle; `culprits` are the recordings that are blamed for it. Who was decoded
    when the memory of a child with other work ran out, or when it was killed, is not: it is tried `alone`.
    """

    def __init__(self, why: Said, culprits: Set[str], *, alone: bool = False) -> None:
        super().__init__(str(why))
        self.why, self.culprits, self.alone = why, culprits, alone


@dataclass(frozen=True, eq=False)
class Question:
    """What is asked about a recording, or (without `media`) about the file that is the body."""

    header: Header
    recording: str
    media: RecordingMedia | None = None
    body: bytes = b""

    def refusal(self, why: Said) -> CannotDecode:
        n = self.header.get("n")
        if self.media is None or n is None:
            return CannotDecode(
                "video-not-decodable", header=self.header.get("name", Said("video-this-recording")), why=why
            )
        if why.code == "video-decoder-memory":
            return CannotDecode("video-too-large-at", frame=int(n), why=why)
        return CannotDecode("video-not-decoded-at", frame=int(n), why=why)


@dataclass(eq=False)
class _Call:
    recording: str
    answer: Future[Reply] = field(default_factory=Future)


class _Child:
    """One run of the decoding process. The first thread that finds it dead starts the next one."""

    def __init__(
        self, entry: str, window_bytes: int, limits: Limits, blame: CrashTracker, *, for_one: bool = False
    ) -> None:
        self._for_one = for_one
        ours, theirs = socket.socketpair()
        arguments = [str(theirs.fileno()), str(window_bytes), str(limits.memory_bytes)]
        with theirs:
            self.process = subprocess.Popen(
                [sys.executable, "-m", entry, *arguments],
                pass_fds=[theirs.fileno()],
                stdin=subprocess.DEVNULL,
                env=child_environment(**_ONE_THREAD),
            )
        self._link = Link(Connection(ours.detach()))
        self._limits, self._crashes = limits, blame
        self._known: OrderedDict[str, None] = OrderedDict()
        self._calls: dict[int, _Call] = {}
        self._heard: dict[str, float] = {}
        self._lock = threading.Lock()
        self._why: Said | None = None
        self._ready = False
        self._end: _Died | None = None
        self._is_closed = False
        self._reader = threading.Thread(target=self._read_answers, name="decode-reader", daemon=True)
        self._reader.start()

    @property
    def is_over(self) -> bool:
        return self._end is not None

    def ask(self, call_id: int, question: Question, wanted: CancelCheck) -> Reply:
        """Send a question and wait. Raises what the child raised, NoLongerWanted, or _Died."""
        call = _Call(question.recording)
        with self._lock:
            if self._end is not None:
                raise _Died(Said("video-decoder-ended"), frozenset())
            self._calls[call_id] = call
            self._heard[call.recording] = time.monotonic()
            with suppress(OSError):  # the reader finds out why
                if question.media is not None:
                    self._introduce(question.media)
                self._link.send({**question.header, "id": call_id, "media": call.recording}, question.body)
        dropped = False
        while True:
            try:
                return call.answer.result(_LOOK_S)
            except TimeoutError:
                if not dropped and not wanted():
                    dropped = True
                    self._drop(call_id)
                self._check_silence(call.recording)

    def end(self) -> None:
        """Kill it and wait for its end; nobody is blamed for that."""
        self._is_closed = True
        self.process.kill()
        self._reader.join(5)

    def _introduce(self, media: RecordingMedia) -> None:
        """Under the lock: make sure that the child has the recording's frame table."""
        if media.identity in self._known:
            self._known.move_to_end(media.identity)
            return
        self._link.send(*pack_media(media))
        self._known[media.identity] = None
        if len(self._known) > MOST_KNOWN:
            self._link.send({"do": "forget", "media": self._known.popitem(last=False)[0]})

    def _drop(self, call_id: int) -> None:
        with self._lock, suppress(OSError):
            self._link.send({"do": "drop", "id": call_id})

    def _check_silence(self, recording: str) -> None:
        """A recording of which nothing is heard hangs: requests of one recording wait for one another."""
        silent = time.monotonic() - self._heard[recording]
        if silent <= (self._limits.silence_s if self._ready else START_S):
            return
        with self._lock:
            if self._why is not None:
                return
            self._why = Said("video-decoder-silent", seconds=round(self._limits.silence_s))
            for call_id, call in list(self._calls.items()):
                if call.recording != recording:
                    del self._calls[call_id]
                    call.answer.set_exception(_Died(self._why, frozenset()))
        self.process.kill()

    def _read_answers(self) -> None:
        try:
            while True:
                header, body = self._link.receive()
                if "id" in header:
                    self._take(header, body)
                else:
                    self._is_ready()
        except (EOFError, OSError, ValueError, KeyError):
            self.process.kill()
        self._bury()

    def _is_ready(self) -> None:
        """Python has started there: from now on silence is the decoder's."""
        with self._lock:
            self._heard = dict.fromkeys(self._heard, time.monotonic())
            self._ready = True

    def _take(self, header: Header, body: bytes) -> None:
        with self._lock:
            call = self._calls.get(int(header["id"]))
            if call is None:
                return
            self._heard[call.recording] = time.monotonic()
            if header.get("tick"):
                return
            del self._calls[int(header["id"])]
        if "error" in header:
            call.answer.set_exception(error_of(header))
        else:
            call.answer.set_result((header, body))

    def _bury(self) -> None:
        """After its end: no zombie, and an answer for everybody who waits."""
        status = self.process.wait()
        with self._lock:
            calls = list(self._calls.values())
            self._calls.clear()
            # the decoders kept warm and what others asked fill the memory too: only one alone tells its need
            is_full = status == TOO_MUCH_MEMORY
            # by the system, which is out of memory, or by a person: neither is the recording's doing yet
            is_killed = status == -signal.SIGKILL and self._why is None
            alone = is_killed or (is_full and not self._for_one)
            blamed = self._ready and not self._is_closed and not alone
            decoding = frozenset(call.recording for call in calls) if blamed else frozenset()
            why = self._why or _reason_of_exit(status, self._limits)
            self._end = _Died(why, self._crashes.died(decoding), alone=alone)
            self._link.close()
        if calls and not self._is_closed:
            log.warning("the decoding process %s (status %s) and is started anew", why, status)
        for call in calls:
            call.answer.set_exception(self._end)


class DecodeHost:
    """Pictures of frame n, decoded in a child process. Thread-safe; the child starts when it is needed.

    Raises CannotDecode where the decoder dies of a frame, SightlineError where no decoder can be started.
    """

    def __init__(self, window_bytes: int, limits: Limits | None = None, *, entry: str = ENTRY) -> None:
        self._limits = limits or Limits()
        self._window_bytes = window_bytes
        self._entry = entry
        self._crashes = CrashTracker(self._limits)
        self._numbers = itertools.count(1)
        self._lock = threading.Lock()
        self._one_alone = threading.Lock()
        self._child: _Child | None = None

    def still(
        self, media: RecordingMedia, n: int, wanted: CancelCheck, display: Display, *, ahead: bool = False
    ) -> bytes:
        """Frame n as JPEG."""
        return self._ask({"do": "still", "n": n, "display": display, "ahead": ahead}, media, wanted)[1]

    def crop_png(
        self, media: RecordingMedia, n: int, rectangle: Rectangle, wanted: CancelCheck, display: Display
    ) -> bytes:
        """A rectangle of frame n, lossless."""
        header = {"do": "crop", "n": n, "rectangle": rectangle, "display": display}
        return self._ask(header, media, wanted)[1]

    def bgr(self, media: RecordingMedia, n: int, wanted: CancelCheck) -> Bgr:
        """Frame n, (height_px, width_px, 3) BGR."""
        header, body = self._ask({"do": "bgr", "n": n}, media, wanted)
        return np.frombuffer(body, np.uint8).reshape(header["shape"]).copy()

    def gray(self, media: RecordingMedia, n: int, wanted: CancelCheck) -> Gray:
        """Frame n, (height_px, width_px) luminance."""
        header, body = self._ask({"do": "gray", "n": n}, media, wanted)
        return np.frombuffer(body, np.uint8).reshape(header["shape"]).copy()

    def image(self, data: bytes, name: str, *, colour: bool, most_px: int | None = None) -> NDArray[np.uint8]:
        """A still picture's file, BGR or luminance. Raises BadInput, naming it."""
        digest = hashlib.sha256(data).hexdigest()
        asked: Header = {"do": "image", "name": name, "colour": colour, "most_px": most_px}
        question = Question(asked, digest, None, data)
        header, body = self._answer(question, is_always_wanted)
        return np.frombuffer(body, np.uint8).reshape(header["shape"]).copy()

    def warm(self, media: RecordingMedia) -> list[int]:
        """The frames that the child has decoded; none while there is no child."""
        child = self._child
        if child is None or child.is_over:
            return []
        return [int(n) for n in self._ask({"do": "warm"}, media, is_always_wanted)[0]["frames"]]

    @property
    def memory_bytes(self) -> int:
        """Nothing in this process; the child bounds its own."""
        return 0

    @property
    def process_id(self) -> int | None:
        """Of the child that runs now."""
        child = self._child
        return child.process.pid if child and not child.is_over else None

    def start(self) -> None:
        """Have a child ready before the first frame is asked for."""
        self._running()

    def close(self) -> None:
        """End the child. Another is started when something is asked again."""
        with self._lock:
            child, self._child = self._child, None
        if child is not None:
            child.end()

    def _ask(self, header: Header, media: RecordingMedia, wanted: CancelCheck) -> Reply:
        return self._answer(Question(header, media.identity, media), wanted)

    def _answer(self, question: Question, wanted: CancelCheck) -> Reply:
        for _ in range(TRIES):
            self._crashes.check(question.recording)
            if not wanted():
                raise NoLongerWanted("video-frame-unwanted")
            try:
                with self._crashes.turn(question.recording):
                    return self._running().ask(next(self._numbers), question, wanted)
            except _Died as died:
                if died.alone:
                    return self._ask_fresh_child(question, wanted)
                if question.recording in died.culprits:
                    raise question.refusal(died.why) from died
        raise SightlineError("video-decoder-failing")

    def _ask_fresh_child(self, question: Question, wanted: CancelCheck) -> Reply:
        """The answer of a fresh child that does nothing else, one such at a time."""
        with self._one_alone:
            self._crashes.check(question.recording)
            for left in reversed(range(TRIES)):
                child = _Child(self._entry, self._window_bytes, self._limits, self._crashes, for_one=True)
                try:
                    return child.ask(next(self._numbers), question, wanted)
                except _Died as died:
                    if died.alone and left:
                        continue  # killed by somebody, once more
                    if died.alone:
                        self._crashes.died(frozenset((question.recording,)))
                    raise question.refusal(died.why) from died
                finally:
                    child.end()
        raise AssertionError("the last try answers or raises")

    def _running(self) -> _Child:
        with self._lock:
            if self._child is None or self._child.is_over:
                self._child = _Child(self._entry, self._window_bytes, self._limits, self._crashes)
            return self._child


def _reason_of_exit(status: int, limits: Limits) -> Said:
    if status == TOO_MUCH_MEMORY:
        return Said("video-decoder-memory", gigabytes=round(limits.memory_bytes / _GIGABYTE, 1))
    if status == -signal.SIGALRM:
        return Said("video-decoder-hung")
    if status == -signal.SIGKILL:
        return Said("video-decoder-killed")
    return Said("video-decoder-crashed")
