"""The frame table of a video, as arrays."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False, slots=True)
class FrameTable:
    """Frame n is row n. `pts` in the stream's time base, `time_s` from the first frame, `crc32` of the
    luma.

    `pts` is what the file says. Decoders show frames in order, so where the file's time stamps are not in
    order (AVI writes those of the packets), `time_s` holds the same times, sorted. Shapes (N,), dtypes int64,
    float64, bool and uint32; not writeable.
    """

    pts: NDArray[np.int64]
    time_s: NDArray[np.float64]
    key: NDArray[np.bool_]
    crc32: NDArray[np.uint32]

    def __post_init__(self) -> None:
        for array in (self.pts, self.time_s, self.key, self.crc32):
            array.setflags(write=False)

    def __len__(self) -> int:
        return len(self.pts)
