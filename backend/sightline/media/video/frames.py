"""Stills by frame number: what a decoder gives, and caches of encoded pictures bounded in bytes."""

from collections.abc import Iterable
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from sightline.enums import Display
from sightline.errors import BadInput, NotFound
from sightline.media.video.caches import DiskCache, MemoryCache
from sightline.media.video.picture import Bgr, Gray
from sightline.media.video.prefetch import Prefetcher
from sightline.media.video.seeker import RecordingMedia
from sightline.media.video.window import CancelCheck, NoLongerWanted, Window, is_always_wanted

if TYPE_CHECKING:
    from sightline.media.video.decode_host import DecodeHost

MOST_CROP_PX = 4096 * 4096
MOST_CROP_SCALE = 16
__all__ = ["FrameServer", "NoLongerWanted", "RecordingMedia"]


class FrameServer:
    """Serves frame n of a recording as it was numbered at ingest, or an error; never another picture.

    Frames come from `pictures`: a decoder in this process unless another is given, which then also makes the
    next ones before they are asked for. Memory holds frames (three quarters, where they are decoded) and
    JPEGs (a quarter, here); the disk holds JPEGs. Thread-safe. `wanted` (asked between frames) lets a caller
    give up: the answer is then NoLongerWanted.

    All methods raise NotFound for an n outside the table, Damaged if the file does not give the frame whose
    checksum is in the table, or is missing.
    """

    def __init__(
        self,
        cache_dir: Path,
        memory_bytes: int,
        disk_bytes: int,
        *,
        max_open: int = 4,
        pictures: "DecodeHost | None" = None,
    ) -> None:
        self._pictures: DecodeHost | Window = pictures or Window(memory_bytes * 3 // 4, max_open=max_open)
        self._jpegs: MemoryCache[bytes] = MemoryCache(memory_bytes // 4, len)
        self._disk = DiskCache(cache_dir / "stills", disk_bytes)
        self._prefetcher = Prefetcher(self._jpegs, pictures, _key) if pictures else None

    def still(
        self,
        media: RecordingMedia,
        n: int,
        wanted: CancelCheck = is_always_wanted,
        display: Display = "plain",
    ) -> bytes:
        """Frame n as JPEG (95), upright, square pixels, colour as recorded; "bright": to look at only."""
        _check(media, n)
        key = _key(media, n, display)
        data = self._jpegs.get(key) or (self._prefetcher.coming(key, wanted) if self._prefetcher else None)
        if data is None:
            data = self._disk.get(key)
            if data is None:
                with self._prefetcher.first() if self._prefetcher else nullcontext():
                    data = self._pictures.still(media, n, wanted, display)
                self._disk.put(key, data)
            self._jpegs.put(key, data)
        if self._prefetcher and display == "plain":
            self._prefetcher.asked(media, n, len(data))
        return data

    def prepare(self, media: RecordingMedia, n: int, wanted: CancelCheck = is_always_wanted) -> int:
        """Have frame n ready on disk before somebody asks; its size there in bytes."""
        _check(media, n)
        key = _key(media, n, "plain")
        size = self._disk.size(key)
        if size is not None:
            return size
        data = self._jpegs.get(key) or self._pictures.still(media, n, wanted, "plain", ahead=True)
        self._disk.put(key, data)
        return len(data)

    def bgr(self, media: RecordingMedia, n: int, wanted: CancelCheck = is_always_wanted) -> Bgr:
        """Frame n, (height_px, width_px, 3) BGR."""
        _check(media, n)
        return self._pictures.bgr(media, n, wanted)

    def gray(self, media: RecordingMedia, n: int, wanted: CancelCheck = is_always_wanted) -> Gray:
        """Frame n, (height_px, width_px) luminance."""
        _check(media, n)
        return self._pictures.gray(media, n, wanted)

    def crop_png(
        self,
        media: RecordingMedia,
        n: int,
        x: int,
        y: int,
        w: int,
        h: int,
        scale: int = 1,
        display: Display = "plain",
        wanted: CancelCheck = is_always_wanted,
    ) -> bytes:
        """The rectangle of w x h pixels whose top-left pixel is (x, y), lossless; each pixel `scale`
        times as large.

        What lies outside the picture is black, so the crop always has the size that was asked for.
        Raises BadInput for a size or scale out of bounds.
        """
        if not 1 <= scale <= MOST_CROP_SCALE or w < 1 or h < 1 or w * h * scale * scale > MOST_CROP_PX:
            raise BadInput("video-crop-outside", w=w, h=h, scale=scale)
        _check(media, n)
        return self._pictures.crop_png(media, n, (x, y, w, h, scale), wanted, display)

    def image(self, data: bytes, name: str) -> Gray:
        """A still picture's file as luminance, (h, w), decoded where frames are; BadInput names it."""
        return self._pictures.image(data, name, colour=False)

    def image_bgr(self, data: bytes, name: str, most_px: int | None = None) -> Bgr:
        """Like `image`, but (h, w, 3) BGR; made smaller there if a side is longer than `most_px`."""
        return self._pictures.image(data, name, colour=True, most_px=most_px)

    def ready(self, media: RecordingMedia) -> list[tuple[int, int]]:
        """Runs (first, last) of the frames that are answered without decoding: the window's and the disk's.

        The disk's are told by name and not read; a still that is spoilt there is made anew when asked for.
        """
        kept = (name.split("-") for name in self._disk.names(media.identity))
        on_disk = (int(parts[0]) for parts in kept if len(parts) == 2 and parts[0].isdigit())
        return runs({*self._pictures.warm(media), *on_disk})

    @property
    def memory_bytes(self) -> int:
        """What the caches in the memory of this process hold now."""
        return self._pictures.memory_bytes + self._jpegs.held_bytes

    @property
    def process_id(self) -> int | None:
        """Of the child that decodes; None while there is none."""
        return getattr(self._pictures, "process_id", None)

    def start(self) -> None:
        """Make ready for the first frame, which then does not wait for a process to start."""
        self._pictures.start()

    def close(self) -> None:
        """Close all decoders; caches stay. The server opens them again when asked."""
        if self._prefetcher:
            self._prefetcher.close()
        self._pictures.close()


def runs(numbers: Iterable[int]) -> list[tuple[int, int]]:
    """Runs of consecutive numbers as (first, last), in order."""
    spans: list[tuple[int, int]] = []
    for n in sorted(numbers):
        if spans and spans[-1][1] == n - 1:
            spans[-1] = (spans[-1][0], n)
        else:
            spans.append((n, n))
    return spans


def _key(media: RecordingMedia, n: int, display: Display = "plain") -> str:
    kind = "" if display == "plain" else f"-{display}"
    return f"{media.identity}/{n // 1000}/{n}-{int(media.crc[n]):08x}{kind}.jpg"


def _check(media: RecordingMedia, n: int) -> None:
    if not 0 <= n < len(media):
        raise NotFound("video-frame-outside", n=n, last=len(media) - 1)
