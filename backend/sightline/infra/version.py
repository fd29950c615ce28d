"""Which code computed a number: the package's version and, where it is known, the git commit."""

from __future__ import annotations

import os
import re
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

_COMMIT = re.compile(r"^[0-9a-f]{40}$")


@cache
def code_version() -> str:
    """For instance `0.1.0+1bfeeb0c2a41`; stored with every measurement.

    The commit comes from SIGHTLINE_COMMIT (an image is built without .git), else from the checkout.
    """
    try:
        number = version("sightline")
    except PackageNotFoundError:
        number = "0"
    commit = os.environ.get("SIGHTLINE_COMMIT", "").strip() or _checked_out()
    return f"{number}+{commit[:12]}" if commit else number


def _checked_out() -> str:
    """The commit that HEAD names, read from the files of .git; empty where there is no checkout."""
    git = Path(__file__).resolve().parents[3] / ".git"
    try:
        head = (git / "HEAD").read_text(encoding="ascii").strip()
        if not head.startswith("ref: "):
            return head if _COMMIT.match(head) else ""
        return _branch(git, head.removeprefix("ref: "))
    except (OSError, UnicodeDecodeError):
        return ""


def _branch(git: Path, name: str) -> str:
    loose = git / name
    if loose.is_file():
        return loose.read_text(encoding="ascii").strip()
    for line in (git / "packed-refs").read_text(encoding="ascii").splitlines():
        if line.endswith(f" {name}"):
            return line.split(" ", 1)[0]
    return ""
