"""Two strips cut from an ordinary video: one column or row of pixels each, a line a frame.

A line scan needs a steady clock, so only a recording of constant frame rate will do: its line rate is its
frame rate. Frames are counted as everywhere (the n-th that a sequential decode puts out), pixels are upright.
"""

import os
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sightline.enums import CutAlong
from sightline.errors import BadInput
from sightline.media.cancelling import Cancelled, check_cancelled
from sightline.media.store.local import check_room, no_room_told
from sightline.media.strips.notes import StripNotes
from sightline.media.strips.reader import Strip, strip_of
from sightline.media.strips.sheet import RawSheet
from sightline.media.video.decode import frames_of, require_whole
from sightline.media.video.picture import Gray
from sightline.media.video.report import JITTER, ROUNDING

LEAST_FRAMES = 20
_AT_ONCE = 256


def line_rate(time_s: NDArray[np.float64], name: str, tick_s: float = 0.001) -> float:
    """The constant frame rate (Hz) of a recording by its frame times (n,), from its frame table.

    `tick_s`: the unit of the file's time stamps, which are rounded to it. Raises BadInput where frames are
    missing or come at uneven times, by the rule of the ingest: the strips would be stretched there.
    """
    count = len(time_s)
    if count < LEAST_FRAMES:
        raise BadInput("strips-too-few-frames", name=name, count=count)
    step_s = float(time_s[-1] - time_s[0]) / (count - 1)
    off_s = np.abs(time_s - (time_s[0] + step_s * np.arange(count)))
    if step_s <= 0 or float(off_s.max()) > max(ROUNDING * tick_s, JITTER * step_s):
        at = int(np.argmax(np.abs(np.diff(time_s) - np.median(np.diff(time_s)))))
        raise BadInput("strips-rate-uneven", name=name, at=at)
    return 1.0 / step_s


def cut_strips(
    path: Path,
    cuts_px: tuple[int, int],
    time_s: NDArray[np.float64],
    *,
    along: CutAlong = "columns",
    work_dir: Path | None = None,
    name: str | None = None,
    on_progress: Callable[[float], None] = lambda _: None,
    is_cancelled: Cancelled = lambda: False,
    stream_number: int | None = None,
) -> tuple[Strip, Strip]:
    """The strips of two pixel columns or rows, the first one being what vehicles reach first; the video is
    decoded once.

    `time_s` (n,) are the times of its frame table. The pixels lie in two nameless temporary files in
    `work_dir` until the strips are closed. Raises BadInput (uneven frames, cuts outside the picture or the
    same twice, another number of frames than the table has), NoRoom, Stopped.
    """
    name = name or path.name
    require_whole(path, name, stream_number)
    rate_hz = line_rate(time_s, name)
    folder = work_dir or Path(tempfile.gettempdir())
    with (
        tempfile.TemporaryFile(dir=folder) as first,
        tempfile.TemporaryFile(dir=folder) as second,
        no_room_told(),
    ):
        rows = count = 0
        for n, _, upright in frames_of(path, name, stream_number):
            gray = _turn_along_traffic(upright, along)
            if n == 0:
                rows = gray.shape[0]
                _check_cuts(cuts_px, gray.shape[1], along, name)
                check_room(folder, 2 * rows * len(time_s))
            if n % _AT_ONCE == 0:
                check_cancelled(is_cancelled, name)
                on_progress(min(0.99, n / len(time_s)))
            for file, column in zip((first, second), cuts_px, strict=True):
                file.write(gray[:, column].tobytes())
            count = n + 1
        if count != len(time_s):
            raise BadInput("strips-frames-changed", name=name, count=count, count_2=len(time_s))
        strips = []
        for camera, file in enumerate((first, second), 1):
            file.flush()
            sheet = RawSheet(
                os.dup(file.fileno()),
                f"camera {camera} of {name}",
                (count, rows),
                np.uint8,
                lambda lines: lines * rows,
            )
            strips.append(strip_of(sheet, "height", StripNotes(rate_hz)))
    on_progress(1.0)
    return strips[0], strips[1]


def _turn_along_traffic(gray: Gray, along: CutAlong) -> Gray:
    """The picture (rows, columns) turned so that traffic runs to the left or right, roofs up."""
    if along == "columns":
        return gray
    return gray.T if along == "rows_left_up" else gray[:, ::-1].T


def _check_cuts(cuts_px: tuple[int, int], size_px: int, along: CutAlong, name: str) -> None:
    if not all(0 <= cut < size_px for cut in cuts_px) or cuts_px[0] == cuts_px[1]:
        raise BadInput(
            "strips-cuts-unusable",
            what="columns" if along == "columns" else "rows",
            cut_1=cuts_px[0],
            cut_2=cuts_px[1],
            name=name,
            last_px=size_px - 1,
        )
