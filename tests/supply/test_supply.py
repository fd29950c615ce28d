"""The list of parts names what the locks hold; the audit says in a sentence where it could not ask."""

import json
import re

import pytest

from tests.supply import audit
from tests.supply.sbom import ROOT, sbom
from tests.support.app import Client

LOCK = (ROOT / "requirements.lock").read_text(encoding="utf-8")


def test_each_pinned_package_is_a_part_with_its_hashes() -> None:
    found = sbom()
    assert (found["bomFormat"], found["specVersion"]) == ("CycloneDX", "1.6")
    refs = [part["bom-ref"] for part in found["components"]]
    assert len(set(refs)) == len(refs) and found["dependencies"][0]["dependsOn"] == refs
    pinned = set(re.findall(r"^([\w.-]+)(?:\[.*?\])?==", LOCK, re.M))
    python = [part for part in found["components"] if part["purl"].startswith("pkg:pypi/")]
    assert {part["name"] for part in python} == {re.sub(r"[-_.]+", "-", one).lower() for one in pinned}
    assert sum(len(part["hashes"]) for part in python) == LOCK.count("--hash=sha256:")
    pages = {part["name"]: part for part in found["components"] if part["purl"].startswith("pkg:npm/")}
    packages = json.loads((ROOT / "frontend" / "package.json").read_text(encoding="utf-8"))
    assert set(packages["dependencies"]) <= set(pages)
    assert all(len(one["content"]) == 128 for part in pages.values() for one in part["hashes"])
    fastapi = next(part for part in python if part["name"] == "fastapi")
    assert fastapi["licenses"] == [{"license": {"name": "MIT"}}]
    assert json.dumps(sbom()) == json.dumps(found)


def test_the_app_lists_what_it_runs_on(admin: Client) -> None:
    listed = {one["name"]: one for one in admin.seen("/system/licences")}
    parts = {(part["name"], part["version"]) for part in sbom()["components"]}
    assert {"fastapi", "sqlalchemy", "numpy", "psycopg-binary", "starlette"} <= set(listed)
    # An older installation may hold what the locks hold no more.
    names = {name for name, _ in parts}
    assert {(name, one["version"]) for name, one in listed.items() if name in names} <= parts
    assert listed["fastapi"]["licence"] == "MIT" and all(one["licence"] for one in listed.values())


def test_what_the_tools_answer_is_told_apart_from_no_answer() -> None:
    some = {"dependencies": [{"name": "a", "version": "1", "vulns": [{"id": "X-1"}]}, {"name": "b"}]}
    assert audit.python_faults(json.dumps(some)) == ["a 1: X-1"]
    assert audit.python_faults('{"dependencies": []}') == []
    assert audit.npm_faults('{"vulnerabilities": {"c": {"severity": "high"}}}') == ["c: high"]
    for told in ("", "no network", '{"message": "refused", "error": {}}', "[]"):
        with pytest.raises(audit.NotAsked):
            audit.python_faults(told)
        with pytest.raises(audit.NotAsked):
            audit.npm_faults(told)


def test_an_audit_without_a_network_says_so_and_ends_with_2(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refused() -> list[str]:
        raise audit.NotAsked("the network is closed")

    monkeypatch.setattr(audit, "faults_in_python", refused)
    monkeypatch.setattr(audit, "faults_in_pages", lambda: ["c: high"])
    assert audit.main() == 2
    told = capsys.readouterr()
    assert told.err.count("\n") == 1 and "not checked" in told.err and "c: high" in told.out
