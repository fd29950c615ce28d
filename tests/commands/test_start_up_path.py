"""What a start loads: neither the making of the demonstration nor the libraries of figures and report, and of
a command that stores nothing no library of databases.
"""

import gc
from pathlib import Path

import pytest

from sightline.commands import serve
from sightline.infra.database import engine
from sightline.infra.jobs import workers
from sightline.settings import Settings
from tests.commands.running import python

pytestmark = pytest.mark.once

LATER = ("sightline.demo.build", "sightline.demo.parts", "matplotlib", "typst", "pyarrow")


STARTS = (
    ("import sightline.commands.linescan, sightline.commands.stream", ("sqlalchemy", *LATER)),
    ("import sightline.commands.serve, sightline.app, sightline.infra.jobs.workers", LATER),
    ("import sightline.commands.worker, sightline.job_handlers", LATER),
)


def test_a_start_loads_only_what_it_needs() -> None:
    """All starts, one after the other in one process."""
    loaded = "print([name for name in {!r} if name in sys.modules])"
    steps = (step for start, later in STARTS for step in (start, loaded.format(later)))
    done = python("; ".join(("import gc, sys", "gc.disable()", *steps)))
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["[]"] * len(STARTS)


def test_a_migration_lets_go_of_what_it_made_and_handlers_stay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The collector runs while a server or a worker migrates, which may take long, and rests for imports."""
    seen = []

    def migrate(_engine: object) -> None:
        seen.append(gc.isenabled())

    def load_handlers() -> None:
        seen.append(gc.isenabled())
        raise KeyboardInterrupt

    monkeypatch.setattr(workers, "migrate", migrate)
    monkeypatch.setattr(workers, "require_alike", lambda *_, **_more: None)
    settings = Settings(data_dir=tmp_path, database_url=f"sqlite:///{tmp_path}/sightline.sqlite3")
    with pytest.raises(KeyboardInterrupt):
        workers.run_workers(settings, load_handlers=load_handlers)
    assert seen == [True, False]

    def migrate_no_further(_engine: object) -> None:
        seen.append(gc.isenabled())
        raise KeyboardInterrupt

    monkeypatch.setattr(engine, "migrate", migrate_no_further)
    with pytest.raises(KeyboardInterrupt):
        serve.run(None, 0, 0, False, tmp_path)
    assert seen == [True, False, True]
