"""The process in which stills are decoded: `python -m sightline.media.video.decode_child FD BYTES BYTES`.

A decoder that crashes, hangs or eats memory ends this process and nothing else. It ends by itself when the
server is gone, also while a decoder holds every lock: an alarm of the kernel is put off only as long as all
is well.
"""

import os
import resource
import signal
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from multiprocessing.connection import Connection

import numpy as np
from numpy.typing import NDArray

from sightline.children import resident_bytes
from sightline.media.video.decode_wire import Header, Link, error_header, unpack_media
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import Window

TOO_MUCH_MEMORY = 86
THREADS = 32
TICK_S = 1.0
_LOOK_S = 0.1
_ALARM_S = 20


class Child:
    """Answers the server's messages, each in a thread of its own."""

    def __init__(self, link: Link, window: Window) -> None:
        self._link = link
        self._window = window
        self._known: dict[str, RecordingMedia] = {}
        self._wanted: set[int] = set()
        self._pool = ThreadPoolExecutor(THREADS)

    def run(self) -> None:
        """Until the server is gone."""
        self._link.send({"ready": True})
        while True:
            header, body = self._link.receive()
            self._take(header, body)

    def _take(self, header: Header, body: bytes) -> None:
        what = header["do"]
        if what == "know":
            self._known[header["media"]] = unpack_media(header, body)
        elif what == "forget":
            self._known.pop(header["media"], None)
        elif what == "drop":
            self._wanted.discard(int(header["id"]))
        elif what == "image":
            self._pool.submit(self._answer, header, lambda: self._image(header, body))
        else:
            self._wanted.add(int(header["id"]))
            media = self._known[header["media"]]
            self._pool.submit(self._answer, header, lambda: self._do_request(header, media))

    def _answer(self, header: Header, work: Callable[[], tuple[Header, bytes]]) -> None:
        reply: Header = {"id": header["id"]}
        body = b""
        try:
            said, body = work()
            reply |= said
        except Exception as error:
            reply |= error_header(error)
        finally:
            self._wanted.discard(int(header["id"]))
        try:
            self._link.send(reply, body)
        except OSError:
            os._exit(0)

    def _do_request(self, header: Header, media: RecordingMedia) -> tuple[Header, bytes]:
        wanted = self._asked_between_frames(int(header["id"]))
        what, display = header["do"], header.get("display", "plain")
        n = int(header.get("n", 0))
        if what == "warm":
            return {"frames": self._window.warm(media)}, b""
        if what == "still":
            return {}, self._window.still(media, n, wanted, display, ahead=bool(header.get("ahead")))
        if what == "crop":
            x, y, w, h, scale = header["rectangle"]
            return {}, self._window.crop_png(media, n, (x, y, w, h, scale), wanted, display)
        return _pixels(
            self._window.gray(media, n, wanted) if what == "gray" else self._window.bgr(media, n, wanted)
        )

    def _image(self, header: Header, body: bytes) -> tuple[Header, bytes]:
        image = self._window.image(body, header["name"], colour=header["colour"], most_px=header["most_px"])
        return _pixels(image)

    def _asked_between_frames(self, call: int) -> Callable[[], bool]:
        """Whether the server still wants the answer; tells it now and then that the decoder gets on."""
        told = time.monotonic()

        def wanted() -> bool:
            nonlocal told
            now = time.monotonic()
            if now - told > TICK_S:
                told = now
                self._link.send({"id": call, "tick": True})
            return call in self._wanted

        return wanted


def _pixels(image: NDArray[np.uint8]) -> tuple[Header, bytes]:
    return {"shape": image.shape}, np.ascontiguousarray(image).tobytes()


def main() -> None:
    """Serve the pipe FD with a window of the first and a memory of at most the second number of bytes."""
    descriptor, window_bytes, most_bytes = (int(one) for one in sys.argv[1:4])
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # for the one huge request that comes between two looks at what is resident
    resource.setrlimit(resource.RLIMIT_DATA, (2 * most_bytes, 2 * most_bytes))
    threading.Thread(target=_watch, args=(most_bytes, os.getppid()), name="watch", daemon=True).start()
    try:
        Child(Link(Connection(descriptor)), Window(window_bytes)).run()
    except (EOFError, OSError):
        os._exit(0)


def _watch(most_bytes: int, parent: int) -> None:
    """End this process when the server is gone or memory is above the limit."""
    while True:
        signal.alarm(_ALARM_S)
        if os.getppid() != parent:
            os._exit(0)
        if (resident_bytes() or 0) > most_bytes:
            os._exit(TOO_MUCH_MEMORY)
        time.sleep(_LOOK_S)


if __name__ == "__main__":
    main()
