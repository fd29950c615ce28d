"""Luminance read from its plane is the luminance FFmpeg converts to, to the bit."""

from fractions import Fraction

import av
import numpy as np
import pytest

from sightline.media.video.picture import layout_of, upright_gray


@pytest.mark.parametrize("pixels", ["yuv420p", "yuv444p", "nv12", "yuvj420p", "gray", "bgr24"])
@pytest.mark.parametrize("colour_range", [0, 1, 2])
def test_plane_and_conversion_agree(pixels: str, colour_range: int) -> None:
    ramp = np.arange(64 * 96, dtype=np.uint8).reshape(64, 96)
    frame = av.VideoFrame.from_ndarray(np.dstack([ramp, ramp.T.reshape(64, 96), ramp]), "bgr24")
    frame = frame.reformat(format=pixels)
    frame.color_range = colour_range
    wanted = frame.reformat(format="gray").to_ndarray()
    assert np.array_equal(upright_gray(frame, layout_of(frame, Fraction(1))), wanted)
    assert len(np.unique(wanted)) > 100
