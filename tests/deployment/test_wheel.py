"""The wheel, installed where there is neither the repository nor Node, is the whole app."""

import os
import shutil
import subprocess
import sys
import sysconfig
import urllib.request
import venv
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browser.server import Server

pytestmark = pytest.mark.once

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "frontend" / "dist"
VERSION = "0.1.0+g0123456789ab.dirty"
INDEX = "<!doctype html><title>Sightline</title>"


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built as `make wheel` does, from a copy: with the pages, if they are built, else with a stand-in."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("dist")
    for name in ("setup.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    for name in ("backend", "migrations"):
        shutil.copytree(
            ROOT / name, source / name, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info")
        )
    if PAGES.is_dir():
        shutil.copytree(PAGES, source / "frontend" / "dist")
    else:
        (source / "frontend" / "dist").mkdir(parents=True)
        (source / "frontend" / "dist" / "index.html").write_text(INDEX)
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--no-index"]
    told = os.environ | {"SETUPTOOLS_SCM_PRETEND_VERSION_FOR_SIGHTLINE": VERSION}
    subprocess.run([*pip, "--wheel-dir", str(target), str(source)], env=told, check=True)
    return next(target.glob("sightline-*.whl"))


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The `sightline` of an environment of its own, which sees this one's libraries but not this checkout."""
    place = tmp_path_factory.mktemp("environment")
    venv.create(place, with_pip=False, symlinks=True)
    library = Path(sysconfig.get_path("purelib", vars={"base": str(place), "platbase": str(place)}))
    pip = [sys.executable, "-m", "pip", "--python", str(place / "bin" / "python"), "install", "--quiet"]
    subprocess.run([*pip, "--no-deps", "--no-index", str(wheel)], check=True)
    # A path in a .pth is looked at last, and the .pth files of a folder found that way are not read.
    (library / "libraries.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return place / "bin" / "sightline"


@pytest.fixture
def served(installed: Path, tmp_path: Path) -> Iterator[Server]:
    """`sightline serve` from an empty folder, and nothing said about where anything is."""
    log = tmp_path / "server.log"
    plain = {k: v for k, v in os.environ.items() if not k.startswith(("SIGHTLINE_", "PYTHON"))}
    (empty := tmp_path / "empty").mkdir()
    command = [str(installed), "serve", "--port", "0", "--workers", "0"]
    with log.open("w") as output:
        process = subprocess.Popen(
            command, cwd=empty, env=plain, stdout=output, stderr=subprocess.STDOUT, text=True
        )
    server = Server(process, log, empty / ".data")
    yield server
    server.stop()


def test_it_holds_pages_migrations_and_templates(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as packed:
        names = set(packed.namelist())
    sources = {path.relative_to(ROOT / "backend").as_posix() for path in (ROOT / "backend").rglob("*.typ")}
    assert sources <= names
    assert {"sightline/_pages/index.html", "sightline/_migrations/env.py"} <= names
    assert any(name.startswith("sightline/_migrations/versions/0001_") for name in names)
    assert not any("__pycache__" in name or name.startswith("tests/") for name in names)


def test_unpacked_it_finds_its_own_pages_and_migrations_and_says_its_version(
    wheel: Path, tmp_path: Path
) -> None:
    """What a server asks of it; `make proofs` installs it and starts one."""
    with zipfile.ZipFile(wheel) as packed:
        packed.extractall(tmp_path / "library")
    (empty := tmp_path / "empty").mkdir()
    program = (
        "from sightline.infra.database.engine import engine_at, migrate\n"
        "from sightline.infra.version import code_version\n"
        "from sightline.settings import Settings\n"
        "settings = Settings()\n"
        "with engine_at(settings.database_url) as engine: migrate(engine)\n"
        "print(code_version(), settings.data_dir, settings.frontend_dir)"
    )
    plain = {k: v for k, v in os.environ.items() if not k.startswith(("SIGHTLINE_", "PYTHON"))}
    library = {"PYTHONPATH": str(tmp_path / "library")}
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=empty,
        env=plain | library,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    pages = tmp_path / "library" / "sightline" / "_pages"
    assert done.stdout.split() == [VERSION, str(empty / ".data"), str(pages)]
    assert "<title>Sightline" in (pages / "index.html").read_text()
    assert (empty / ".data" / "sightline.db").is_file()


@pytest.mark.proof
def test_it_serves_the_app_from_an_empty_folder(served: Server) -> None:
    served.wait()
    with urllib.request.urlopen(f"{served.url}/api/health") as answer:
        assert VERSION in answer.read().decode()
    with urllib.request.urlopen(f"{served.url}/") as answer:
        assert "<title>Sightline" in answer.read().decode()
    assert (served.data_dir / "sightline.db").is_file()
    assert served.sign_in_link()
