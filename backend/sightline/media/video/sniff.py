"""What a file is by its first bytes, so that a refusal can say so in words.

FFmpeg answers "Invalid data found" to an empty file, a letter and a film cut before its index alike;
people need to be told which of these it is.
"""

from __future__ import annotations

from pathlib import Path

HEAD_BYTES = 4096
_STILLS = (
    (b"\x89PNG\r\n\x1a\n", "is a PNG picture, not a video"),
    (b"\xff\xd8\xff", "is a JPEG picture, not a video"),
    (b"GIF8", "is a GIF picture, not a video"),
    (b"BM", "is a BMP picture, not a video"),
    (b"II*\x00", "is a TIFF picture, not a video"),
    (b"MM\x00*", "is a TIFF picture, not a video"),
    (b"II+\x00", "is a TIFF picture, not a video"),
)
STILL_BRANDS = (b"heic", b"heix", b"mif1", b"avif", b"avis", b"msf1")
_PLAYLISTS = (
    b"#EXTM3U",
    b"ffconcat",
    b"<?xml",
    b"<MPD",
    b"[playlist]",
    b"<smil",
    b"<asx",
    b"v=0\r\n",
    b"v=0\n",
)
OTHERS = (
    (b"PK\x03\x04", "is a zip archive, not a video"),
    (b"%PDF", "is a PDF document, not a video"),
    (b"\x1f\x8b", "is a gzip archive, not a video"),
    (b"Rar!", "is a RAR archive, not a video"),
    (b"7z\xbc\xaf", "is a 7z archive, not a video"),
    (b"fLaC", "is an audio file, not a video"),
    (b"ID3", "is an audio file, not a video"),
    (b"OggS", "is an Ogg file, which this program does not read, not a video"),
)


def why_not_video(path: Path) -> str | None:
    """Half a sentence that says why the file is no video ("is empty"), or None if its first bytes do not
    tell.

    Raises OSError if the file cannot be read.
    """
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    if not head:
        return "is empty"
    return _playlist(head) or _still(head) or _other(head) or _cut_before_index(path, head)


def _playlist(head: bytes) -> str | None:
    start = head.lstrip(b"\xef\xbb\xbf \t\r\n")
    if any(start[:16].lower().startswith(mark.lower()) for mark in _PLAYLISTS):
        return "is a playlist that points to other files, not a video"
    return None


def _still(head: bytes) -> str | None:
    for mark, what in _STILLS:
        if head.startswith(mark):
            return what
    if head[:4] == b"RIFF" and head[8:12] == b"WEBP":
        return "is a WebP picture, not a video"
    if head[4:8] == b"ftyp" and head[8:12] in STILL_BRANDS:
        return "is a HEIF or AVIF picture, not a video"
    return None


def _other(head: bytes) -> str | None:
    for mark, what in OTHERS:
        if head.startswith(mark):
            return what
    if head[:4] == b"RIFF" and head[8:12] == b"WAVE":
        return "is an audio file, not a video"
    if _is_text(head):
        return "is a text file, not a video"
    return None


def _is_text(head: bytes) -> bool:
    if b"\x00" in head:
        return False
    try:
        text = head.decode("utf-8", errors="strict" if len(head) < HEAD_BYTES else "ignore")
    except UnicodeDecodeError:
        return False
    odd = sum(not (c.isprintable() or c in "\r\n\t\f") for c in text)
    return odd <= len(text) // 100


def _cut_before_index(path: Path, head: bytes) -> str | None:
    """An MP4 or MOV without its `moov` box: the recorder was switched off or the copy was broken off."""
    if head[4:8] not in (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip"):
        return None
    end = path.stat().st_size
    offset = 0
    with path.open("rb") as file:
        for _ in range(10_000):
            file.seek(offset)
            box = file.read(16)
            if len(box) < 8:
                break
            size = int.from_bytes(box[:4], "big")
            if size == 1:
                size = int.from_bytes(box[8:16], "big")
            if box[4:8] in (b"moov", b"moof"):
                return "is cut off in the middle of its index (moov)" if offset + size > end else None
            if size < 8:
                break
            offset += size
    return "is cut off before its index (moov) was written"
