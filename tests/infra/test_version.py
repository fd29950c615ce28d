"""The version that every number is stored with: commit and dirtiness, and never a false one."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sightline.infra.version import code_version, version_of_checkout

pytestmark = pytest.mark.once

ROOT = Path(__file__).resolve().parents[2]
ASIDE = {"GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}


def git(folder: Path, *arguments: str) -> str:
    who = ("-c", "user.name=Ada", "-c", "user.email=ada@example.org")
    done = subprocess.run(
        ["git", "-C", str(folder), *who, *arguments], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The files of a build with one commit."""
    for name, value in ASIDE.items():
        monkeypatch.setenv(name, value)
    folder = tmp_path / "repository"
    (folder / "backend" / "sightline").mkdir(parents=True)
    for name in ("setup.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder)
    git(tmp_path, "init", "-q", str(folder))
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "first")
    return folder


def built(folder: Path) -> str:
    """What a build in this folder calls itself."""
    done = subprocess.run(
        [sys.executable, "setup.py", "--version"], cwd=folder, capture_output=True, text=True, check=True
    )
    return done.stdout.splitlines()[-1]


def test_a_checkout_and_a_build_of_it_have_one_version(repository: Path) -> None:
    commit = git(repository, "rev-parse", "--short=12", "HEAD")
    assert version_of_checkout(repository) == built(repository) == f"0.1.0+g{commit}"
    (repository / "README.md").write_text("changed")
    assert version_of_checkout(repository) == built(repository) == f"0.1.0+g{commit}.dirty"
    git(repository, "tag", "v0.2.0")
    git(repository, "commit", "-qam", "second")
    later = git(repository, "rev-parse", "--short=12", "HEAD")
    assert version_of_checkout(repository) == built(repository) == f"0.2.0+g{later}"


def test_a_worktree_says_its_own_commit(repository: Path, tmp_path: Path) -> None:
    beside = tmp_path / "beside"
    git(repository, "worktree", "add", "-q", "-b", "side", str(beside))
    git(beside, "commit", "-q", "--allow-empty", "-m", "aside")
    assert (beside / ".git").is_file()
    assert version_of_checkout(beside) != version_of_checkout(repository)
    assert version_of_checkout(beside).endswith(git(beside, "rev-parse", "--short=12", "HEAD"))


def test_without_git_or_a_commit_it_says_that_it_does_not_know(
    repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    empty = tmp_path / "empty"
    git(tmp_path, "init", "-q", str(empty))
    assert version_of_checkout(empty).endswith("+unknown")
    shutil.rmtree(repository / ".git")
    assert built(repository) == "0.1.0+unknown"
    monkeypatch.setenv("SETUPTOOLS_SCM_PRETEND_VERSION_FOR_SIGHTLINE", "0.1.0+g0123456789ab.dirty")
    assert built(repository) == "0.1.0+g0123456789ab.dirty"  # an image is told
    monkeypatch.setenv("PATH", str(empty))
    assert version_of_checkout(repository).endswith("+unknown")


def test_this_program_says_its_commit() -> None:
    if not (ROOT / ".git").exists():
        pytest.skip("not a checkout")
    assert git(ROOT, "rev-parse", "--short=12", "HEAD") in code_version()
    assert len(code_version()) <= 60  # the columns that hold it
