"""A file that is written aside is there whole or not at all."""

from pathlib import Path

import pytest

from sightline.media.atomic import atomic_file


@pytest.mark.parametrize("lasting", [True, False])
def test_it_takes_its_place_at_the_end_or_never(tmp_path: Path, lasting: bool) -> None:
    target = tmp_path / "new" / "folder" / "a.txt"
    with atomic_file(target, lasting=lasting) as part:
        part.write_text("first")
        assert not target.exists()
    with pytest.raises(ZeroDivisionError), atomic_file(target, lasting=lasting) as part:
        part.write_text("half of the second")
        raise ZeroDivisionError
    assert target.read_text() == "first"
    assert [path.name for path in target.parent.iterdir()] == ["a.txt"]
