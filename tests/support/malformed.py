"""Malformed camera files and videos, made up by someone who had not read the readers, each with its fault.

`python -m tests.support.malformed OUT` writes them all, to be tried by hand.
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import av

from tests.media.clips import QVGA, X264_B, Spec, write

MATRIX = "[900.5, 0.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0, 1.0]"
NO_LENS = "[-0.1, 0.02, 0.0, 0.0, 0.0]"


def opencv(matrix: str = MATRIX, lens: str = NO_LENS, size: tuple[object, object] = (1280, 720)) -> str:
    """A camera file as ROS and OpenCV write it, with one thing changed."""
    cells = lens.count(",") + 1
    return (
        f"image_width: {size[0]}\nimage_height: {size[1]}\ncamera_name: road\n"
        f"camera_matrix:\n  rows: 3\n  cols: 3\n  data: {matrix}\n"
        "distortion_model: plumb_bob\n"
        f"distortion_coefficients:\n  rows: 1\n  cols: {cells}\n  data: {lens}\n"
    )


def _bomb() -> str:
    rows = ["a0: &a0 [x, x, x, x, x, x, x, x, x, x]"]
    rows += [f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 10)}]" for k in range(1, 9)]
    return "\n".join([*rows, "camera_matrix: *a8", ""])


CAMERA_FILES: dict[str, bytes] = {
    # matrices
    "transposed.yaml": opencv("[900.5, 0.0, 0.0, 0.0, 901.2, 0.0, 640.2, 358.9, 1.0]").encode(),
    "not_a_number.yaml": opencv("[.nan, 0.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0, 1.0]").encode(),
    "endless.yaml": opencv(lens="[-0.1, .inf, 0.0, 0.0, 0.0]").encode(),
    "negative_focal.yaml": opencv("[-900.5, 0.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0, 1.0]").encode(),
    "shares_of_the_width.yaml": opencv("[0.703, 0.0, 0.5, 0.0, 0.704, 0.28, 0.0, 0.0, 1.0]").encode(),
    "eight_numbers.yaml": opencv("[900.5, 0.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0]").encode(),
    "skewed.yaml": opencv("[900.5, 25.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0, 1.0]").encode(),
    "scaled_by_two.yaml": opencv("[1801.0, 0.0, 1280.4, 0.0, 1802.4, 717.8, 0.0, 0.0, 2.0]").encode(),
    "decimal_commas.yaml": opencv("['900,5', 0, '640,2', 0, '901,2', '358,9', 0, 0, 1]").encode(),
    "words_for_numbers.yaml": opencv("[yes, 0.0, 640.2, 0.0, 901.2, 358.9, 0.0, 0.0, 1.0]").encode(),
    "of_another_size.yaml": opencv("[2400.0, 0.0, 1920.0, 0.0, 2400.0, 1080.0, 0.0, 0.0, 1.0]").encode(),
    # lenses
    "six_coefficients.yaml": opencv(lens="[-0.1, 0.02, 0.0, 0.0, 0.0, 0.01]").encode(),
    "fourteen_coefficients.yaml": opencv(lens="[" + ", ".join(["0.01"] * 14) + "]").encode(),
    "unknown_lens.yaml": opencv().replace("plumb_bob", "division").encode(),
    "lens_of_pixels.yaml": opencv(lens="[-80000.0, 1.0, 0.0, 0.0, 0.0]").encode(),
    # sizes
    "no_width.yaml": opencv(size=(0, 720)).encode(),
    "half_a_pixel.yaml": opencv(size=(1280.5, 720)).encode(),
    "turned_size.yaml": opencv(size=(720, 1280)).encode(),
    "enormous.json": b'{"image_width": 1'
    + b"0" * 400
    + b', "image_height": 720, "camera_matrix": [[900,0,640],'
    b'[0,900,360],[0,0,1]], "distortion_coefficients": [0.1,0,0,0,0]}',
    # files
    "written_twice.yaml": (
        opencv() + "camera_matrix:\n  rows: 3\n  cols: 3\n  data: " + MATRIX.replace("900.5", "450.25") + "\n"
    ).encode(),
    "powershell.yaml": b"\xff\xfe" + opencv().encode("utf-16-le"),
    "latin_one.yaml": opencv().replace("road", "Stra\xdfe").encode("latin-1"),
    "tabs.yaml": opencv().replace("  ", "\t").encode(),
    "half.yaml": opencv().encode()[:110],
    "empty.yaml": b"",
    "only_a_comment.yaml": b"# calibrated in May\n",
    "picture.yaml": b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR" + bytes(range(256)),
    "nested.json": b"[" * 100_000,
    "bomb.yaml": _bomb().encode(),
    "command.yaml": b"camera_matrix: !!python/object/apply:os.system ['true']\n",
    "a_list.yaml": b"- 900\n- 901\n",
    "newer.json": b'{"format": "sightline-camera-2", "fx_px": 900}',
    "a_page.json": b"<!DOCTYPE html><html><body>404 Not Found</body></html>",
    # Kalibr and mrcal
    "three_intrinsics.yaml": b"cam0:\n  camera_model: pinhole\n  intrinsics: [900.5, 901.2, 640.2]\n"
    b"  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.02, 0, 0]\n  resolution: [1280, 720]\n",
    "omni.yaml": b"cam0:\n  camera_model: omni\n  intrinsics: [1.2, 900.5, 901.2, 640.2, 358]\n"
    b"  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.02, 0, 0]\n  resolution: [1280, 720]\n",
    "short.cameramodel": b"{'lensmodel': 'LENSMODEL_OPENCV8', 'intrinsics': [900.5, 901.2, 640, 358, 0.1],"
    b" 'imagersize': [1280, 720]}\n",
    "code.cameramodel": b"{'lensmodel': __import__('os').getcwd(), 'imagersize': [1, 1]}\n",
}


def _changed(source: bytes, old: bytes, new: bytes, count: int = -1) -> bytes:
    if old not in source:
        raise ValueError(f"{old!r} is not in the file")
    return source.replace(old, new, count)


def _field(source: bytes, box: bytes, offset: int, value: bytes) -> bytes:
    """The bytes at `offset` behind a box's name exchanged."""
    at = source.index(box) + len(box) + offset
    return source[:at] + value + source[at + len(value) :]


def _times(path: Path, time_of: Callable[[int], int], count: int = 50) -> Path:
    """A transport stream or Matroska file whose packets carry the times given (1/90000 s), in file order."""
    source = write(
        path.with_suffix(".mkv" if path.suffix == ".ts" else ".ts"), Spec("x", size=QVGA, gop=10), count
    )
    with closing(av.open(str(source))) as read, closing(av.open(str(path), "w")) as out:
        stream = read.streams.video[0]
        copy = out.add_stream_from_template(stream)
        for n, packet in enumerate(p for p in read.demux(stream) if p.size):
            packet.time_base = stream.time_base
            shift = round(time_of(n) / 90_000 / stream.time_base)
            packet.pts = packet.dts = shift
            packet.stream = copy
            out.mux(packet)
    source.unlink()
    return path


def _join(path: Path, parts: list[Path]) -> None:
    path.write_bytes(b"".join(part.read_bytes() for part in parts))
    for part in parts:
        part.unlink()


def videos(folder: Path) -> dict[str, Path]:
    """Every malformed video, by name."""
    plain = write(folder / "plain.mp4", Spec("x", size=QVGA), 50).read_bytes()
    front = write(
        folder / "front.mp4", Spec("x", size=QVGA, muxer=(("movflags", "+faststart"),)), 50
    ).read_bytes()
    moved = write(folder / "moved.ts", Spec("x", size=QVGA, options=X264_B, b_frames=3), 50).read_bytes()
    avi = write(
        folder / "plain.avi", Spec("x", size=QVGA, codec="mjpeg", pix_fmt="yuvj420p", options=()), 30
    ).read_bytes()
    mkv = write(folder / "plain.mkv", Spec("x", size=QVGA), 50).read_bytes()
    rate = avi.index(b"vids") + 24  # the scale lies four bytes before it
    middle = len(moved) // 2 // 188 * 188
    made = {
        "no_timescale.mp4": _field(plain, b"mdhd", 12, struct.pack(">I", 0)),
        "a_tick_a_second.mp4": _field(plain, b"mdhd", 12, struct.pack(">I", 1)),
        "every_frame_at_once.mp4": _field(plain, b"stts", 12, struct.pack(">I", 0)),
        "backward_deltas.mp4": _field(plain, b"stts", 12, struct.pack(">i", -512)),
        "huge_samples.mp4": _field(plain, b"stsz", 12, b"\x7f\xff\xff\xff" * 5),
        "million_frames.mp4": _field(plain, b"stts", 8, struct.pack(">I", 2**31 - 1)),
        "unknown_codec.mp4": _changed(plain, b"avc1", b"zzzz"),
        "encrypted.mp4": _changed(plain, b"avc1\x00\x00\x00\x00", b"encv\x00\x00\x00\x00"),
        "turned_by_30.mp4": _field(plain, b"tkhd", 40, struct.pack(">5i", 56756, 32768, 0, -32768, 56756)),
        "mirrored.mp4": _field(plain, b"tkhd", 40, struct.pack(">5i", -65536, 0, 0, 0, 65536)),
        "text_mode.mp4": front.replace(b"\n", b"\r\n"),
        "front_cut.mp4": front[: len(front) * 2 // 3],
        "two_in_one.mp4": plain + plain,
        "mail_header.mp4": b"Content-Type: video/mp4\r\nContent-Transfer-Encoding: binary\r\n\r\n" + plain,
        "no_rate.avi": avi[:rate] + bytes(4) + avi[rate + 4 :],
        "million_a_second.avi": avi[: rate - 4] + struct.pack("<2I", 1, 10**6) + avi[rate + 4 :],
        "byte_more.ts": moved[: middle + 40] + b"\x55" + moved[middle + 40 :],
        "packets_lost.ts": moved[:middle] + moved[middle + 188 * 12 :],
        "started_again.ts": moved + moved,
        "killed.mkv": mkv[: len(mkv) * 3 // 5],
        "zeroed.mkv": mkv[: len(mkv) // 2] + bytes(3000) + mkv[len(mkv) // 2 + 3000 :],
    }
    for name, content in made.items():
        (folder / name).write_bytes(content)
    for name in ("plain.mp4", "front.mp4", "moved.ts", "plain.avi", "plain.mkv"):
        (folder / name).unlink()
    sizes = (QVGA, (640, 480))
    _join(
        folder / "two_sizes.ts",
        [write(folder / f"part{k}.ts", Spec("x", size=size), 25) for k, size in enumerate(sizes)],
    )
    _times(folder / "hours_missing.ts", lambda n: 3600 * n + (10 * 3600 * 90_000 if n >= 25 else 0))
    _join(
        folder / "clock_set_back.ts",
        [
            _times(folder / f"part{k}.ts", lambda n, begin=begin: 3600 * n + begin * 90_000, 25)
            for k, begin in enumerate((20, 1))
        ],
    )
    write(folder / "one_frame.mp4", Spec("x", size=QVGA), 1)
    return {p.name: p for p in sorted(folder.iterdir())}


def camera_files(folder: Path) -> dict[str, Path]:
    """Every malformed camera file, by name."""
    for name, content in CAMERA_FILES.items():
        (folder / name).write_bytes(content)
    return {name: folder / name for name in CAMERA_FILES}


def main(out: Path) -> None:
    for name, make in (("cameras", camera_files), ("videos", videos)):
        folder = out / name
        folder.mkdir(parents=True, exist_ok=True)
        make(folder)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
