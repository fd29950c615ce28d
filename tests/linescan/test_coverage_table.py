"""The coverage table of docs/proofs.md: each bench writes its own section, cells say which way they miss."""

from pathlib import Path

import pytest

from tests.bench.bench_linescan_coverage import Cell, Held, section_of
from tests.bench.proofs_page import PAGE, put_section

pytestmark = pytest.mark.once


@pytest.mark.parametrize(
    ("held", "verdict"),
    [
        (Held(100, 0.95, 1.0), "inside"),
        (Held(100, 0.91, 1.12), "within chance"),
        (Held(10_000, 0.91, 1.12), "too small"),
        (Held(100, 1.0, 0.35), "too wide"),
        (Held(100, 0.87, 1.45), "too small"),
    ],
)
def test_a_cell_says_which_way_it_misses(held: Held, verdict: str) -> None:
    assert held.verdict == verdict


def test_a_section_is_put_in_its_own_place_alone(tmp_path: Path) -> None:
    page = tmp_path / "proofs.md"
    page.write_text(PAGE.read_text())
    cells = [
        Cell(("car", "drawn", 2.0, 20.0), 100, 0, {"speed": Held(100, 0.95, 1.0)}),
        Cell(("van", "drawn", 8.0, 40.0), 100, 3, {"speed": Held(97, 0.87, 1.45)}),
    ]
    put_section(section_of(cells[:1]), page)
    put_section(section_of(cells), page)
    text = page.read_text()
    heights = PAGE.read_text().split("# Line scans")[0].rstrip("\n")
    assert text.startswith(heights) and text.count("# Line scans") == 1
    assert "| speed | 2 | 1 | 0 | 0 | 1 |" in text and "| length | 0 | 0 | 0 | 0 | 0 |" in text
    assert "| van | drawn | 8 | 40 | 3 of 100 | 0.87 1.45 ! | none |" in text
    assert max(map(len, text[len(heights) :].splitlines())) <= 120
