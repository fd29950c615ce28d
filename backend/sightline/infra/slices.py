"""What slices declare in files of a known name, found without naming the slices."""

import importlib
from functools import cache
from pathlib import Path

import sightline

_ROOT = Path(sightline.__file__ or "").parent


@cache
def load_every(name: str) -> tuple[str, ...]:
    """Import each `name.py` of the package, and say which modules those are: none can be forgotten."""
    files = sorted(_ROOT.rglob(f"{name}.py"))
    modules = tuple(".".join(("sightline", *path.relative_to(_ROOT).with_suffix("").parts)) for path in files)
    for module in modules:
        importlib.import_module(module)
    return modules


def load_tables() -> None:
    """After this the metadata holds every table of every slice."""
    load_every("tables")
