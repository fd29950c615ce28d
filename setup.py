"""The version of a build, by setuptools-scm: `0.1.0+g1bfeeb0c2a41`, `.dirty` behind it where tracked files differ
from the commit.

Without a repository (an image, an archive) or without git it is what SETUPTOOLS_SCM_PRETEND_VERSION_FOR_SIGHTLINE
says, else `0.1.0+unknown`.

A wheel also holds what lies outside the package: the migrations, and the pages where they are built. Everything
else of the build is in pyproject.toml.
"""

import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools_scm.version import ScmVersion

BEFORE_THE_FIRST_TAG = "0.1.0"
ROOT = Path(__file__).resolve().parent
#: Folders of the repository and what they are called in the package.
BESIDE = {"migrations": "_migrations", "frontend/dist": "_pages"}


def number(version: ScmVersion) -> str:
    """The newest tag's number."""
    return str(version.tag)


def commit(version: ScmVersion) -> str:
    """The commit, and whether tracked files differ from it."""
    return f"+{(version.node or 'unknown')[:13]}{'.dirty' if version.dirty else ''}"


def without_commit() -> str:
    """The version where no commit can be known."""
    known = (ROOT / ".git").exists() and shutil.which("git")
    return BEFORE_THE_FIRST_TAG if known else f"{BEFORE_THE_FIRST_TAG}+unknown"


class BuildWhole(build_py):
    """Copies the package, and with it what a checkout keeps beside it."""

    def run(self) -> None:
        super().run()
        if self.editable_mode:
            return
        for source, name in BESIDE.items():
            target = Path(self.build_lib) / "sightline" / name
            shutil.rmtree(target, ignore_errors=True)
            if (ROOT / source).is_dir():
                shutil.copytree(ROOT / source, target, ignore=shutil.ignore_patterns("__pycache__"))


setup(
    cmdclass={"build_py": BuildWhole},
    use_scm_version={
        "version_scheme": number,
        "local_scheme": commit,
        "fallback_version": without_commit(),
    }
)
