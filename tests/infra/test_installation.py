"""Processes of one installation on PostgreSQL: the same settings, one folder of uploads, one time."""

from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path

import pytest
from pydantic import SecretStr
from sqlalchemy import Engine, create_engine, text

from sightline.errors import BadInput
from sightline.infra import installation
from sightline.infra.database import types
from sightline.infra.database.engine import make_engine
from sightline.infra.installation import require_alike
from sightline.settings import Settings
from tests.conftest import SERVER

pytestmark = [
    pytest.mark.dialect,
    pytest.mark.skipif(not SERVER, reason="on SQLite one server does the work"),
]

Start = Callable[..., None]


@pytest.fixture
def start(database_url: str, tmp_path: Path) -> Iterator[Start]:
    """Starts a process, as far as its settings go; those that started before still run."""
    running: list[Engine] = []
    common = {
        "data_dir": tmp_path / "shared",
        "database_url": database_url,
        "secret": SecretStr("one secret that all of them share"),
        "signing_key": SecretStr("ab" * 32),
    }

    def one(*, app: bool = True, **given: object) -> None:
        running.append(make_engine(database_url))
        require_alike(running[-1], Settings(**{**common, **given}), app=app)

    yield one
    for engine in running:
        engine.dispose()


def test_two_apps_and_a_worker_that_are_alike_start(start: Start, tmp_path: Path) -> None:
    uploads = tmp_path / "uploads"
    media = "s3://bucket/videos?endpoint=http://storage:8333"
    start(uploads_dir=uploads, media_url=media)
    start(
        uploads_dir=uploads, media_url="s3://bucket/videos?endpoint=http://10.0.0.7:8333", data_dir=tmp_path
    )
    start(app=False, secret=None, media_url=media, data_dir=tmp_path / "worker")


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("SIGHTLINE_SECRET", SecretStr("another secret of more than 32 signs")),
        ("SIGHTLINE_SECRET", None),
        ("SIGHTLINE_SIGNING_KEY", SecretStr("cd" * 32)),
        ("SIGHTLINE_MEDIA_URL", "s3://another"),
        ("SIGHTLINE_UPLOADS_DIR", "elsewhere"),
    ],
)
def test_a_setting_that_differs_is_named(start: Start, name: str, other: object, tmp_path: Path) -> None:
    start()
    given = tmp_path / other if other == "elsewhere" else other
    with pytest.raises(BadInput, match=f"{name} differs from the value of the other processes"):
        start(**{name.removeprefix("SIGHTLINE_").lower(): given})


def test_what_a_worker_signs_with_counts_and_its_folders_do_not(start: Start, tmp_path: Path) -> None:
    start(media_url="s3://bucket")
    start(app=False, media_url="s3://bucket", uploads_dir=tmp_path / "its own", secret=None)
    with pytest.raises(BadInput, match="SIGHTLINE_SIGNING_KEY"):
        start(app=False, media_url="s3://bucket", signing_key=SecretStr("cd" * 32))


def test_a_changed_key_is_taken_once_the_others_have_ended(database_url: str, tmp_path: Path) -> None:
    for key in ("ab" * 32, "cd" * 32):
        engine = make_engine(database_url)
        settings = Settings(data_dir=tmp_path, database_url=database_url, signing_key=SecretStr(key))
        require_alike(engine, settings, app=True)
        engine.dispose()


def test_another_installation_in_the_same_database_is_nobodys_business(start: Start) -> None:
    other = create_engine(SERVER)
    with other.connect() as connection:
        connection.execute(text("SET application_name TO 'sightline 000000 1 2 3 4'"))
        start()
    other.dispose()


@pytest.mark.parametrize("hours", [-1, 1])
def test_a_clock_that_is_an_hour_off_is_told(
    start: Start, hours: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = types.now() + timedelta(hours=hours)
    monkeypatch.setattr(installation, "now", lambda: shown)
    with pytest.raises(BadInput, match="60 minutes apart"):
        start()
