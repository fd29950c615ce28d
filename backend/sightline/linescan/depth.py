"""Pictures of cameras of more than 8 bits, on the scale that limits of noise and contrast are set on."""

from dataclasses import replace
from typing import cast

import numpy as np

from sightline.linescan.parts import Passage, Pixels

_BITS, _WIDENED = 8, 257
#: Of cameras; a file holds 10 to 14 bits as numbers of 16.
DEPTHS = (8, 10, 12, 14, 16)


def depth_of(brightest: int) -> int:
    """The bits of a camera by the brightest pixel of its strip: the least of `DEPTHS` that holds it."""
    return next(depth for depth in DEPTHS if brightest < 1 << depth)


def brightest_of(picture: Pixels) -> int:
    """The brightest pixel of a picture (lines, rows); 0 of 8 bits, where nobody asks for it. Never fails."""
    return 0 if picture.dtype == np.uint8 else int(picture.max(initial=0))


def in_8_bits(passage: Passage, bits: int = _BITS) -> Passage:
    """The passage with pictures, roads and noise on the scale of 8 bits; one of 8 bits as it is.

    `bits`: of the camera, as far as its whole strip tells; one vehicle may be dark. Bits below the eighth are
    left out; they lie within the noise of a line's exposure. Pixels of 8 bits that a program widened to 16
    (times 257) are those 8 bits again.
    """
    if passage.first.dtype == np.uint8:
        return passage
    here = max(brightest_of(picture) for picture in (passage.first, passage.second))
    drop = max(bits, depth_of(here)) - _BITS
    first, second = ((picture >> drop).astype(np.uint8) for picture in (passage.first, passage.second))
    widened = all(
        np.array_equal(picture, np.uint16(_WIDENED) * few.astype(np.uint16))
        for picture, few in ((passage.first, first), (passage.second, second))
    )
    unit = _WIDENED if widened else 1 << drop
    return replace(
        passage,
        first=cast(Pixels, first),
        second=cast(Pixels, second),
        background_1=passage.background_1 / np.float32(unit),
        background_2=passage.background_2 / np.float32(unit),
        noise_dn=passage.noise_dn / unit,
    )
