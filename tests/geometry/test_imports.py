"""Cameras of other tools: read for what they are, or refused in a sentence."""

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry.imports import read_camera
from sightline.geometry.verdict import lens_warnings, reach
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
    assert fisheye.camera.model == "fisheye" and "fisheye" in str(fisheye.notes[0])
    assert read_camera(text.replace("TANGENTIAL", "-0.026"), "a.json", "brown").camera.model == "brown"
    small = text.replace("TANGENTIAL", "0.001").replace("0.008", "0.0008")
    brown = read_camera(small, "a.json")
    assert brown.camera.model == "brown" and len(brown.camera.distortion) == 5 and brown.notes


def test_several_cameras() -> None:
    two = KALIBR + KALIBR.replace("cam0", "cam1").replace("500", "600")
    first = read_camera(two, "chain.yaml")
    assert first.camera.fx_px == 500 and "cam1" in str(first.notes[0])
    assert read_camera(two, "chain.yaml", which="cam1").camera.fx_px == 600
    with pytest.raises(BadInput, match="cam7"):
        read_camera(two, "chain.yaml", which="cam7")


ECHO = "header:\n  stamp: {sec: 17, nanosec: 83}\n  frame_id: road\n" + ROS_TOPIC


def test_messages_of_one_topic_are_one_camera() -> None:
    """`ros2 topic echo` ends each message in ---; messages that differ by their stamp alone are the same."""
    once = read_camera(ECHO + "---\n", "echo.yaml")
    assert (once.camera.fx_px, once.camera.name, once.notes) == (500, "road", ())
    twice = read_camera(f"{ECHO}---\n{ECHO.replace('sec: 17', 'sec: 18')}---\n", "echo.yaml")
    assert (twice.camera.fx_px, twice.notes) == (500, ())


def test_messages_that_differ_are_cameras_of_their_own() -> None:
    zoomed = ECHO.replace("500.0", "700.0")
    first = read_camera(f"{ECHO}---\n{zoomed}---\n", "echo.yaml")
    assert first.camera.fx_px == 500 and "road, 2; road was read" in str(first.notes[0])
    assert read_camera(f"{ECHO}---\n{zoomed}", "echo.yaml", which="2").camera.fx_px == 700


STEREO_NUMBERED = """%YAML:1.0
---
image_width: 640
image_height: 480
M1: !!opencv-matrix {rows: 3, cols: 3, dt: d, data: [500., 0., 320., 0., 501., 240., 0., 0., 1.]}
D1: !!opencv-matrix {rows: 1, cols: 5, dt: d, data: [-0.3, 0.1, 0.001, -0.002, 0.05]}
M2: !!opencv-matrix {rows: 3, cols: 3, dt: d, data: [600., 0., 310., 0., 601., 230., 0., 0., 1.]}
D2: !!opencv-matrix {rows: 1, cols: 5, dt: d, data: [-0.2, 0.05, 0., 0., 0.]}
"""
STEREO_NESTED = f"left:\n  {ROS.replace(chr(10), chr(10) + '  ')}\nright:\n  " + ROS.replace(
    "500, 0, 320, 0, 501", "600, 0, 310, 0, 601"
).replace("narrow_stereo", "narrow_right").replace("-0.3", "-0.2").replace("\n", "\n  ")
STEREO_JSON = """{"image_size": [640, 480], "cameraMatrix1": [[500, 0, 320], [0, 501, 240], [0, 0, 1]],
"distCoeffs1": [[-0.3, 0.1, 0.001, -0.002, 0.05]], "cameraMatrix2": [[600, 0, 310], [0, 601, 230], [0, 0, 1]],
"distCoeffs2": [[-0.2, 0.05, 0, 0, 0]], "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "T": [[-0.1], [0], [0]]}"""
STEREO_SIDED = (
    STEREO_JSON.replace("Matrix1", "Matrix_left")
    .replace("Matrix2", "Matrix_right")
    .replace("distCoeffs1", "left_dist_coeffs")
    .replace("distCoeffs2", "right_dist_coeffs")
)


@pytest.mark.parametrize("text", [STEREO_NUMBERED, STEREO_NESTED, STEREO_JSON, STEREO_SIDED])
def test_a_stereo_file_says_which_eye_and_lets_one_choose(text: str) -> None:
    left = read_camera(text, "rig.yaml")
    assert left.camera.fx_px == 500 and left.camera.distortion[0] == -0.3
    assert "left, right; left was read" in str(left.notes[0])
    for which in ("right", "Right", "2", "r"):
        right = read_camera(text, "rig.yaml", which=which)
        assert right.camera.fx_px == 600 and right.camera.distortion[0] == -0.2
        assert right.notes == ()
    with pytest.raises(BadInput, match="it contains left, right"):
        read_camera(text, "rig.yaml", which="middle")


def test_a_camera_that_was_never_calibrated_is_refused() -> None:
    unset = ROS_TOPIC.replace("[-0.3, 0.1, 0.001, -0.002, 0.05]", "[0.0, 0.0, 0.0, 0.0, 0.0]").replace(
        "[500.0, 0.0, 320.0, 0.0, 501.0, 240.0, 0.0, 0.0, 1.0]", str([0.0] * 9)
    )
    with pytest.raises(BadInput, match="was not calibrated"):
        read_camera(unset, "info.yaml")


def test_a_lens_of_zeros_is_taken_with_a_warning() -> None:
    plain = ROS.replace("plumb_bob", "rational_polynomial").replace(
        "cols: 5, data: [-0.3, 0.1, 0.001, -0.002, 0.05]", "cols: 8, data: [0, 0, 0, 0, 0, 0, 0, 0]"
    )
    read = read_camera(plain, "left.yaml")
    assert read.camera.fx_px == 500 and not read.camera.distortion.any()
    assert "without any distortion" in str(read.notes[0])


def test_a_part_of_the_picture_shifts_the_principal_point() -> None:
    """ROS: the matrix is that of the whole picture, whatever part of it the camera sends."""
    roi = "roi: {x_offset: 100, y_offset: 40, width: 400, height: 300, do_rectify: false}\n"
    part = read_camera(ROS_TOPIC + roi, "info.yaml")
    assert (part.camera.width_px, part.camera.height_px) == (400, 300)
    assert (part.camera.cx_px, part.camera.cy_px, part.camera.fx_px) == (220, 200, 500)
    assert "400x300 px from (100, 40) of 640x480" in str(part.notes[0])
    whole = read_camera(ROS_TOPIC + roi, "info.yaml", size=(640, 480))
    assert (whole.camera.width_px, whole.camera.cx_px) == (640, 320)


@pytest.mark.parametrize(
    "roi",
    ["0, y_offset: 0, width: 0, height: 0", "0, y_offset: 0, width: 640, height: 480"],
)
def test_a_roi_of_the_whole_picture_changes_nothing(roi: str) -> None:
    read = read_camera(f"{ROS_TOPIC}roi: {{x_offset: {roi}}}\n", "info.yaml")
    assert (read.camera.width_px, read.camera.cx_px, read.notes) == (640, 320, ())


@pytest.mark.parametrize(
    "roi", ["300, y_offset: 0, width: 400, height: 300", "10, y_offset: 0, width: 0, height: 0",
            "0.5, y_offset: 0, width: 100, height: 100"],
)  # fmt: skip
def test_a_roi_that_cannot_be_is_refused(roi: str) -> None:
    with pytest.raises(BadInput, match="does not fit the image’s size"):
        read_camera(f"{ROS_TOPIC}roi: {{x_offset: {roi}}}\n", "info.yaml")


def test_a_lens_that_turns_back_is_said_as_after_a_calibration() -> None:
    """r (1 - 0.75 r^2) turns back at r = 2/3, where it is 4/9; the picture's corner lies at 0.8."""
    folding = ROS.replace("[-0.3, 0.1, 0.001, -0.002, 0.05]", "[-0.75, 0, 0, 0, 0]")
    read = read_camera(folding, "left.yaml")
    assert reach(read.camera) == pytest.approx((4 / 9) / np.hypot(320.5 / 500, 240.5 / 501), rel=1e-4)
    assert read.notes == lens_warnings(read.camera)
    assert "cannot be inverted in the corners" in str(read.notes[0])
    assert read_camera(ROS, "left.yaml").notes == ()


def test_size_can_be_given() -> None:
    text = OPENCV_JSON.replace('"image_size": [640, 480], ', "")
    with pytest.raises(BadInput, match="image size"):
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
    with pytest.raises(BadInput, match="not a readable camera file"):
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
