"""Runs the command line as a user does, in a process of its own."""

import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path


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
        command, capture_output=True, text=True, cwd=cwd, env=environment(**more), timeout=120, check=False
    )


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])


class Server:
    """`sightline serve` on a free port."""

    def __init__(self, data_dir: Path, *arguments: str, port: int | None = None, **more: str) -> None:
        self.port = port or free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        data_dir.mkdir(parents=True, exist_ok=True)
        self.log = data_dir / f"log-{time.time_ns()}.txt"
        command = [sys.executable, "-m", "sightline.cli", "serve", "--data-dir", str(data_dir)]
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                [*command, "--port", str(self.port), *arguments],
                stdout=log,
                stderr=subprocess.STDOUT,
                env=environment(PYTHONPATH=str(Path(__file__).resolve().parents[2] / "backend"), **more),
            )

    def wait(self, seconds: float = 60.0) -> None:
        """Until it answers."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            assert self.process.poll() is None, self.log.read_text()
            try:
                with urllib.request.urlopen(self.url + "/api/health", timeout=30):
                    return
            except (urllib.error.URLError, OSError):
                time.sleep(0.05)
        raise AssertionError("no answer:\n" + self.log.read_text())

    def link(self) -> str | None:
        found = re.search(r"(/sign-in\?token=[\w.~-]+)", self.log.read_text())
        return found.group(1) if found else None

    def stop(self, how: signal.Signals = signal.SIGTERM) -> int:
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            return self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()
