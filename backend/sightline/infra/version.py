"""Which code computed a number: the version with its commit, and whether files differed from that commit."""

import re
import subprocess
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

#: What `git describe` says: perhaps a tag and how far it is, the commit, perhaps that files differ from it.
_DESCRIBED = re.compile(r"(?:v?([0-9][0-9.]*)-\d+-g)?([0-9a-f]{12})(-dirty)?\n")
_GIT_DESCRIBE = ("git", "describe", "--always", "--long", "--tags", "--dirty", "--abbrev=12")
_GIT_WAIT_S = 10


@cache
def code_version() -> str:
    """For instance `0.1.0+g1bfeeb0c2a41`, `.dirty` behind it where tracked files differ from the commit.

    In a checkout it is that of the present commit, asked of git once a process; elsewhere what the build
    wrote into the package (setup.py). Where neither knows it ends in `+unknown`.
    """
    checkout = Path(__file__).resolve().parents[3]
    if (checkout / "pyproject.toml").is_file() and (checkout / ".git").exists():
        return version_of_checkout(checkout)
    return _built()


def version_of_checkout(folder: Path) -> str:
    """The version of the commit that is checked out in `folder`, and of what was changed there since."""
    number = _built().partition("+")[0]
    try:
        asked = [*_GIT_DESCRIBE, "--match", "v[0-9]*", "--match", "[0-9]*"]
        done = subprocess.run(
            asked, cwd=folder, capture_output=True, text=True, timeout=_GIT_WAIT_S, check=False
        )
    except (OSError, subprocess.SubprocessError):
        return f"{number}+unknown"
    described = _DESCRIBED.fullmatch(done.stdout) if done.returncode == 0 else None
    if described is None:
        return f"{number}+unknown"
    tagged, commit, dirty = described.groups()
    return f"{tagged or number}+g{commit}{'.dirty' if dirty else ''}"


def _built() -> str:
    try:
        return version("sightline")
    except PackageNotFoundError:
        return "0+unknown"
