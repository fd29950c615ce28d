"""A process's own folder for files on their way: a killed one leaves nothing, a living one loses nothing."""

import subprocess
import sys
from pathlib import Path
from threading import Thread

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.infra.scratch import Scratch, sweep

ANOTHER = """
import sys
from pathlib import Path
from sightline.infra.scratch import Scratch
scratch = Scratch(Path(sys.argv[1]))
(scratch.folder() / "half.mp4").write_bytes(b"half")
print(scratch.folder(), flush=True)
sys.stdin.read()
"""


def test_what_a_killed_process_left_goes_and_a_living_ones_stays(tmp_path: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", ANOTHER, str(tmp_path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as other:
        assert other.stdout is not None
        folder = Path(other.stdout.readline().strip())
        mine = Scratch(tmp_path)
        (mine.folder() / "also half.mp4").write_bytes(b"half")
        sweep(tmp_path)
        assert (folder / "half.mp4").exists() and (mine.folder() / "also half.mp4").exists()
        other.kill()
        other.wait()
        sweep(tmp_path)
    assert not folder.exists() and (mine.folder() / "also half.mp4").exists()
    mine.close()
    assert list(tmp_path.iterdir()) == []


@given(st.lists(st.sampled_from(("make", "sweep", "close")), max_size=12))
def test_no_order_of_steps_takes_a_folder_from_who_holds_it(
    tmp_path_factory: pytest.TempPathFactory, steps: list[str]
) -> None:
    root = tmp_path_factory.mktemp("scratch")
    held: list[tuple[Scratch, Path]] = []
    for step in steps:
        if step == "make":
            made = Scratch(root)
            held.append((made, made.folder()))
        elif step == "sweep":
            (root / "nobody's").mkdir(exist_ok=True)
            sweep(root)
            assert not (root / "nobody's").exists()
        elif held:
            held.pop(0)[0].close()
        assert all(folder.is_dir() for _scratch, folder in held)
        assert sum(path.suffix == ".lock" for path in root.iterdir()) == len(held)
    for made, _folder in held:
        made.close()
    assert [path.name for path in root.iterdir() if path.name != "nobody's"] == []


def test_many_at_once_share_no_folder(tmp_path: Path) -> None:
    found: list[Path] = []

    def make() -> None:
        for _ in range(20):
            scratch = Scratch(tmp_path)
            folder = scratch.folder()
            sweep(tmp_path)
            assert folder.is_dir()
            found.append(folder)
            scratch.close()

    threads = [Thread(target=make) for _ in range(4)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    assert len(set(found)) == 80
