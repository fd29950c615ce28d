"""Hostile recordings in a process of their own: no crash, no hang, no hunger, one sentence each."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.media.conftest import ROOT


@pytest.mark.parametrize("count", [15, pytest.param(60, marks=pytest.mark.proof)])
def test_mutated_recordings_are_served_or_refused(count: int, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "tests.media.fuzz", str(tmp_path), "1000", str(count)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
    assert run.returncode == 0, run.stderr[-2000:]
    tally = json.loads(run.stdout)
    assert tally["refused"] + tally["taken"] == count
    assert tally["taken"] > count // 2 and tally["served"] > tally["damaged"]
    assert tally["memory_mb"] < 1000
    assert tally["slowest_s"] < 60
