"""Each import contract is broken by a file that breaks it: planted in a copy of the package."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from graphlib import TopologicalSorter
from pathlib import Path
from typing import Any

import grimp
import pytest

ROOT = Path(__file__).resolve().parents[1]
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
LINT = (
    "import sys; from importlinter.cli import lint_imports_command; sys.argv[1:] = ['--no-cache']; "
    "lint_imports_command()"
)
# By the beginning of a contract's name: a file that may not import what the contract keeps for others.
PLACES = {
    "Imports go down the list only": "surveys/planted.py",
    "SQL in store": "reviews/planted_service.py",
    "HTTP in routes": "results/planted_store.py",
    "The server itself in commands": "people/planted_routes.py",
    "Codecs and the object store": "scans/planted_job.py",
    "The pure rooms read nothing": "detection/planted.py",
}
# What to import there, for the contracts that are no list of packages.
IMPORTS = {
    "Imports go down the list only": ["sightline.reviews.records"],
    "The pure rooms read nothing": [
        "pathlib",
        "os",
        "io",
        "socket",
        "sqlalchemy",
        "fastapi",
        "sightline.settings",
    ],
}


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A copy of the package, to be spoilt."""
    copy = tmp_path / "sightline"
    shutil.copytree(ROOT / "backend/sightline", copy, ignore=shutil.ignore_patterns("__pycache__"))
    return copy


def linted(package: Path) -> str:
    """What the contracts of this checkout say of the copy, in one line."""
    environment = {**os.environ, "PYTHONPATH": str(package.parent), "COLUMNS": "1000"}
    command = [sys.executable, "-c", LINT]
    run = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    said = re.sub(r"\s+", " ", run.stdout)
    assert run.returncode == (0 if " 0 broken" in said else 1), run.stderr
    return said


def test_a_violation_of_each_contract_is_found(package: Path) -> None:
    planted = {beginning: imports_for(contract_named(beginning)) for beginning in PLACES}
    for beginning, names in planted.items():
        # inside a function, where an import is easily overlooked
        text = "def later() -> None:\n" + "".join(f"    import {name}\n" for name in names)
        (package / PLACES[beginning]).write_text(text)
    said = linted(package)
    for beginning, names in planted.items():
        assert re.search(rf"{beginning}(?:(?!KEPT|BROKEN).)*BROKEN", said), beginning
        module = "sightline." + PLACES[beginning].removesuffix(".py").replace("/", ".")
        for name in names:
            assert f"{module} -> {name}" in said
    assert f" 0 kept, {len(CONTRACTS)} broken" in said


def contract_named(beginning: str) -> dict[str, Any]:
    (contract,) = (one for one in CONTRACTS if one["name"].startswith(beginning))
    return dict(contract)


def imports_for(contract: dict[str, Any]) -> list[str]:
    """Every package that the contract keeps for others, so that none is listed under a wrong name."""
    beginning = next(one for one in PLACES if contract["name"].startswith(one))
    return list(contract.get("packages") or IMPORTS[beginning])


def test_every_package_that_is_kept_for_others_is_installed() -> None:
    names = {name for contract in CONTRACTS for name in contract.get("packages", ())}
    for name in names:
        assert __import__(name), name


def test_a_file_in_no_room_is_refused(package: Path) -> None:
    (package / "helpers.py").write_text("X = 1\n")
    said = linted(package)
    assert " 1 broken" in said and "sightline.helpers" in said


@pytest.mark.proof
def test_the_package_itself_keeps_them(package: Path) -> None:
    """As `make check` says of the package in its place; that all but one hold of a copy, the test before."""
    assert " 0 broken" in linted(package)


def test_no_module_imports_itself_by_others() -> None:
    """Imports inside functions count; those for types alone do not."""
    graph = grimp.build_graph("sightline", exclude_type_checking_imports=True)
    imports = {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
    TopologicalSorter(imports).prepare()  # raises CycleError, which names the modules
