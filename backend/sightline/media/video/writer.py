"""Writing video: H.264 in MP4 for the demonstration survey."""

from collections.abc import Iterable
from contextlib import closing
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
from numpy.typing import NDArray

from sightline.errors import BadInput
from sightline.media.atomic import atomic_file
from sightline.media.store.local import no_room_told


def write_mp4(
    path: Path,
    frames: Iterable[NDArray[np.uint8]],
    fps: float | Fraction,
    *,
    crf: int = 18,
    gop: int = 25,
    preset: str = "veryfast",
) -> int:
    """Encode BGR frames (h, w, 3), all of one size, as H.264 in MP4; the file appears whole or not at all.

    `frames` may be fed by a process pool (`pool.imap`); a generator that yields frames of several finished
    chunks in turn does the same. Width and height must be even. Returns how many frames were written.
    Raises BadInput for no frames, odd or changing sizes, and NoRoom on a full disk.
    """
    rate = Fraction(fps).limit_denominator(1001)
    with no_room_told(), atomic_file(path) as part:
        return _encode(part, path.name, frames, rate, crf, gop, preset)


def _encode(
    part: Path,
    name: str,
    frames: Iterable[NDArray[np.uint8]],
    rate: Fraction,
    crf: int,
    gop: int,
    preset: str,
) -> int:
    count = 0
    with closing(av.open(str(part), "w", format="mp4", options={"movflags": "+faststart"})) as container:
        stream = container.add_stream("libx264", rate=rate)
        stream.pix_fmt = "yuv420p"
        stream.gop_size = gop
        stream.options = {"crf": str(crf), "preset": preset}
        for image in frames:
            if count == 0:
                stream.height, stream.width = image.shape[:2]
            width, height = stream.width, stream.height
            if image.shape != (height, width, 3) or width % 2 or height % 2:
                raise BadInput("video-frame-form", name=name, shape=image.shape, width=width, height=height)
            frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(image), format="bgr24")
            frame.pts, frame.time_base = count, 1 / rate
            container.mux(stream.encode(frame))
            count += 1
        if count == 0:
            raise BadInput("video-no-frames-written", name=name)
        container.mux(stream.encode(None))
    return count
