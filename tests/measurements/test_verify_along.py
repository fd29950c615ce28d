"""Rows that go along with measurements.csv: each belongs to one, and none is left over."""

from pathlib import Path

import pytest

from sightline.errors import Damaged
from sightline.infra.csv_package.files import FolderFiles
from sightline.measurements.verify import _Along


@pytest.mark.parametrize(
    ("more", "left"),
    [("", None), ("m3,4", "m3"), (",4", ""), ("m1,4", "m1")],
    ids=["none", "new", "", "again"],
)
def test_a_row_of_no_measurement_is_left_over(tmp_path: Path, more: str, left: str | None) -> None:
    place = tmp_path / "tables" / "clicks.csv"
    place.parent.mkdir()
    place.write_text("\n".join(["id,x", "m1,1", "m1,2", "m2,3", *([more] if more else []), ""]))
    along = _Along(FolderFiles(tmp_path), "clicks.csv", "id")
    assert along.of("m2") == []
    assert [row["x"] for row in along.of("m1")] == ["1", "2"]
    assert [row["x"] for row in along.of("m2")] == ["3"]
    assert along.of("m3" if left != "m3" else "m4") == []
    if left is None:
        along.require_end()
    else:
        with pytest.raises(Damaged, match=f"clicks.csv: {left} is not in measurements.csv"):
            along.require_end()
