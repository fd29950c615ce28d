"""Camera files as editors, half copies and other programs leave them, made up before the readers were read.

Each gives the right camera, or one sentence that names what is wrong.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from tests.support.app import Client, error_of
from tests.support.malformed import MATRIX, opencv

RIGHT = {"width_px": 1280, "height_px": 720, "fx_px": 900.5, "fy_px": 901.2, "cx_px": 640.2, "cy_px": 358.9,
         "model": "brown", "distortion": [-0.1, 0.02, 0.0, 0.0, 0.0]}  # fmt: skip
TOPIC = (
    "header:\n  seq: 17\n  frame_id: road\nheight: 720\nwidth: 1280\ndistortion_model: plumb_bob\n"
    f"D: [-0.1, 0.02, 0.0, 0.0, 0.0]\nK: {MATRIX}\nbinning_x: 0\nbinning_y: 0\n"
)
SIZE_LAST = (
    f"camera_matrix: {{rows: 3, cols: 3, data: {MATRIX}}}\n"
    "distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.02, 0.0, 0.0, 0.0]}\n"
    "image_width: 1280\nimage_height: 720\n"
)
XML = """<?xml version="1.0"?>
<opencv_storage>
<image_width>1280</image_width>
<image_height>720</image_height>
<camera_matrix type_id="opencv-matrix">
  <rows>3</rows><cols>3</cols><dt>d</dt>
  <data>900.5 0. 640.2 0. 901.2 358.9 0. 0. 1.</data></camera_matrix>
<distortion_coefficients type_id="opencv-matrix">
  <rows>5</rows><cols>1</cols><dt>d</dt>
  <data>-0.1 0.02 0. 0. 0.</data></distortion_coefficients>
</opencv_storage>
"""
GYROFLOW = {
    "name": "Action camera, wide",
    "calib_dimension": {"w": 1280, "h": 720},
    "fisheye_params": {"camera_matrix": [[900.5, 0, 640.2], [0, 901.2, 358.9], [0, 0, 1]],
                       "distortion_coeffs": [0.1, 0.02, -0.003, 0.004]},
}  # fmt: skip

# What another program's file gives: the right camera (None), or a refusal (2) or warning (0) in these words.
OTHERS: dict[str, tuple[bytes, tuple[int, tuple[str, ...]] | None]] = {
    "a byte order mark and line ends of Windows": (
        b"\xef\xbb\xbf" + opencv().replace("\n", "\r\n").encode(), None),
    "small numbers as Python writes them": (opencv(lens="[-1e-1, 2e-2, 0, 0e0, 0.0]").encode(), None),
    "a matrix under two names": (
        opencv().replace("data: " + MATRIX, "data: &k " + MATRIX).encode() + b"projection: *k\n", None),
    "one message of a topic": (TOPIC.encode() + b"---\n", None),
    "a height with a zero in front": (opencv(size=(1280, "0720")).encode(), None),
    "cut behind the matrix": (opencv().split("distortion_model")[0].encode(), (2, ("distortion",))),
    "cut in the height": (SIZE_LAST[:-2].encode(), (2, ("outside the image", "image size"))),
    "cut in the lens": (opencv()[:-12].encode(), (2, ("not a readable camera file",))),
    "zeros behind it": (opencv().encode() + bytes(4096), (2, ("not a readable camera file",))),
    "a printed minus": (opencv(lens="[−0.1, 0.02, 0.0, 0.0, 0.0]").encode(), (2, ("distortion", "numbers"))),
    "spaces of a web page": (opencv().replace("  rows", "\u00a0\u00a0rows").encode(), (2, ("camera",))),
    "more columns than numbers": (
        opencv().replace("cols: 5", "cols: 8").encode(), (2, ("8 columns", "5 numbers"))),
    "half of the rows": (opencv().replace("rows: 3", "rows: 2").encode(), (2, ("2 rows", "9 numbers"))),
    "five numbers of a fisheye": (
        opencv().replace("plumb_bob", "equidistant").encode(), (2, ("four coefficients", "has 5"))),
    "a matrix of zeros": (
        opencv("[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]", "[]").encode(), (2, ("not calibrated",))),
    "left of the picture": (
        opencv(MATRIX.replace("640.2", "-640.2")).encode(), (0, ("optical axis lies far from the middle",))),
    "a negative width": (opencv(size=(-1280, 720)).encode(), (2, ("whole numbers of pixels",))),
    "a width with its unit": (opencv(size=("1280 px", 720)).encode(), (2, ("image size",))),
    "a width that is true": (opencv(size=("yes", 720)).encode(), (2, ("image size",))),
    "pictures of half the size": (
        TOPIC.replace("binning_x: 0", "binning_x: 2").encode(), (2, ("binn",))),
    "XML": (XML.encode(), (2, ("XML", "YAML"))),
    "XML in UTF-16": (XML.encode("utf-16"), (2, ("UTF-8",))),
    "a lens profile": (json.dumps(GYROFLOW).encode(), (2, ("image size", "image_width"))),
    "a table of COLMAP": (
        b"# Camera list\n1 OPENCV 1280 720 900.5 901.2 640.2 358.9 -0.1 0.02 0 0\n",
        (2, ("contains no camera",))),
    "the page of a pickle": (b"PK\x03\x04" + bytes(range(256)), (2, ("not UTF-8 text",))),
    "50 MB of blanks": (b" " * 50_000_000, (2, ("too large",))),
    "a list in a list without end": (b"- " * 50_000, (2, ("not a readable camera file",))),
    "a list as a key of mrcal's": (b"{'lensmodel': 'LENSMODEL_OPENCV5', []: 0}", (2, ("not a readable",))),
    "a coefficient beyond all bounds": (
        opencv(lens="[-0.1, 0.02, 1e30, 0.0, 0.0]").encode(), (2, ("distortion", "too large"))),
    "keys of something else": (b"".join(b"k%d: 0\n" % n for n in range(3000)), (2, ("no camera matrix",))),
}  # fmt: skip


@pytest.mark.parametrize("name", OTHERS)
def test_a_file_of_another_program(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content, answer = OTHERS[name]
    path, out = tmp_path / "of_another.yaml", tmp_path / "camera.json"
    path.write_bytes(content)
    status = main(["import-camera", str(path), "-o", str(out)])
    said = capsys.readouterr().err
    if answer is None:
        camera = json.loads(out.read_text())
        assert (status, said, {key: camera[key] for key in RIGHT}) == (0, "", RIGHT)
        return
    assert (status, out.exists()) == (answer[0], answer[0] == 0)
    assert said.count("\n") == 1 and len(said) < 400 and all(word in said for word in answer[1]), said


OWN: dict[str, Any] = {
    "format": "sightline-camera-1", "name": "road", **RIGHT, "rms_px": 0.2, "parameters": [],
    "covariance": None, "views": [],
}  # fmt: skip


def _with(**changes: object) -> bytes:
    return json.dumps({**OWN, **changes}).encode()


def _without(key: str) -> bytes:
    return json.dumps({name: value for name, value in OWN.items() if name != key}).encode()


# What a hand does to our own camera.json: None where it stays right, else what the refusal says.
OURS: dict[str, tuple[bytes, tuple[str, ...] | None]] = {
    "as written": (_with(), None),
    "a byte order mark": (b"\xef\xbb\xbf" + _with(), None),
    "UTF-16": (json.dumps(OWN).encode("utf-16"), ("UTF-8",)),
    "cut": (_with()[:150], ("JSON",)),
    "zeros behind it": (_with() + bytes(100), ("JSON",)),
    "a focal length twice": (_with().replace(b'"fy_px"', b'"fx_px": 450.0, "fy_px"'), ("fx_px", "twice")),
    "a focal length in quotes": (_with(fx_px="900.5"), ("fx_px",)),
    "a focal length with a comma": (_with(fx_px="900,5"), ("fx_px",)),
    "no number": (_with(fy_px=float("nan")), ("fy_px",)),
    "without end": (_with(cx_px=float("-inf")), ("cx_px",)),
    "a focal length of millimetres": (_with(fx_px=4.5, fy_px=4.5), ("4.5", "pixels")),
    "half a pixel": (_with(width_px=1280.5), ("width_px",)),
    "a size as text": (_with(width_px="1280"), ("width_px",)),
    "a lens left out": (_without("distortion"), ("distortion",)),
    "a lens as an object": (_with(distortion={"k1": -0.1}), ("distortion",)),
    "a lens without k3": (_with(distortion=[-0.1, 0.02, 0.0, 0.0]), None),
    "a lens too short": (_with(distortion=[-0.1, 0.02, 0.0]), ("distortion", "4")),
    "a lens of another model": (_with(model="fisheye"), ("distortion", "fisheye")),
    "an axis outside": (_with(cx_px=6402.0), ("principal point",)),
    "a model left out": (_without("model"), ("model",)),
    "a model in capitals": (_with(model="Brown"), ("model",)),
    "a newer one": (_with(format="sightline-camera-2"), ("sightline-camera-2",)),
    "a pose": (json.dumps({"format": "sightline-pose-1", "camera": OWN}).encode(), ("sightline-pose-1",)),
    "two in a list": (json.dumps([OWN, OWN]).encode(), ("camera",)),
    "the file of another program": (opencv().encode(), ("import-camera",)),
    "50 MB of blanks": (b" " * 50_000_000, ("JSON",)),
}  # fmt: skip


@pytest.mark.parametrize("name", OURS)
def test_a_camera_of_ours(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content, words = OURS[name]
    path = tmp_path / "camera.json"
    path.write_bytes(content)
    site = ["--camera-height", "1.5", "--distance", "5"]
    status = main(["plan", "--camera", str(path), *site, "--json"])
    got = capsys.readouterr()
    if words is None:
        assert (status, got.err) == (0, "")
        return
    assert (status, got.out) == (2, "") and got.err.count("\n") == 1 and len(got.err) < 400
    assert all(word in got.err for word in ("camera.json", *words)), got.err


def test_the_pages_read_them_alike(operator: Client, survey_id: int) -> None:
    camera = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Left"})["id"]
    for name in ("a height with a zero in front", "a matrix under two names", "XML", "cut behind the matrix"):
        content, answer = OTHERS[name]
        path = f"/cameras/{camera}/calibrations/import"
        got = operator.post(path, files={"file": ("of_another.yaml", content)})
        if answer is None:
            document = got.json()["document"]
            assert (got.status_code, {key: document[key] for key in RIGHT}) == (201, RIGHT), name
        else:
            said = error_of(got)
            assert "of_another.yaml" in said and all(word in said for word in answer[1]), said
