"""The survey "Hill", to which live streams are written: in the database, and behind a running Sightline."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from sightline.commands.remote import Remote
from sightline.commands.remote_sink import RemoteSink
from sightline.infra.services import Services, open_services
from sightline.scans.live.keeping import DatabaseSink, Sink
from sightline.settings import load_settings
from sightline.surveys.store import create_survey
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import traffic
from tests.support.kept import Shelf, lay_sqlite
from tests.support.served import served
from tests.support.streaming import CAMERAS, SITE, Place, token_of


@pytest.fixture(scope="module")
def lines() -> bytes:
    """Three vehicles."""
    pair = strips(SITE, traffic(5, 3, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8))
    return np.stack(pair, axis=1).astype(np.uint8).tobytes()


@pytest.fixture
def hill(tmp_path: Path, shelf: Shelf) -> Iterator[Services]:
    """A database with one survey."""
    opened = open_services(load_settings(data_dir=lay_sqlite(shelf, tmp_path / "data")))
    with opened.writing() as session:
        create_survey(session, name="Hill", actor=None)
    yield opened
    opened.close()


@pytest.fixture(params=["database", "server"])
def place(
    request: pytest.FixtureRequest, hill: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Place]:
    survey = ("--survey", "Hill")
    if request.param == "database":
        data = tmp_path / "data"

        def sink() -> Sink:
            return DatabaseSink(hill, 1, CAMERAS, "direct")

        yield Place((*survey, "--data-dir", str(data)), data / "live", sink)
        return
    token, folder = token_of(hill, "read", "upload", "measure"), tmp_path / "live"
    monkeypatch.setenv("SIGHTLINE_TOKEN", token)
    with served(hill) as port, Remote(f"http://127.0.0.1:{port}", token) as remote:
        where = (*survey, "--server", remote.url, "--spool", str(folder))
        yield Place(where, folder, lambda: RemoteSink(remote, 1, CAMERAS, "direct"))
