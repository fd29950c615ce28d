"""From a decoded frame to upright, square pixels: the one place where rotation and pixel aspect are
applied.

Everything that shows or measures a picture goes through `upright_picture`, so a click, a detected corner and
a calibration speak of the same pixels.
"""

import math
import struct
import threading
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import av
import cv2
import imagecodecs
import numpy as np
from av.sidedata.sidedata import Type as SideDataType
from av.video.reformatter import Interpolation, VideoReformatter
from numpy.typing import NDArray

Gray = NDArray[np.uint8]
Bgr = NDArray[np.uint8]
_OF_THREAD = threading.local()
# Formats whose first plane is 8-bit luminance, 16 to 235 (ITU-R BT.601) unless the frame says otherwise.
_STUDIO_RANGE = frozenset(("yuv420p", "yuv422p", "yuv444p", "nv12"))
_TO_FULL_RANGE = np.clip(np.rint((np.arange(256) - 16.0) * 255.0 / 219.0), 0, 255).astype(np.uint8)


@dataclass(frozen=True)
class Layout:
    """How coded pixels become upright ones: transpose, then flip, then stretch to square pixels.

    `coded_width_px` x `coded_height_px` is the decoded frame; `width_px` x `height_px` the picture
    everybody sees. `sample_aspect` is the width of a coded pixel over its height. `left_turned_deg` is
    what the header asks for beyond the nearest quarter turn, and is not done.
    """

    coded_width_px: int
    coded_height_px: int
    transpose: bool = False
    flip_x: bool = False
    flip_y: bool = False
    sample_aspect: Fraction = Fraction(1)
    left_turned_deg: float = 0.0

    @property
    def square_width_px(self) -> int:
        """Width before rotation with square pixels; the shorter side is stretched, so no pixel is lost."""
        return max(1, round(self.coded_width_px * max(self.sample_aspect, Fraction(1))))

    @property
    def square_height_px(self) -> int:
        return max(1, round(self.coded_height_px / min(self.sample_aspect, Fraction(1))))

    @property
    def width_px(self) -> int:
        return self.square_height_px if self.transpose else self.square_width_px

    @property
    def height_px(self) -> int:
        return self.square_width_px if self.transpose else self.square_height_px

    @property
    def mirrored(self) -> bool:
        return self.transpose ^ self.flip_x ^ self.flip_y

    @property
    def rotation_deg(self) -> int:
        """Clockwise turn applied to the decoded frame: 0, 90, 180 or 270 (if mirrored: before the mirror)."""
        if self.transpose:
            return 90 if self.flip_x else 270
        return 180 if self.flip_y else 0


def layout_of(frame: av.VideoFrame, sample_aspect: Fraction | None) -> Layout:
    """The layout of a stream by its first frame (which carries the display matrix) and its pixel aspect."""
    transpose, flip_x, flip_y, left_deg = _turns(frame)
    aspect = sample_aspect if sample_aspect and sample_aspect > 0 else Fraction(1)
    return Layout(
        coded_width_px=frame.width,
        coded_height_px=frame.height,
        transpose=transpose,
        flip_x=flip_x,
        flip_y=flip_y,
        sample_aspect=aspect,
        left_turned_deg=left_deg,
    )


def _turns(frame: av.VideoFrame) -> tuple[bool, bool, bool, float]:
    """(transpose, flip_x, flip_y) of the display matrix, x' = a x + c y, y' = b x + d y (ISO 14496-12), and
    the degrees that are left of its turn.
    """
    side_data: Any = frame.side_data  # the stub knows no key type
    matrix = side_data.get(SideDataType.DISPLAYMATRIX)
    if matrix is None:
        return False, False, False, 0.0
    a, b, _, c, d = struct.unpack("=5i", bytes(matrix)[:20])
    left_deg = math.degrees(math.atan2(min(abs(a), abs(b)), max(abs(a), abs(b))))
    if abs(a) + abs(d) >= abs(b) + abs(c):
        return False, a < 0, d < 0, left_deg
    return True, c < 0, b < 0, left_deg


def upright_picture(frame: av.VideoFrame, layout: Layout) -> Bgr:
    """The picture as it is shown and measured: (height_px, width_px, 3) BGR, upright, square pixels."""
    return _apply_layout(_converted(frame, "bgr24"), layout)


def upright_gray(frame: av.VideoFrame, layout: Layout) -> Gray:
    """Like `upright_picture`, but luminance alone, (height_px, width_px), stretched to the full range
    0-255.
    """
    return _apply_layout(_luma(frame), layout)


def _luma(frame: av.VideoFrame) -> Gray:
    """Luminance in full range. Of the usual formats it is read from its plane: FFmpeg's result to the
    bit in less than half its time; the others are converted.
    """
    if frame.format.name not in _STUDIO_RANGE or int(frame.color_range) > 1:
        return _converted(frame, "gray")
    plane = frame.planes[0]
    rows = np.frombuffer(memoryview(plane), np.uint8).reshape(plane.height, plane.line_size)
    return np.asarray(cv2.LUT(rows[:, : plane.width], _TO_FULL_RANGE), np.uint8)


def upright_small(frame: av.VideoFrame, layout: Layout, width_px: int) -> Bgr:
    """Like `upright_picture`, shrunk to `width_px` before colours are converted: for thumbnails."""
    height_px = max(1, round(layout.height_px * width_px / layout.width_px))
    size = (height_px, width_px) if layout.transpose else (width_px, height_px)
    return _apply_layout(
        _converted(frame, "bgr24", size),
        replace(layout, coded_width_px=size[0], coded_height_px=size[1], sample_aspect=Fraction(1)),
    )


def _converted(
    frame: av.VideoFrame, pixel_format: str, size: tuple[int, int] | None = None
) -> NDArray[np.uint8]:
    """Pixels in another format. The converter belongs to the thread: frames in a cache are read by
    several at once, and the converter that PyAV hangs on a frame must not be.
    """
    converter = getattr(_OF_THREAD, "converter", None)
    if converter is None:
        converter = _OF_THREAD.converter = VideoReformatter()
    width, height = size or (frame.width, frame.height)
    how = Interpolation.AREA if size else None
    converted = converter.reformat(frame, width, height, pixel_format, interpolation=how, threads=1)
    return np.asarray(converted.to_ndarray(), np.uint8)


def _apply_layout(image: NDArray[np.uint8], layout: Layout) -> NDArray[np.uint8]:
    size = (layout.square_width_px, layout.square_height_px)
    if size != (image.shape[1], image.shape[0]):
        image = np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_CUBIC), np.uint8)
    if layout.transpose:
        image = np.asarray(cv2.transpose(image), np.uint8)
    if layout.flip_x or layout.flip_y:
        code = -1 if layout.flip_x and layout.flip_y else 1 if layout.flip_x else 0
        image = np.asarray(cv2.flip(image, code), np.uint8)
    return image


def luma_crc(frame: av.VideoFrame) -> int:
    """CRC-32 of the first plane as decoded (luma; packed formats: all of the picture), without row padding.

    Taken before rotation, stretching and colour conversion, so that it tells which frame the decoder
    gave and nothing else.
    """
    plane = frame.planes[0]
    rows = np.frombuffer(memoryview(plane), np.uint8).reshape(plane.height, -1)
    used = -(-plane.width * _first_plane_bits(frame) // 8)
    # libdeflate's is zlib's to the bit, in a sixth of its time
    data = np.ascontiguousarray(rows[:, :used]).data
    return int(imagecodecs.deflate_crc32(data))  # type: ignore[arg-type]  # any buffer will do


def _first_plane_bits(frame: av.VideoFrame) -> int:
    """Stored bits per pixel of plane 0: one component in planar formats, all of them in packed ones."""
    if frame.format.is_planar:
        return 8 * -(-frame.format.components[0].bits // 8)
    return frame.format.padded_bits_per_pixel


def has_half_chroma(frame: av.VideoFrame, layout: Layout) -> bool:
    """Whether colour is sampled at every other pixel and row (4:2:0) of the upright picture as well, so that
    a JPEG with the same sampling loses none of it.
    """
    halved = frame.format.chroma_width(64) == 32 and frame.format.chroma_height(64) == 32
    return halved and layout.sample_aspect == 1 and frame.width % 2 == 0 and frame.height % 2 == 0


def mean_luminance(gray: Gray) -> float:
    """Mean grey value, 0-255; what daytime and low light are told apart by."""
    return float(cv2.mean(gray)[0])
