"""What other programs import from `sightline`: named, loaded late, explained, and as its examples say."""

import ast
import doctest
import inspect
import re
from pathlib import Path
from typing import Any

import pytest

import sightline
from tests.commands.running import python

ROOT = Path(__file__).resolve().parents[1]
LIBRARY = ROOT / "docs" / "library.md"

CLASSES = [
    "Board", "Camera", "Corners", "Crossings", "Known", "ObservedPass", "Passage", "Reference", "Rig",
    "RiskPoints", "RoadPose", "Site",
]  # fmt: skip
FUNCTIONS = {
    "adjust": "pose passes u_wheelbase_common_m u_roof_common_m",
    "calibrate": "views board model bent_board",
    "camera_from_dict": "data what",
    "camera_to_dict": "camera",
    "crest_constant": "eye_m object_m u_eye_m u_object_m",
    "crest_length": "distance_m difference_percent constant_m",
    "error_table": "measured_m reference_m lighting rounding measured",
    "expanded": "u",
    "find_board": "gray board time_limit_s",
    "gauge": "values items persons",
    "line_height": "pose contact_row_px target_row_px sigma_px inset_m u_inset_m",
    "measure_direct": "passage rig",
    "measure_frames": "pose contacts_px targets_px sigma_px u_heading_rad",
    "measure_height": "pose contact_px target_px sigma_px inset_m u_inset_m",
    "measure_heights": "pose contacts_px targets_px sigma_px inset_m u_inset_m with_uncertainty",
    "plain_camera": "width_px height_px field_of_view_rad",
    "plan_lines": "speed_mps baseline_m error line_rate_hz u_baseline_m length_m time_gap_s",
    "plan_site": "camera site insets",
    "pose_from_corners": "camera frames board reference mean_picture",
    "pose_from_dict": "data what",
    "pose_to_dict": "pose",
    "project": "camera points_cam",
    "read_camera": "text file_name model size which",
    "sample_of_measurements": "height_m u_height_m u_clicks_m u_by_inset_m pose inset site pose_names",
    "single_plan": "size risks",
    "site_pose": "camera site",
    "solve_crossings": "crossings baseline_m line_rate_hz",
    "solve_line_pose": "distance_m height_m row_px sigma_px u_distance_m u_lean_rad",
    "stopping_distance": "speed_mps units gradient reaction_s deceleration_mps2",
    "total_figures": "sample percents limits_m",
    "undistort": "camera points_px",
}
SECTION = re.compile(r"^(\w+)\n-+$", re.MULTILINE)


def sections_of(function: Any) -> dict[str, str]:
    """The text of each section of a numpydoc docstring by its heading."""
    first, *parts = SECTION.split(inspect.getdoc(function) or "")
    return {"": first, **dict(zip(parts[::2], parts[1::2], strict=True))}


def failed_examples(name: str, text: str) -> int:
    """How many examples of a text give something else than it says."""
    test = doctest.DocTestParser().get_doctest(text, {}, name, None, None)
    assert test.examples, name
    return doctest.DocTestRunner(verbose=False).run(test).failed


def test_these_names_and_parameters_are_what_others_may_rely_on() -> None:
    assert sightline.__all__ == [*CLASSES, *FUNCTIONS]
    assert all(inspect.isclass(getattr(sightline, name)) for name in CLASSES)
    found = {name: " ".join(inspect.signature(getattr(sightline, name)).parameters) for name in FUNCTIONS}
    assert found == FUNCTIONS
    assert set(sightline.__all__) <= set(dir(sightline))
    with pytest.raises(AttributeError, match="no attribute 'detect'"):
        sightline.detect  # noqa: B018


def test_importing_it_loads_nothing_until_a_name_is_asked_for() -> None:
    late = "print([name for name in ('numpy', 'cv2', 'scipy', 'sightline.coverage') if name in sys.modules])"
    done = python(f"import sys, sightline; {late}; sightline.expanded(1.0); {late}")
    assert done.returncode == 0, done.stderr
    assert done.stdout.split("\n")[:2] == ["[]", "['sightline.coverage']"]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_says_its_parameters_what_it_returns_and_when_it_raises(name: str) -> None:
    function = getattr(sightline, name)
    found = sections_of(function)
    described = re.findall(r"^(\w[\w, ]*?)(?: : .+)?$", found["Parameters"], re.MULTILINE)
    assert [one for line in described for one in line.split(", ")] == FUNCTIONS[name].split()
    assert found["Returns"].strip()
    raised = {
        node.exc.func.id
        for node in ast.walk(ast.parse(inspect.getsource(function)))
        if isinstance(node, ast.Raise)
        and isinstance(node.exc, ast.Call)
        and isinstance(node.exc.func, ast.Name)
    }
    raised = {one for one in raised if not one.startswith("_")}  # a helper that makes the error
    assert raised <= set(re.findall(r"^\w+$", found.get("Raises", ""), re.MULTILINE))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_has_an_example_that_runs(name: str) -> None:
    example = sections_of(getattr(sightline, name))["Examples"]
    assert f"sightline.{name}(" in example
    assert failed_examples(name, example) == 0


def test_an_example_that_says_something_else_is_found() -> None:
    assert failed_examples("planted", ">>> 1 + 1\n3\n") == 1


def test_the_page_of_the_library_names_each_and_its_examples_run() -> None:
    page = LIBRARY.read_text(encoding="utf-8")
    assert re.findall(r"^\| `(\w+)` \|", page, re.MULTILINE) == [*FUNCTIONS, *CLASSES]
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert failed_examples("library.md", "\n".join(blocks)) == 0
