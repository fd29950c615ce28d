"""Ways to forge a package, each by somebody who makes all sums fit, and what gives it away.

Who also runs the program over the forged rows (`rederive`) has statistics, figures and report that agree with
them. What is left to a forger, the last two tests say: it takes the chain's head, or the ZIP's SHA-256, kept
elsewhere.
"""

import json
import math
from collections.abc import Callable
from pathlib import Path

import cv2
import pytest

from sightline.cli import main
from sightline.export.verify.package import PackageCheck, verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.csv_package.schema import sha256_hex
from tests.support.forgeries import WAYS, a_makers_height, roof
from tests.support.packages import edit, ground, package, rederive, rehash, reseal, rewrite, rows, worked

__all__ = ["ground", "package", "worked"]


def check(place: Path, head: str | None = None) -> PackageCheck:
    return verify_package(FolderFiles(place), head)


@pytest.mark.once
@pytest.mark.parametrize("forge", WAYS, ids=lambda forge: forge.__name__)
def test_what_is_forged_is_found(package: Path, forge: Callable[[Path], str]) -> None:
    said = forge(package)
    found = check(package)
    assert not found.ok and said in str(found.problem), found.problem
    assert "\n" not in str(found.problem)


@pytest.mark.once
def test_the_package_itself_passes_and_a_forged_one_ends_the_command_with_one_sentence(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["verify", str(package)]) == 0
    assert "heights" in capsys.readouterr().out
    edit(package, "measurements.csv", roof, height_m="1.210000")
    assert main(["verify", str(package), "--json"]) == 1
    printed = capsys.readouterr()
    assert json.loads(printed.out)["ok"] is False
    assert "measurements.csv was changed" in printed.err and "\n" not in printed.err.strip()


@pytest.mark.once
@pytest.mark.parametrize("name", ["reviews.csv", "records/pose-1.json", "audit.csv", "crops/m1-1.jpg"])
def test_a_file_that_is_taken_out_is_missed(package: Path, name: str) -> None:
    (package / name).unlink()
    assert f"{name} is missing" in str(check(package).problem)


@pytest.mark.once
@pytest.mark.parametrize("column", ["content_sha256", "previous_hash"])
def test_a_column_that_is_missing_is_told_in_one_sentence(package: Path, column: str) -> None:
    events = rows(package, "audit.csv")
    rewrite(package, "audit.csv", [{k: v for k, v in one.items() if k != column} for one in events])
    reseal(package)
    found = check(package)
    assert not found.ok and column in str(found.problem) and "\n" not in str(found.problem)


@pytest.mark.once
def test_a_chain_written_anew_takes_the_head_that_was_kept_elsewhere(package: Path) -> None:
    """Rows, events and every hash from there on: sound in itself. Only what is outside the package knows."""
    events = rows(package, "audit.csv")
    kept = events[-1]["hash"]
    assert check(package, kept[:16]).ok
    at = next(
        n for n, one in enumerate(events) if one["entity"] == "vehicle" and '"1.3' in one["after"] + '"1.3'
    )
    after = json.loads(events[at]["after"])
    assert math.isclose(after["manufacturer_height_m"], 1.3)
    after["manufacturer_height_m"] = 1.31
    events[at]["after"] = json.dumps(after, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    rewrite(package, "audit.csv", rehash(events, max(at, 1)))
    a_makers_height(package, drawings=True)
    assert check(package).ok
    found = check(package, kept[:16])
    assert not found.ok and "not with the head that was kept" in str(found.problem)


@pytest.mark.once
def test_a_crop_repainted_with_its_hash_takes_the_sum_of_the_zip(package: Path) -> None:
    """Only the video could tell; the SHA-256 of the ZIP, on the export page, tells that it was touched."""
    row = rows(package, "crops.csv")[0]
    picture = cv2.imread(str(package / row["file"]))
    picture[:] = 0
    cv2.imwrite(str(package / row["file"]), picture)
    edit(
        package, "crops.csv", lambda one: one == row, sha256=sha256_hex((package / row["file"]).read_bytes())
    )
    rederive(package, drawings=True)
    assert check(package).ok


@pytest.mark.once
def test_a_name_takes_the_sum_of_the_zip(package: Path) -> None:
    """No event of the package holds people's names: its description says so."""
    changed = [{**row, "name": f"Not {row['name']}"} for row in rows(package, "people.csv")]
    rewrite(package, "people.csv", changed)
    rederive(package, drawings=True)
    assert check(package).ok
    described = json.loads((package / "datapackage.json").read_text())
    assert "names of people" in described["description"] and "SHA-256 of the ZIP" in described["description"]
