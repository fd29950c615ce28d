"""Cameras of other tools: read for what they are, or refused in a sentence."""

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry.imports import read_camera
from tests.geometry.scenes import shared

OPENCV_YAML = """%YAML:1.0
---
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 500., 0., 320., 0., 501., 240., 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -0.3, 0.1, 0.001, -0.002, 0.05 ]
avg_reprojection_error: 0.31
"""
OPENCV_JSON = """{"image_size": [640, 480], "camera_matrix": [[500, 0, 320], [0, 501, 240], [0, 0, 1]],
"dist_coeffs": [[-0.3, 0.1, 0.001, -0.002, 0.05]]}"""
OPENCV_STORAGE_JSON = """{"image_width": 640, "image_height": 480,
"camera_matrix": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
"data": [500, 0, 320, 0, 501, 240, 0, 0, 1]},
"distortion_coefficients": {"type_id": "opencv-matrix", "rows": 1, "cols": 5, "dt": "d",
"data": [-0.3, 0.1, 0.001, -0.002, 0.05]}}"""
ROS = """image_width: 640
image_height: 480
camera_name: narrow_stereo
camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 501, 240, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.3, 0.1, 0.001, -0.002, 0.05]}
"""
ROS_TOPIC = """height: 480
width: 640
distortion_model: plumb_bob
D: [-0.3, 0.1, 0.001, -0.002, 0.05]
K: [500.0, 0.0, 320.0, 0.0, 501.0, 240.0, 0.0, 0.0, 1.0]
binning_x: 0
"""
KALIBR = """cam0:
  camera_model: pinhole
  intrinsics: [500, 501, 320, 240]
  distortion_model: radtan
  distortion_coeffs: [-0.3, 0.1, 0.001, -0.002]
  resolution: [640, 480]
"""
MRCAL = """# generated on a test
{
    'lensmodel':  'LENSMODEL_OPENCV5',
    'intrinsics': [ 500., 501., 320., 240., -0.3, 0.1, 0.001, -0.002, 0.05, ],
    'valid_intrinsics_region': [],
    'extrinsics': [ 0., 0., 0., 0., 0., 0., ],
    'imagersize': [ 640, 480 ],
    'icam_intrinsics': 0
}
"""


@pytest.mark.parametrize(
    "text", [OPENCV_YAML, OPENCV_JSON, OPENCV_STORAGE_JSON, ROS, ROS_TOPIC, KALIBR, MRCAL]
)
def test_each_format(text: str) -> None:
    camera = read_camera(text, "camera.any").camera
    assert (camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px) == (500, 501, 320, 240)
    assert (camera.width_px, camera.height_px, camera.model) == (640, 480, "brown")
    assert camera.distortion[:4] == pytest.approx([-0.3, 0.1, 0.001, -0.002])
    assert len(camera.distortion) == 5 and camera.covariance is None


def test_fisheye_by_each_name() -> None:
    k = "[0.1, -0.02, 0.003, -0.0004]"
    equidistant = KALIBR.replace("radtan", "equidistant").replace("[-0.3, 0.1, 0.001, -0.002]", k)
    assert read_camera(equidistant, "k.yaml").camera.model == "fisheye"
    ros = ROS_TOPIC.replace("plumb_bob", "equidistant").replace("[-0.3, 0.1, 0.001, -0.002, 0.05]", k)
    assert read_camera(ros, "r.yaml").camera.model == "fisheye"


def test_four_unnamed_coefficients_are_read_by_their_size_and_said_so() -> None:
    text = OPENCV_JSON.replace("[[-0.3, 0.1, 0.001, -0.002, 0.05]]", "[-0.04, 0.02, TANGENTIAL, 0.008]")
    fisheye = read_camera(text.replace("TANGENTIAL", "-0.026"), "a.json")
    assert fisheye.camera.model == "fisheye" and "fisheye" in fisheye.notes[0]
    assert read_camera(text.replace("TANGENTIAL", "-0.026"), "a.json", "brown").camera.model == "brown"
    small = text.replace("TANGENTIAL", "0.001").replace("0.008", "0.0008")
    brown = read_camera(small, "a.json")
    assert brown.camera.model == "brown" and len(brown.camera.distortion) == 5 and brown.notes


def test_several_cameras() -> None:
    two = KALIBR + KALIBR.replace("cam0", "cam1").replace("500", "600")
    first = read_camera(two, "chain.yaml")
    assert first.camera.fx_px == 500 and "cam1" in first.notes[0]
    assert read_camera(two, "chain.yaml", which="cam1").camera.fx_px == 600
    with pytest.raises(BadInput, match="cam7"):
        read_camera(two, "chain.yaml", which="cam7")


def test_size_can_be_given() -> None:
    text = OPENCV_JSON.replace('"image_size": [640, 480], ', "")
    with pytest.raises(BadInput, match="picture size"):
        read_camera(text, "a.json")
    assert read_camera(text, "a.json", size=(640, 480)).camera.height_px == 480


@pytest.mark.parametrize(
    "text",
    [
        "", "hello", "{", "[1, 2]", "{}", "a: [", "\x00\x01", "!!python/object/apply:os.system ['ls']",
        "K: 3\nwidth: 4\nheight: 4", OPENCV_JSON.replace("500", "NaN"), OPENCV_JSON.replace("500", "-500"),
        OPENCV_JSON.replace("[500, 0,", "[500, 9,"), OPENCV_JSON.replace("[640, 480]", "[640]"),
        OPENCV_JSON.replace("0.05]", "0.05, 1, 2, 3, 0.5]"), OPENCV_JSON.replace("-0.3", '"x"'),
        OPENCV_JSON.replace("320", "99999"), MRCAL.replace("OPENCV5", "CAHVOR"),
        MRCAL.replace("0.05, ]", "]"),
        MRCAL.replace("[ 640, 480 ]", "__import__('os')"), KALIBR.replace("pinhole", "omni"),
        KALIBR.replace("radtan", "fov"), KALIBR.replace("[500, 501, 320, 240]", "[500]"),
        ROS_TOPIC.replace("binning_x: 0", "binning_x: 2"), "[" * 20000,
    ],
)  # fmt: skip
def test_refusals_are_one_sentence_that_names_the_file(text: str) -> None:
    with pytest.raises(BadInput, match=r"odd\.file") as caught:
        read_camera(text, "odd.file")
    assert "\n" not in caught.value.message and caught.value.message.endswith(".")


def test_a_small_file_cannot_be_a_huge_one() -> None:
    rows = ["a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"]
    rows += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]" for n in range(1, 9)]
    with pytest.raises(BadInput, match="no readable camera file"):
        read_camera("\n".join([*rows, "camera_matrix: *a8"]), "bomb.yml")


def test_real_files() -> None:
    published = read_camera(
        shared("calibration", "opencv_left", "left_intrinsics.yml").read_text(), "left.yml"
    ).camera
    assert published.fx_px == pytest.approx(535.916, abs=1e-3) and published.rms_px == pytest.approx(
        0.393, abs=1e-3
    )
    for name in ("front.yaml", "left.yaml"):
        camera = read_camera(shared("calibration", "ground_pattern", name).read_text(), name).camera
        assert camera.model == "fisheye" and (camera.width_px, camera.height_px) == (960, 640)
        assert np.abs(camera.distortion).max() < 0.1
