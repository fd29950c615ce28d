"""The page of a package: it carries the package's own tables, and `verify` takes no other page."""

import base64
import json
import re
import zlib
from pathlib import Path

import pytest

from sightline.export import page
from sightline.export.verify.package import PackageCheck, verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.csv_package.schema import json_bytes
from tests.support.packages import ground, package, reseal, rows, worked

__all__ = ["ground", "package", "worked"]

pytestmark = pytest.mark.skipif(page.template() is None, reason="the front end is not built")
BLOCK = re.compile(r'data-path="([^"]+)">([^<]*)<')


def check(place: Path) -> PackageCheck:
    return verify_package(FolderFiles(place))


def carried(text: str) -> dict[str, bytes]:
    """What a page carries, unpacked by other code than the program's."""
    return {path: zlib.decompress(base64.b64decode(one), -15) for path, one in BLOCK.findall(text)}


def resealed(place: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The problem of a page that somebody wrote and sealed anew, with a key of their own."""
    with monkeypatch.context() as patch:
        patch.setattr("tests.support.packages.write_audit_script", lambda *_: None)
        reseal(place)
    return str(check(place).problem)


def test_it_carries_the_tables_and_the_chain_and_is_sealed(package: Path) -> None:
    found = carried((package / "index.html").read_text())
    tables = {f"tables/{name}.csv" for name in ("measurements", "budget", "crops")}
    assert {*tables, "records/pose-1.json"} <= set(found)
    assert all((package / path).read_bytes() == content for path, content in found.items())
    sealed = json.loads(rows(package, "audit.csv")[-1]["after"])["files"]
    assert "index.html" in sealed and "audit.js" not in sealed
    script = (package / "audit.js").read_text()
    told = json.loads(script.removeprefix("globalThis.sightlineAudit = ").removesuffix(";\n"))
    assert {name: zlib.decompress(base64.b64decode(one), -15) for name, one in told.items()} == {
        name: (package / name).read_bytes() for name in ("audit.csv", "checkpoint.json")
    }
    assert check(package).ok and not any("page" in note for note in check(package).notes)


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        (
            lambda text: re.sub("(<body[^>]*>)", r"\1<script>alert(1)</script>", text),
            "index.html is not the page",
        ),
        (lambda text: text.replace("</body>", "<p>All is well.</p></body>"), "index.html is not the page"),
        (lambda text: BLOCK.sub("", text, count=1), "index.html is not the page"),
        (lambda text: text.replace('"bytes": ', '"bytes": 1', 1), "index.html is not the page"),
        (
            lambda text: text.replace(
                'data-path="tables/measurements.csv">', 'data-path="tables/measurements.csv">AAAA', 1
            ),
            "The page carries another tables/measurements.csv",
        ),
        (
            lambda text: text.replace('data-path="tables/budget.csv"', 'data-path="tables/people.csv"', 1),
            "The page carries another tables/people.csv",
        ),
    ],
)
def test_another_page_is_refused_though_it_is_sealed_anew(
    package: Path, change: object, problem: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = package / "index.html"
    before = place.read_text()
    place.write_text(change(before))  # type: ignore[operator]
    assert place.read_text() != before
    assert resealed(package, monkeypatch).startswith(problem)


def test_another_chain_beside_the_page_is_refused(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    place = package / "audit.js"
    place.write_text(place.read_text() + "alert(1);\n")
    assert "another audit.js" in resealed(package, monkeypatch)
    place.write_text("globalThis.sightlineAudit = {};\n")  # as where the chain is too large for a page
    monkeypatch.setattr(page, "MOST_BYTES", 1)
    assert "another audit.js" not in resealed(package, monkeypatch)


def test_the_page_cannot_be_left_out(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (package / "index.html").unlink()
    described = json.loads((package / "datapackage.json").read_text())
    described["resources"] = [one for one in described["resources"] if one["path"] != "index.html"]
    (package / "datapackage.json").write_bytes(json_bytes(described))
    assert "index.html is not described by datapackage.json, or missing" in resealed(package, monkeypatch)


def test_a_page_of_another_version_is_said_and_not_refused(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = f"{page.template()}\n"
    monkeypatch.setattr(page, "template", lambda: other)
    found = check(package)
    assert found.ok and "The page was made by another version" in " ".join(found.notes)


def test_where_the_front_end_is_not_built_there_is_no_page(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "template", lambda: None)
    assert page.page_version() == "none"
    assert check(package).ok


def test_a_table_that_is_too_large_is_named_and_not_carried(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "MOST_BYTES", (package / "tables/measurements.csv").stat().st_size - 1)
    reseal(package, page=True)
    text = (package / "index.html").read_text()
    assert "tables/measurements.csv" not in carried(text) and "tables/budget.csv" in carried(text)
    assert '"left_out": ["tables/measurements.csv"' in text
    assert check(package).ok
