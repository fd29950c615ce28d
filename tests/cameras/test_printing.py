"""A board to print, by the page and by the command line."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sightline.cli import cli
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of

ASKED = "columns=9&rows=6&square_m=0.025"


def sheet_mm(pdf: bytes) -> tuple[float, float]:
    found = re.search(rb"/MediaBox\[\s*0 0 ([\d.]+) ([\d.]+)\s*\]", pdf)
    assert found, pdf[:400]
    width, height = (float(points) * 25.4 / 72.0 for points in found.groups())
    return round(width, 1), round(height, 1)


def test_the_board_that_is_typed_comes_as_pdf_at_true_size(viewer: Client) -> None:
    answer = viewer.get(f"/boards.pdf?{ASKED}")
    assert answer.headers["Content-Type"] == "application/pdf"
    assert sheet_mm(answer.content) == (297.0, 210.0)
    text = words(answer.content).replace("\n", " ")
    assert "9 × 6 inner corners, squares of 25 mm" in text and "100 mm long" in text
    assert answer.content == viewer.get(f"/boards.pdf?{ASKED}").content
    larger = viewer.get(f"/boards.pdf?{ASKED}&paper=A1")
    assert sheet_mm(larger.content) == (594.0, 841.0)
    markers = f"/boards.pdf?{ASKED}&board_kind=charuco&dictionary=4X4_50&marker_m=0.018"
    assert "markers 4X4_50 of 18 mm" in words(viewer.get(markers).content).replace("\n", " ")


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ("columns=2&rows=6&square_m=0.025", "2x6"),
        (f"{ASKED}&paper=A9", "Paper 'A9' cannot be used"),
        ("columns=40&rows=30&square_m=0.1", "larger than A0"),
        (f"{ASKED}&board_kind=charuco", "ChArUco"),
    ],
)
def test_what_is_no_board_is_refused_in_a_sentence(viewer: Client, asked: str, said: str) -> None:
    answer = viewer.get(f"/boards.pdf?{asked}")
    assert answer.status_code == 422 and said in error_of(answer)


def test_nobody_without_an_account_prints_one(nobody: Client) -> None:
    assert nobody.get(f"/boards.pdf?{ASKED}").status_code == 401


def test_the_command_writes_the_same(tmp_path: Path, viewer: Client) -> None:
    target = tmp_path / "board.pdf"
    done = CliRunner().invoke(cli, ["board", "--board", "9x6", "--square", "0.025", "-o", str(target)])
    assert done.exit_code == 0, done.output
    assert target.read_bytes() == viewer.get(f"/boards.pdf?{ASKED}").content
