"""The report of a night tells of each part, and fails where one failed."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.load import nightly
from tests.support.waiting import NEVER_S

pytestmark = pytest.mark.once


def test_each_part_is_told_with_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    parts = {
        "good": ["-c", "print('all 7 held')"],
        "bad": ["-c", "print('one lost'); raise SystemExit(3)"],
        "slow": ["-c", "import time; print('begun', flush=True); time.sleep(3600)"],
    }
    run = subprocess.run

    def with_another_limit(command: list[str], timeout: float, **more: Any) -> Any:
        """One that those of an end never reach, and the slow one only once it has begun."""
        limit_s = 1.0 if command[1:] == parts["slow"] else NEVER_S
        while True:
            try:
                return run(command, timeout=limit_s, **more)
            except subprocess.TimeoutExpired as late:
                if late.stdout:
                    raise
                limit_s *= 2

    monkeypatch.setattr(subprocess, "run", with_another_limit)
    monkeypatch.setattr(nightly, "commands", lambda seed, share, package: parts)
    monkeypatch.setattr(sys, "argv", ["nightly", "-o", str(tmp_path / "night.md"), "--seed", "5"])
    with pytest.raises(SystemExit) as ended:
        nightly.main()
    told = (tmp_path / "night.md").read_text()
    assert ended.value.code == 1
    assert "seed 5" in told and "| good | good |" in told and "| bad | status 3 |" in told
    assert "| slow | took too long |" in told
    assert all(words in told for words in ("all 7 held", "one lost", "begun"))


def test_a_night_asks_for_what_was_promised(tmp_path: Path) -> None:
    asked = nightly.commands(7, 1.0, tmp_path)
    assert "1000" in asked["faults on SQLite"] and "--postgresql" in asked["faults on PostgreSQL"]
    assert asked["several machines"][-1] == "tests.load.machines"
    assert asked["forged packages"][-2:] == ["10000", "7"] and "1000" in asked["hostile input"]
