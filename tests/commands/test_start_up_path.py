"""What a start loads: neither the making of the demonstration nor the libraries of figures and report."""

import pytest

from tests.commands.running import python

pytestmark = pytest.mark.once

LATER = ("sightline.demo.build", "sightline.demo.parts", "matplotlib", "typst", "pyarrow")


STARTS = (
    "import sightline.commands.serve, sightline.app, sightline.infra.jobs.workers",
    "import sightline.commands.worker, sightline.job_handlers",
)


def test_a_start_loads_only_what_it_needs() -> None:
    """Both starts, one after the other in one process."""
    loaded = f"print([name for name in {LATER!r} if name in sys.modules])"
    done = python("; ".join(("import sys", *(f"{start}; {loaded}" for start in STARTS))))
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["[]", "[]"]
