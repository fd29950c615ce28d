"""Starts the real server as a user would and hands out its address and its one-time link."""

import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SIGHTLINE = Path(sys.executable).with_name("sightline")


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])


@dataclass
class Server:
    process: "subprocess.Popen[str]"
    url: str
    log: Path
    data_dir: Path

    def sign_in_link(self) -> str:
        """The path of the one-time link that the first start printed."""
        found = re.search(r"(/sign-in\?token=[\w.~-]+)", self.log.read_text())
        assert found, self.log.read_text()
        return found.group(1)

    def wait(self, seconds: float = 30.0) -> float:
        """Seconds until /api/health answered."""
        started = time.perf_counter()
        while time.perf_counter() - started < seconds:
            if self.process.poll() is not None:
                raise AssertionError("the server stopped:\n" + self.log.read_text())
            try:
                with urllib.request.urlopen(self.url + "/api/health", timeout=1):
                    return time.perf_counter() - started
            except (urllib.error.URLError, OSError):
                time.sleep(0.02)
        raise AssertionError("the server did not answer:\n" + self.log.read_text())

    def stop(self, how: signal.Signals = signal.SIGTERM) -> None:
        if self.process.poll() is None:
            self.process.send_signal(how)
            try:
                self.process.wait(10)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait(10)


def start(
    command: str, data_dir: Path, *, port: int | None = None, extra: dict[str, str] | None = None
) -> Server:
    """`sightline COMMAND` on a free port with its data in `data_dir`; `extra` joins the environment."""
    port = port or free_port()
    log = data_dir / f"server-{port}-{time.time_ns()}.log"
    data_dir.mkdir(parents=True, exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("SIGHTLINE_")}
    environment |= {"SIGHTLINE_PORT": str(port), "PYTHONUNBUFFERED": "1", "SIGHTLINE_FIND_PASSES": "false"}
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
    return Server(process, f"http://127.0.0.1:{port}", log, data_dir)
