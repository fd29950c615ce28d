"""Runs the command line as a user does, in a process of its own."""

import os
import subprocess
import sys
import time
from pathlib import Path

from tests.browser import server as browser
from tests.support.waiting import NEVER_S


def environment(**more: str) -> dict[str, str]:
    """This environment without any setting of Sightline's, and these."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith("SIGHTLINE_")}
    return {**kept, "PYTHONUNBUFFERED": "1", **more}


def sightline(*arguments: str, cwd: Path | None = None, **more: str) -> "subprocess.CompletedProcess[str]":
    """One command to its end."""
    return _run("-m", "sightline.cli", *arguments, cwd=cwd, **more)


def python(program: str) -> "subprocess.CompletedProcess[str]":
    """A few lines of Python to their end."""
    return _run("-c", program)


def _run(*arguments: str, cwd: Path | None = None, **more: str) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, *arguments]
    more = {"PYTHONPATH": str(Path(__file__).resolve().parents[2] / "backend"), **more}
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        cwd=cwd,
        env=environment(**more),
        timeout=NEVER_S,
        check=False,
    )


class Server(browser.Server):
    """`sightline serve` on a free port."""

    def __init__(self, data_dir: Path, *arguments: str, **more: str) -> None:
        data_dir.mkdir(parents=True, exist_ok=True)
        log = data_dir / f"log-{time.time_ns()}.txt"
        command = [sys.executable, "-m", "sightline.cli", "serve", "--data-dir", str(data_dir)]
        with log.open("w") as output:
            process = subprocess.Popen(
                [*command, "--port", "0", *arguments],
                stdout=output,
                stderr=subprocess.STDOUT,
                env=environment(PYTHONPATH=str(Path(__file__).resolve().parents[2] / "backend"), **more),
                text=True,
            )
        super().__init__(process, log, data_dir)
