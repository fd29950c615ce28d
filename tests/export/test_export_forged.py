"""Ways to forge a package, each by somebody who makes all sums fit, and what gives it away.

Who also runs the program over the forged rows (`rederive`) has statistics, figures and report that agree with
them; who also writes the chain's last event anew (`reseal`), has a seal that agrees. What is left to that
forger, some tests say: it takes the chain's head, kept elsewhere.
"""

import json
import math
import shutil
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import cv2
import pytest

from sightline.cli import main
from sightline.export.verify.package import PackageCheck, verify_package
from sightline.infra.audit.anchors import Anchors
from sightline.infra.audit.merkle import root_of
from sightline.infra.audit.records import AuditHead
from sightline.infra.audit.signing import SigningKey
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.csv_package.schema import json_bytes, sha256_hex
from sightline.infra.services import Services
from sightline.messages.said import Said
from tests.support.app import Client
from tests.support.forgeries import REFUSED_APART, WAYS, a_makers_height, roof
from tests.support.ground import Ground, add_vehicle, measure
from tests.support.mutations import checked, load, mutated, with_sums
from tests.support.packages import (
    camera_moved,
    edit,
    ground,
    package,
    rederive,
    rehash,
    reseal,
    rewrite,
    rows,
    worked,
    written,
)
from tests.support.proofs import every

__all__ = ["ground", "package", "worked"]


def check(place: Path, *heads: str, key: str | None = None) -> PackageCheck:
    return verify_package(FolderFiles(place), Anchors(key, heads))


@pytest.mark.once
@pytest.mark.parametrize("forge", every(4, WAYS, REFUSED_APART), ids=lambda forge: forge.__name__)
def test_what_is_forged_is_found(package: Path, forge: Callable[[Path], str]) -> None:
    said = forge(package)
    found = check(package)
    assert not found.ok and said in str(found.problem), found.problem
    assert "\n" not in str(found.problem)


@pytest.mark.once
@pytest.mark.parametrize("earlier", [False, True])
def test_what_a_camera_that_moved_does_to_a_height_is_computed_again(
    operator: Client, services: Services, ground: Ground, tmp_path: Path, earlier: bool
) -> None:
    """From the motion in the events and the height's own clicks, of events that tell it."""
    measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    camera_moved(services, ground, 2, earlier=earlier)
    place = written(services, ground.survey_id, tmp_path / "export")
    (recording,), (row,) = rows(place, "recordings.csv"), rows(place, "measurements.csv")
    assert recording["drift_distance_m"] == ("" if earlier else "4.000000")
    flags = [Said.read(one) for one in json.loads(row["flags_code"])]
    assert flags[-1].values.get("error_m") == (None if earlier else 0.041)
    assert check(place).ok, check(place).problem

    def say(*last: Said) -> PackageCheck:
        told = [*flags[:-1], *last]
        codes = json.dumps([one.document for one in told], separators=(",", ":"), ensure_ascii=False)
        for name in ("measurements.csv", "revisions.csv"):
            edit(place, name, lambda _: True, flags="; ".join(map(str, told)), flags_code=codes)
        reseal(place)
        return check(place)

    for forged in ((), (Said("height-flag-camera-moved-height", moved_px=2.5, error_m=0.001),)):
        assert "the last warning is not what" in str(say(*forged).problem)
    # what an earlier version said of the nearest road stays as it was said
    told = say(Said("height-flag-camera-moved-by", moved_px=2.5, error_m=0.013))
    assert ("the last warning is not what" in str(told.problem)) is not earlier


@pytest.mark.once
def test_the_package_itself_passes_and_a_forged_one_ends_the_command_with_one_sentence(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["verify", str(package)]) == 0
    assert "heights" in capsys.readouterr().out
    edit(package, "measurements.csv", roof, height_m="1.210000")
    assert main(["verify", str(package), "--json"]) == 1
    printed = capsys.readouterr()
    assert json.loads(printed.out)["status"] == "broken"
    assert "measurements.csv was changed" in printed.err and "\n" not in printed.err.strip()


@pytest.mark.once
@pytest.mark.parametrize("name", ["tables/reviews.csv", "records/pose-1.json", "audit.csv", "crops/m1-1.jpg"])
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
    assert not found.ok and "goes through the given audit head" in str(found.problem)


@pytest.mark.once
def test_a_crop_repainted_with_its_hash_takes_the_head(package: Path) -> None:
    """Only the video could tell what it showed; the seal tells that it is another."""
    kept = rows(package, "audit.csv")[-1]["hash"]
    row = rows(package, "crops.csv")[0]
    picture = cv2.imread(str(package / row["file"]))
    picture[:] = 0
    cv2.imwrite(str(package / row["file"]), picture)
    edit(
        package, "crops.csv", lambda one: one == row, sha256=sha256_hex((package / row["file"]).read_bytes())
    )
    rederive(package, seal=False)
    assert "is not what the package’s seal" in str(check(package).problem)
    reseal(package)
    assert check(package).ok
    assert "goes through the given audit head" in str(check(package, kept).problem)


@pytest.mark.once
def test_a_name_takes_the_head(package: Path) -> None:
    """No event of the package holds people's names: the seal alone binds them."""
    kept = rows(package, "audit.csv")[-1]["hash"]
    changed = [{**row, "name": f"Not {row['name']}"} for row in rows(package, "people.csv")]
    rewrite(package, "people.csv", changed)
    rederive(package, seal=False)
    assert str(check(package).problem).startswith("tables/people.csv is not what the package’s seal")
    reseal(package)
    assert check(package).ok
    assert "goes through the given audit head" in str(check(package, kept).problem)


@pytest.mark.once
def test_the_head_of_the_report_vouches_for_the_rows_and_says_so(package: Path) -> None:
    events = rows(package, "audit.csv")
    last = events[-2]["hash"]
    found = check(package, last)
    assert found.ok and f"continues event {len(events) - 1}," in " ".join(found.notes)


@pytest.mark.once
def test_anchors_hold_in_every_place(
    package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a survey's package, a copy, and a copy that somebody forged, with a seal and a signature of it."""
    first, last = (rows(package, "audit.csv")[at]["hash"] for at in (0, -1))
    kept = shutil.copyfile(package / "checkpoint.json", tmp_path / "kept.json")
    again, forged = (shutil.copytree(package, tmp_path / name) for name in ("again", "forged"))
    rewrite(forged, "people.csv", [{**row, "name": "X"} for row in rows(forged, "people.csv")])
    rederive(forged)
    both = ["verify", str(package), str(again), "--head", first, "--head", last, "--checkpoint", str(kept)]
    assert main([*both, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["status"], told["problems"]) == ("holds", [])
    assert [one["place"] for one in told["places"]] == [str(package), str(again)]
    assert main(["verify", str(package), "--head", first, "--head", "0" * 64]) == 1
    assert "the given audit head 0000000000000000" in capsys.readouterr().err
    assert main(["verify", str(package), str(forged)]) == 0
    for given in (["--head", last], ["--checkpoint", str(kept)], ["--head", first, "--head", last]):
        assert main(["verify", str(package), str(forged), *given]) == 1
        said = capsys.readouterr()
        assert said.err.startswith(f"{forged}: ") and str(package) in said.out


@pytest.mark.once
def test_no_place_hides_another(package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What is broken, what is no package and what is not there are all told, also as JSON."""
    broken, nothing, away = shutil.copytree(package, tmp_path / "broken"), tmp_path / "n.zip", tmp_path / "a"
    (broken / "audit.csv").write_bytes(b"")
    nothing.write_text("PK")
    assert main(["verify", str(broken), str(nothing), str(package), str(away), "--json"]) == 1
    said = capsys.readouterr()
    told = json.loads(said.out)
    assert [one["status"] for one in told["places"]] == ["broken", "refused", "holds", "refused"]
    assert told["status"] == "broken" and len(told["problems"]) == 3
    assert all(str(place) in said.err for place in (broken, nothing, away)) and said.err.count("\n") == 3
    assert main(["verify", str(package), str(away), "--json"]) == 2
    assert json.loads(capsys.readouterr().out)["status"] == "refused"
    assert main(["verify", str(nothing), "--json"]) == 2
    assert json.loads(capsys.readouterr().out)["status"] == "refused"


@pytest.mark.once
@pytest.mark.parametrize("planted", ["sightline.db", "manifest.json"])
def test_nothing_that_is_planted_hides_a_package(
    package: Path, planted: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (package / planted).write_text("{}")
    for removed in ("", "SHA256SUMS"):
        (package / (removed or "none")).unlink(missing_ok=True)
        assert main(["verify", str(package)]) == 2
        said = capsys.readouterr().err
        assert planted in said and "belong to different things" in said


@pytest.mark.once
def test_what_an_anchor_reaches_is_told(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Of a head and of a checkpoint alike; of two checkpoints of one moment, each is held."""
    events = rows(package, "audit.csv")
    chain, key = f"survey/{events[-1]['survey_id']}", SigningKey(b"1" * 32)

    def signed(number: int, hash_: str) -> dict[str, Any]:
        ends = {chain: AuditHead(number, hash_)}
        said = {"format": "sightline-checkpoint-1", "at": "2026-05-04T06:00:00.000000+00:00", "chains": 1}
        said |= {"root": root_of(ends), "key": key.public}
        return {**said, "signature": key.sign(said), "ends": [[chain, number, hash_]]}

    def check_with(*checkpoints: dict[str, Any]) -> PackageCheck:
        return verify_package(FolderFiles(package), Anchors(checkpoints=checkpoints))

    early, end = signed(1, events[0]["hash"]), signed(len(events), events[-1]["hash"])
    found = check_with(early)
    assert found.ok and found.vouched == 1 and "continues event 1," in " ".join(found.notes), found.problem
    found = check_with(end, early)
    assert found.ok and found.vouched == len(events) and "continues event" not in " ".join(found.notes)
    for given in ((signed(2, "b" * 64), end), (end, signed(2, "b" * 64))):
        assert "rewritten, or is of another installation" in str(check_with(*given).problem)
    found = check_with(signed(len(events) + 1, "b" * 64))
    assert "is older than the checkpoint" in str(found.problem) and "restore" not in str(found.problem)
    chain = "survey/99"
    assert "of another survey or installation" in str(check_with(end, signed(1, "b" * 64)).problem)


@pytest.mark.once
def test_what_is_no_checkpoint_is_refused(
    package: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "kept.json"
    for text in ("[1]", "1", "{}", '{"format": "sightline-checkpoint-1"}'):
        place.write_text(text)
        assert main(["verify", str(package), "--checkpoint", str(place)]) == 2, text
        assert "no checkpoint" in capsys.readouterr().err


@pytest.mark.once
def test_a_package_without_its_seal_is_none(package: Path) -> None:
    lines = (package / "audit.csv").read_bytes().splitlines(keepends=True)
    (package / "audit.csv").write_bytes(b"".join(lines[:-1]))
    reseal(package, seal=False)
    assert "does not end with the event that seals" in str(check(package).problem)


@pytest.mark.once
def test_what_is_signed_anew_takes_the_key(package: Path) -> None:
    """A forger writes the chain, the seal and a signature of their own: the installation's key tells."""
    document = json.loads((package / "checkpoint.json").read_text())
    key = document["key"]
    assert check(package, key=key[:16]).ok and check(package).key == key
    edit(package, "crops.csv", lambda row: row["file"] != "", reason="x")
    reseal(package)
    assert "not with the given key" in str(check(package, key=key).problem)
    forged = json.loads((package / "checkpoint.json").read_text())
    forged["keys"] = [*document["keys"], {**forged["keys"][0], "after": key}]
    (package / "checkpoint.json").write_bytes(json_bytes(forged))
    reseal(package, seal=False)
    assert "how its key follows" in str(check(package, key=key).problem)


@pytest.mark.once
@pytest.mark.parametrize(
    "change",
    every(
        3,
        [
            {"at": "2020-01-01T00:00:00.000000+00:00"},
            {"chains": 7},
            {"root": "0" * 64},
            {"key": "0" * 64},
            {"signature": "0" * 128},
            {"place": 1},
            {"path": []},
            {"leaf": {}},
            {"keys": []},
            {"format": "sightline-checkpoint-2"},
        ],
    ),
    ids=str,
)
def test_every_part_of_the_checkpoint_is_bound(package: Path, change: dict[str, Any]) -> None:
    document = json.loads((package / "checkpoint.json").read_text())
    assert {**document, **change} != document
    (package / "checkpoint.json").write_bytes(json_bytes({**document, **change}))
    reseal(package, seal=False)
    found = check(package)
    assert not found.ok and "checkpoint.json" in str(found.problem)


@pytest.mark.once
@pytest.mark.parametrize("name", ["place", "chains", "count"])
def test_a_checkpoints_numbers_have_one_form(package: Path, name: str) -> None:
    """8.0 is 8 to whoever computes with it, and other bytes: one of the two is refused."""
    document = json.loads((package / "checkpoint.json").read_text())
    assert check(package).ok
    held = document["leaf"] if name == "count" else document
    held[name] = float(held[name])
    (package / "checkpoint.json").write_text(json.dumps(document, indent=2) + "\n")
    reseal(package, seal=False)
    found = check(package)
    assert not found.ok and "checkpoint.json" in str(found.problem)


FORMS: dict[str, tuple[str, Callable[[bytes], bytes], str]] = {
    "ends of lines": ("tables/vehicles.csv", lambda b: b.replace(b"\n", b"\r\n"), "is not written as"),
    "quotes": ("tables/insets.csv", lambda b: b.replace(b"roof", b'"roof"', 1), "is not written as"),
    "a byte order mark": ("tables/frames.csv", lambda b: b"\xef\xbb\xbf" + b, "has other columns"),
    "an empty line": ("tables/frames.csv", lambda b: b + b"\n", "too long or too short"),
    "no last end": ("tables/frames.csv", lambda b: b[:-1], "is not written as"),
    "a column twice": (
        "tables/people.csv",
        lambda b: b"".join(b"id," + line for line in b.splitlines(keepends=True)),
        "has other columns than datapackage.json describes (id)",
    ),
    "a column of another pose": (
        "clicks/pose-1.csv",
        lambda b: b.replace(b"lighting", b"Lighting", 1),
        "has other columns than datapackage.json describes (Lighting)",
    ),
    "a key twice": (
        "poses/pose-1.json",
        lambda b: b.replace(b"{", b'{\n  "format": "x",', 1),
        "is not written as",
    ),
    "a number's text": (
        "records/pose-1.json",
        lambda b: b.replace(b"0.0,", b"0.00,", 1),
        "is not written as",
    ),
    "no text": ("tables/cameras.csv", lambda b: b[:-3] + b"\xff\r\n", "cannot be read as CSV"),
}


@pytest.mark.once
@pytest.mark.parametrize("form", every(3, FORMS, ["a key twice"]))
def test_another_form_of_the_same_is_refused(package: Path, form: str) -> None:
    """Two programs might read two things in it."""
    name, change, said = FORMS[form]
    place = package / name
    before = place.read_bytes()
    place.write_bytes(change(before))
    assert place.read_bytes() != before
    reseal(package)
    found = check(package)
    assert not found.ok and name in str(found.problem) and said in str(found.problem), found.problem


@pytest.mark.once
@pytest.mark.parametrize("changes", [10, pytest.param(30, marks=pytest.mark.proof)])
def test_any_single_change_is_found(package: Path, changes: int) -> None:
    """A few of the ten thousand of `tests/bench/bench_forgery.py`, all sums made to fit."""
    whole, random = load(package), Random(15)
    assert checked(whole).ok
    for _ in range(changes):
        words, changed = mutated(whole, random)
        assert not checked(with_sums(changed, whole)).ok, words
