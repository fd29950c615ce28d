"""Starts the real server as a user would and hands out its address and its one-time link."""

import os
import re
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from tests.support.waiting import NEVER_S, until

ROOT = Path(__file__).resolve().parents[2]
SIGHTLINE = Path(sys.executable).with_name("sightline")


@dataclass
class Server:
    process: "subprocess.Popen[str]"
    log: Path
    data_dir: Path

    @cached_property
    def port(self) -> int:
        """The port that it printed; waits for that."""
        return until(self._printed_port, self.log.read_text)

    @cached_property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def _printed_port(self) -> int | None:
        ended = self.process.poll() is not None
        found = re.search(r"Sightline is at http://\S+:(\d+) ", self.log.read_text())
        assert found or not ended, "the server stopped:\n" + self.log.read_text()
        return int(found[1]) if found else None

    def link(self) -> str | None:
        """The path of the one-time link, which the first start alone prints."""
        found = re.search(r"(/sign-in\?token=[\w.~-]+)", self.log.read_text())
        return found.group(1) if found else None

    def sign_in_link(self) -> str:
        link = self.link()
        assert link, self.log.read_text()
        return link

    def wait(self, seconds: float = NEVER_S) -> float:
        """Seconds until /api/health answered."""
        started = time.perf_counter()
        until(self._answers, lambda: "the server did not answer:\n" + self.log.read_text(), seconds)
        return time.perf_counter() - started

    def _answers(self) -> bool:
        assert self.process.poll() is None, "the server stopped:\n" + self.log.read_text()
        try:
            with urllib.request.urlopen(self.url + "/api/health", timeout=NEVER_S):
                return True
        except (urllib.error.URLError, OSError):
            return False

    def stop(self, how: signal.Signals = signal.SIGTERM) -> int:
        """Its status at the end."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        try:
            return self.process.wait(NEVER_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()


def start(
    command: str, data_dir: Path, *, port: int | None = None, extra: dict[str, str] | None = None
) -> Server:
    """`sightline COMMAND` with its data in `data_dir`, on a free port unless one is given; `extra` joins the
    environment.
    """
    log = data_dir / f"server-{time.time_ns()}.log"
    data_dir.mkdir(parents=True, exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("SIGHTLINE_")}
    environment |= {
        "SIGHTLINE_PORT": str(port or 0),
        "PYTHONUNBUFFERED": "1",
        "SIGHTLINE_FIND_PASSES": "false",
    }
    environment |= extra or {}
    with log.open("w") as output:
        process = subprocess.Popen(
            [str(SIGHTLINE), *command.split(), "--data-dir", str(data_dir)],
            stdout=output,
            stderr=subprocess.STDOUT,
            cwd=data_dir,
            env=environment,
            text=True,
        )
    return Server(process, log, data_dir)
