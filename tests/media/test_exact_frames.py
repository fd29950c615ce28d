"""Every frame carries its number in the picture: zero wrong frames, whatever wrote the file."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from sightline.errors import Damaged
from sightline.media.video.decode import frames_of
from sightline.media.video.frames import FrameServer
from sightline.media.video.picture import upright_picture
from sightline.media.video.seeker import Decoded, Seeker
from tests.media.clips import SPECS, X264_B, Spec, cut_copy, read_number, write
from tests.media.conftest import Clip, Ingest, media_of
from tests.support.proofs import every

BACK = {0: None, 90: cv2.ROTATE_90_CLOCKWISE, 180: cv2.ROTATE_180, -90: cv2.ROTATE_90_COUNTERCLOCKWISE}


def access_orders(count: int) -> dict[str, list[int]]:
    """Random jumps, every frame forward, every frame backward, and steps to and fro across a key frame."""
    mixed = list(range(count))
    random.Random(7).shuffle(mixed)
    return {
        "random": mixed[:40],
        "forward": list(range(count)),
        "backward": list(range(count - 1, -1, -1)),
        "to and fro": [n for k in range(count // 3, count // 3 + 6) for n in (k, k + 2, k - 1)],
    }


def four_frames(spec: Spec) -> int:
    """Bytes of a cache that holds no more: nearly every request has to seek and decode."""
    return 4 * 200_000 * spec.size[0] * spec.size[1] // (320 * 240)


def number_in(image: NDArray[np.uint8], spec: Spec) -> int:
    code = BACK[spec.rotation]
    return read_number(image if code is None else cv2.rotate(image, code))


ORDERS = tuple(access_orders(1))
#: Raw pictures that are not in the order of their packets, more bits than eight, all colours in one plane.
READ_APART = ("bframes.h264", "ten_bit.mkv", "cinepak.avi")
IN_EVERY_ORDER = [pytest.param(spec, ORDERS, id=spec.name) for spec in SPECS[::6]]
IN_EVERY_ORDER += [
    pytest.param(spec, ORDERS[:1], id=f"{spec.name} random")
    for n, spec in enumerate(SPECS)
    if n % 2 == 0 < n % 6 or spec.name in READ_APART
]
IN_EVERY_ORDER += [
    pytest.param(spec, ORDERS, id=spec.name, marks=pytest.mark.proof) for n, spec in enumerate(SPECS) if n % 6
]


@pytest.mark.parametrize(("spec", "orders"), IN_EVERY_ORDER)
def test_no_frame_is_wrong(
    spec: Spec, orders: tuple[str, ...], clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    result = take_in(clip(spec))
    media = media_of(result)
    assert len(media) == spec.count
    asked = access_orders(spec.count)
    for order in orders:
        numbers = asked[order] if len(orders) > 1 else asked[order][:20]
        server = FrameServer(tmp_path / order, four_frames(spec), 1_000_000)
        wrong = [n for n in numbers if number_in(server.bgr(media, n), spec) != n]
        assert wrong == [], order
    assert np.all(np.diff(result.frames.time_s) > 0)


@pytest.mark.parametrize("spec", every(2, SPECS), ids=lambda s: s.name)
def test_clips_are_read_in_the_same_order(spec: Spec, clip: Clip) -> None:
    read = [(n, number_in(gray, spec)) for n, _, gray in frames_of(clip(spec))]
    assert read == [(n, n) for n in range(spec.count)]


# P frames that look back past B frames: leaving these out spoils what follows
_PAST_B = "keyint=250:min-keyint=250:scenecut=0:bframes=5:b-adapt=0:b-pyramid=normal:ref=5"
_LONG_B = tuple((key, value.replace("keyint=24", "keyint=250")) for key, value in X264_B)
_JUMPS = {
    "B frames": (Spec("b.mp4", options=_LONG_B, b_frames=3, gop=250), 25),
    "B frames in AVI": (Spec("b.avi", options=_LONG_B, b_frames=3, gop=250), 30),
    "B frames in TS": (Spec("b.ts", options=_LONG_B, b_frames=3, gop=250), 25),
    "B frames that others need": (
        Spec("past.mp4", options=(("preset", "superfast"), ("x264-params", _PAST_B)), b_frames=5, gop=250),
        36,
    ),
    "MPEG-4 part 2": (Spec("p2.avi", codec="mpeg4", options=(), b_frames=2, gop=250), 35),
    "HEVC": (replace(next(s for s in SPECS if s.name == "hevc.mkv"), gop=250), 45),
    "no B frames": (Spec("one_key.mp4", gop=250), 73),
}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.proof) if name in ("B frames in AVI", "HEVC") else name
        for name in _JUMPS
    ],
)
def test_a_jump_leaves_out_frames_and_is_exact(name: str, clip: Clip, take_in: Ingest) -> None:
    spec, most = _JUMPS[name]
    media = media_of(take_in(clip(spec)))
    steps, jumps = Seeker(media), Seeker(media)
    whole = [picture(steps.find(n)) for n in range(len(media))]
    kept: set[int] = set()
    jumps.keep = lambda n, frame, layout: kept.add(n)
    assert np.array_equal(picture(jumps.find(72, jump=True)), whole[72])
    assert set(range(68, 73)) <= kept, "for steps back"
    assert len(kept) <= most
    for n in (30, 79, 11, 55):
        assert np.array_equal(picture(jumps.find(n, jump=True)), whole[n]), n


def picture(found: Decoded | None) -> NDArray[np.uint8]:
    assert found is not None
    return upright_picture(*found)


@pytest.mark.parametrize("source", every(2, ["bframes.mp4", "open_gop.mp4", "hevc.mp4"]))
def test_frames_hidden_by_an_edit_list_are_no_frames(
    source: str, clip: Clip, tmp_path: Path, take_in: Ingest
) -> None:
    spec = next(s for s in SPECS if s.name == source)
    result = take_in(cut_copy(clip(spec), tmp_path / "cut.mp4", 1.5))
    media = media_of(result)
    server = FrameServer(tmp_path / "cache", four_frames(spec), 1_000_000)
    first = read_number(server.bgr(media, 0))
    assert first > 24, "the cut hides frames"
    for numbers in access_orders(len(media)).values():
        assert [read_number(server.bgr(media, n)) - first for n in numbers if n < len(media)] == [
            n for n in numbers if n < len(media)
        ]


@pytest.mark.parametrize("rotation", [90, 180, -90])
def test_rotation_is_the_one_other_players_show(rotation: int, tmp_path: Path, take_in: Ingest) -> None:
    path = write(tmp_path / "turned.mp4", Spec("turned.mp4", rotation=rotation), 5)
    result = take_in(path)
    server = FrameServer(tmp_path / "cache", 8_000_000, 1_000_000)
    ours = server.bgr(media_of(result), 0)
    reader = cv2.VideoCapture(str(path))
    theirs = reader.read()[1]
    assert ours.shape == theirs.shape == (result.facts.height_px, result.facts.width_px, 3)
    assert np.abs(ours.astype(int) - theirs.astype(int)).mean() < 3


def test_square_pixels_are_told_and_served(tmp_path: Path, take_in: Ingest, server: FrameServer) -> None:
    spec = next(s for s in SPECS if s.name == "wide_pixels.mp4")
    result = take_in(write(tmp_path / spec.name, spec, 3))
    facts = result.facts
    assert (facts.coded_width_px, facts.coded_height_px) == (320, 240)
    assert (facts.width_px, facts.height_px) == (427, 240)
    assert server.gray(media_of(result), 2).shape == (240, 427)
    assert any("4/3" in str(note) for note in result.report.notes)


def test_full_range_is_not_stretched_twice(tmp_path: Path, take_in: Ingest, server: FrameServer) -> None:
    greys = []
    for spec in (Spec("limited.mp4"), Spec("full.mp4", pix_fmt="yuvj420p")):
        result = take_in(write(tmp_path / spec.name, spec, 2))
        greys.append(server.gray(media_of(result), 1).astype(int))
    assert np.abs(greys[0] - greys[1]).mean() < 3


def test_a_frame_that_is_not_the_one_in_the_table_is_an_error(
    tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    first = take_in(write(tmp_path / "a.mp4", Spec("a.mp4"), 30))
    media = media_of(first)
    crc = media.crc.copy()
    crc[12] ^= 1
    forged = type(media)(media.path, media.pts, crc, media.key)
    with pytest.raises(Damaged, match="Frame 12 cannot be shown"):
        server.still(forged, 12)
    assert read_number(server.bgr(forged, 13)) == 13
    with pytest.raises(Damaged):
        server.still(forged, 12)


def test_another_video_under_the_same_table_gives_errors_not_pictures(
    tmp_path: Path, take_in: Ingest, server: FrameServer
) -> None:
    media = media_of(take_in(write(tmp_path / "a.mp4", Spec("a.mp4"), 30)))
    other = write(tmp_path / "b.mp4", Spec("b.mp4", size=(192, 160)), 30)
    swapped = type(media)(other, media.pts, media.crc, media.key)
    for n in (0, 7, 29):
        with pytest.raises(Damaged):
            server.still(swapped, n)
