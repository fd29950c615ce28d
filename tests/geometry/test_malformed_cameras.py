"""Camera files broken in ways that the reader's author had not thought of: refused in a sentence, or said."""

from pathlib import Path

import pytest

from sightline.cli import main
from tests.support.malformed import CAMERA_FILES, camera_files

NO_CAMERA = "contains no camera; give OpenCV"
NO_FILE = "is not a readable camera file"
REFUSED = {
    "transposed.yaml": "must be 3x3 with 0 0 1",
    "not_a_number.yaml": "not finite",
    "endless.yaml": "not finite",
    "negative_focal.yaml": "must be positive",
    "shares_of_the_width.yaml": "0.703 is not plausible for images 1280 px wide",
    "eight_numbers.yaml": "3 rows and 3 columns but contains 8 numbers",
    "skewed.yaml": "has a skew",
    "scaled_by_two.yaml": "must be 3x3 with 0 0 1",
    "decimal_commas.yaml": "is not a list of numbers",
    "words_for_numbers.yaml": "is not a list of numbers",
    "six_coefficients.yaml": "6 distortion coefficients; 4, 5 or 8",
    "fourteen_coefficients.yaml": "thin-prism and tilt",
    "unknown_lens.yaml": "'division' is not supported",
    "lens_of_pixels.yaml": "folds back near the middle",
    "no_width.yaml": "two whole numbers of pixels",
    "half_a_pixel.yaml": "two whole numbers of pixels",
    "enormous.json": "the image size is not a list of numbers",
    "written_twice.yaml": "contains the key “camera_matrix” twice",
    "powershell.yaml": "not UTF-8 text",
    "latin_one.yaml": "not UTF-8 text",
    "tabs.yaml": NO_FILE,
    "half.yaml": NO_FILE,
    "empty.yaml": NO_CAMERA,
    "only_a_comment.yaml": NO_CAMERA,
    "picture.yaml": "not UTF-8 text",
    "nested.json": NO_FILE,
    "bomb.yaml": NO_FILE,
    "command.yaml": NO_FILE,
    "a_list.yaml": NO_CAMERA,
    "newer.json": "contains no camera matrix",
    "a_page.json": NO_CAMERA,
    "three_intrinsics.yaml": "four numbers, fu fv pu pv",
    "omni.yaml": "'omni' is not supported",
    "short.cameramodel": "needs 12 intrinsics, the file has 5",
    "code.cameramodel": NO_FILE,
}
WARNED = {
    "of_another_size.yaml": "optical axis lies far from the middle",
    "turned_size.yaml": "optical axis lies far from the middle",
}


def test_every_malformed_camera_file_is_tried() -> None:
    assert set(CAMERA_FILES) == set(REFUSED) | set(WARNED)


@pytest.mark.parametrize("name", [*REFUSED, *WARNED])
def test_a_malformed_camera_file_is_refused_or_warned_of(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "camera.json"
    status = main(["import-camera", str(camera_files(tmp_path)[name]), "-o", str(out)])
    said = capsys.readouterr().err
    assert (status, out.exists()) == ((2, False) if name in REFUSED else (0, True))
    assert said.count("\n") == 1 and {**REFUSED, **WARNED}[name] in said
