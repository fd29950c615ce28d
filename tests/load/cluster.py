"""A PostgreSQL cluster of one's own, on no port at all, whose postmaster may be killed (Linux)."""

import os
import shutil
import signal
import subprocess
from contextlib import suppress
from pathlib import Path

from sqlalchemy import create_engine, text

from tests.support.waiting import until

USER = "postgres"


class Cluster:
    """Made in `folder`; `start`, `kill` and `stop` as often as wanted."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True)
        if os.geteuid() == 0:  # PostgreSQL refuses to run as root
            shutil.chown(folder, USER, USER)
            for above in folder.parents:
                if above.stat().st_uid == 0 and above.parts[:2] == folder.parts[:2] and len(above.parts) > 2:
                    above.chmod(above.stat().st_mode | 0o011)
        self._run(
            "initdb", "--auth=trust", f"--username={USER}", "--no-sync", "--pgdata", str(folder / "data")
        )

    @property
    def url(self) -> str:
        return f"postgresql+psycopg://{USER}@/postgres?host={self.folder}"

    def start(self) -> None:
        """Until it answers; after a kill it recovers first, once the last of its processes is gone."""
        until(self._starts, lambda: f"it does not start: see {self._log}")
        engine = create_engine(self.url)
        with engine.connect() as connection:
            connection.execute(text("SELECT 1"))
        engine.dispose()

    def _starts(self) -> bool:
        options = f"-k {self.folder} -c listen_addresses="
        try:
            self._run(
                "pg_ctl", "start", "-w", "-D", str(self.folder / "data"), "-o", options, "-l", self._log
            )
        except subprocess.CalledProcessError:
            return False
        return True

    def kill(self) -> None:
        """SIGKILL to the postmaster; its processes notice and end."""
        os.kill(self._postmaster(), signal.SIGKILL)

    def stop(self) -> None:
        with suppress(subprocess.CalledProcessError):
            self._run("pg_ctl", "stop", "-m", "immediate", "-D", str(self.folder / "data"))

    @property
    def _log(self) -> str:
        return str(self.folder / "log")

    def _postmaster(self) -> int:
        return int((self.folder / "data" / "postmaster.pid").read_text().splitlines()[0])

    def _run(self, name: str, *words: str) -> None:
        found = shutil.which(name) or max(map(str, Path("/usr/lib/postgresql").glob(f"*/bin/{name}")))
        as_user = ["runuser", "-u", USER, "--"] if os.geteuid() == 0 else []
        subprocess.run(
            [*as_user, found, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
