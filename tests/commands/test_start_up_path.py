"""What a start loads: neither the making of the demonstration nor the libraries of figures and report, and of
a command that stores nothing no library of databases.
"""

import pytest

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
