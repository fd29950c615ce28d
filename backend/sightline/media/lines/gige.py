"""Lines of two GigE Vision cameras through Aravis (optional: PyGObject and Aravis of the operating system).

Each camera sends frames of so many lines; frame numbers and packets tell what is missing. A frame of which a
packet was lost counts as lost whole, for which of its lines arrived is not told. A GigE Vision camera counts
the frames of a stream from 1, so its first number tells what was lost before.
"""

import time
import warnings
from collections import deque
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from sightline.errors import BadInput
from sightline.media.lines.source import Ending, Lines, Lost, Piece

BUFFERS_S = 3.0
_WAIT_US = 50_000
_QUIET_S = 0.5
_GONE_S = 3.0
_FRAME_IDS = 65_535  # GigE Vision 1 counts 1..65535


class GigeLines:
    """Lines of the cameras `first` and `second` (Aravis names, serial numbers or addresses), `rows` pixels
    each; both are to be started by one trigger. `frame_lines`: lines of a frame.

    Raises BadInput where Aravis or a camera is not there.
    """

    last_at = None

    def __init__(
        self, first: str, second: str, rows: int, line_rate_hz: float, ending: Ending, frame_lines: int = 256
    ) -> None:
        aravis = require_aravis()
        self.name, self.notes, self.broken = f"{first} and {second}", list[str](), False
        self._aravis, self._ending, self._rate = aravis, ending, line_rate_hz
        self._cameras = [
            _Camera(aravis, number, name, rows, frame_lines, line_rate_hz)
            for number, name in enumerate((first, second), 1)
        ]

    @property
    def waiting_bytes(self) -> int:
        return sum(camera.waiting_bytes for camera in self._cameras)

    def pieces(self) -> Iterator[Piece | None]:
        for camera in self._cameras:
            camera.start()
        quiet = time.monotonic()
        try:
            while not self._ending.wished():
                for camera in self._cameras:
                    camera.collect()
                piece = self._common()
                if piece is not None:
                    quiet = time.monotonic()
                    yield piece
                elif self._note_gone_camera():
                    break
                elif time.monotonic() - quiet > _QUIET_S:
                    quiet = time.monotonic()
                    yield None
            self._say_unpaired()
        finally:
            for camera in self._cameras:
                camera.stop()

    def _note_gone_camera(self) -> bool:
        for camera in self._cameras:
            if camera.began_with is not None:
                self.notes.append(
                    f"The first frame of camera {camera.number} ({camera.name}) has number "
                    f"{camera.began_with}, so its first frames were lost, or it does not count from 1: which "
                    "of its lines belong to those of the other camera is not known; start again."
                )
                self.broken = True
            elif camera.lost_control or time.monotonic() - camera.heard > _GONE_S:
                what = (
                    "is unplugged or switched off"
                    if camera.lost_control
                    else f"sent nothing for {_GONE_S:.0f} s"
                )
                self.notes.append(
                    f"Camera {camera.number} ({camera.name}) {what}, after line {camera.lines}; all lines "
                    "before were taken; check cable and power, and start again."
                )
                self.broken = True
        return self.broken

    def _say_unpaired(self) -> None:
        """What one camera sent alone has no partner."""
        if any(camera.began_with is not None for camera in self._cameras):
            return
        for camera in self._cameras:
            if camera.held_lines:
                self.notes.append(
                    f"The last {camera.held_lines} lines of camera {camera.number} are left out: the other "
                    "camera sent none of that time."
                )

    def _common(self) -> Piece | None:
        """What both cameras have."""
        count = min(camera.held_lines for camera in self._cameras)
        if not count:
            return None
        (first, lost_1), (second, lost_2) = (camera.take(count) for camera in self._cameras)
        return Piece(first, second, (*lost_1, *lost_2))


class _Camera:
    """One camera: frames in their order, lost ones put back as copies of the line before."""

    def __init__(
        self, aravis: Any, number: int, name: str, rows: int, frame_lines: int, line_rate_hz: float
    ) -> None:
        self.number, self.name, self.lines, self.lost_control = number, name, 0, False
        self.heard = time.monotonic()
        self._aravis, self._rows, self._frame_lines = aravis, rows, frame_lines
        self._held: deque[Lines] = deque()
        self._lost: list[Lost] = []
        self._taken = 0
        self._next_id: int | None = None
        self._before: Lines | None = None
        self._lost_first = 0
        # the number of its first frame, where nobody can tell what was lost before it
        self.began_with: int | None = None
        self._buffers = max(8, round(BUFFERS_S * line_rate_hz / frame_lines))
        try:
            self._camera = aravis.Camera.new(name)
            self._camera.set_region(0, 0, rows, frame_lines)
            self._camera.set_pixel_format(aravis.PIXEL_FORMAT_MONO_8)
            if self._camera.is_frame_rate_available():
                self._camera.set_frame_rate(line_rate_hz / frame_lines)
            width = self._camera.get_region()[2]
            if width != rows:
                raise BadInput("commands-stream-camera-rows", name=name, width=width, rows=rows)
            self._stream = self._camera.create_stream(None, None)
            payload = self._camera.get_payload()
        except BadInput:
            raise
        except Exception as error:  # GLib.Error, which exists only where Aravis does
            raise BadInput("commands-stream-camera-missing", name=name, error=str(error)) from None
        self._camera.get_device().connect("control-lost", self._control_lost)
        for _ in range(self._buffers):
            self._stream.push_buffer(aravis.Buffer.new_allocate(payload))

    @property
    def held_lines(self) -> int:
        return sum(len(one) for one in self._held)

    @property
    def waiting_bytes(self) -> int:
        return self.held_lines * self._rows

    def start(self) -> None:
        self.heard = time.monotonic()
        self._camera.start_acquisition()

    def stop(self) -> None:
        with suppress(Exception):  # GLib.Error: it is unplugged, and nothing is left to stop
            self._camera.stop_acquisition()

    def collect(self) -> None:
        """Take what has come, waiting a moment where nothing has."""
        buffer = self._stream.timeout_pop_buffer(_WAIT_US)
        while buffer is not None:
            self.heard = time.monotonic()
            self._add(buffer)
            self._stream.push_buffer(buffer)
            buffer = self._stream.try_pop_buffer()

    def take(self, count: int) -> tuple[Lines, list[Lost]]:
        """The next lines, and which of them were lost."""
        taken: list[Lines] = []
        left = count
        while left:
            batch = self._held.popleft()
            if len(batch) > left:
                self._held.appendleft(batch[left:])
                batch = batch[:left]
            taken.append(batch)
            left -= len(batch)
        self._taken += count
        lost: list[Lost] = []
        later: list[Lost] = []
        for gap in self._lost:
            inside = min(gap.count, self._taken - gap.line)
            if inside > 0:
                lost.append(replace(gap, count=inside))
            if inside < gap.count:
                begin = gap.line + max(0, inside)
                later.append(replace(gap, line=begin, count=gap.line + gap.count - begin))
        self._lost = later
        return np.concatenate(taken), lost

    def _add(self, buffer: Any) -> None:
        number = int(buffer.get_frame_id())
        if self._next_id is None:
            self._next_id = min(number, 1)
            self.began_with = number if number - self._next_id > self._buffers else None
        if self.began_with is not None:
            return  # nobody can tell where its lines belong
        missing = (number - self._next_id) % _FRAME_IDS if number <= _FRAME_IDS else number - self._next_id
        if missing < 0 or missing > _FRAME_IDS // 2:
            return  # an older one that came late: its place is filled already
        self._lose(missing)
        self._next_id = number % _FRAME_IDS + 1 if number <= _FRAME_IDS else number + 1
        whole = buffer.get_status() == self._aravis.BufferStatus.SUCCESS
        data = buffer.get_data() if whole else b""
        if len(data) < self._rows * self._frame_lines:
            self._lose(1)
            return
        frame = np.frombuffer(data, np.uint8, self._rows * self._frame_lines).reshape(-1, self._rows)
        if self._before is None:
            self._before = frame[0].copy()
            self._lose(self._lost_first)
        self._keep(frame.copy())

    def _lose(self, frames: int) -> None:
        """Frames that are missing; those before the first are copies of its first line."""
        if self._before is None:
            self._lost_first += frames
            return
        for _ in range(frames):
            self._lost.append(Lost(self.number, self.lines, self._frame_lines))
            self._keep(np.repeat(self._before[None], self._frame_lines, axis=0))

    def _keep(self, lines: Lines) -> None:
        self._held.append(lines)
        self.lines += len(lines)
        self._before = lines[-1]

    def _control_lost(self, _device: object) -> None:
        self.lost_control = True


def require_aravis() -> Any:
    """Aravis's Python module. Raises BadInput that says how to get it."""
    try:
        import gi

        gi.require_version("Aravis", "0.8")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ImportWarning)  # of PyGObject's own importer
            from gi.repository import Aravis
    except (ImportError, ValueError) as error:
        raise BadInput("commands-stream-no-aravis", error=str(error)) from None
    return Aravis
