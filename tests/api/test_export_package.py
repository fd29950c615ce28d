"""The export: valid Frictionless data, same state same bytes, heights compute again, nothing that runs."""

import csv
import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from frictionless import Package as Frictionless

from backend.cli import main
from backend.errors import NoRoom
from backend.storage.chain import event_hash, link_hash
from backend.storage.records import Job
from backend.work import exporting
from backend.work.packaging import with_checksums, write_directory
from backend.work.services import Services
from backend.work.verifying import _hashed, read_package, verify_package
from tests.api.conftest import Client
from tests.api.ground import Ground, add_vehicle, clicks, lay_ground, measure, pixel

FORMULA = '=HYPERLINK("http://example.org","x")'


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def worked(operator: Client, reviewer: Client, ground: Ground) -> Ground:
    """A survey with every kind of work: measured, revised, fixed, rejected, withdrawn, not measurable."""
    first = add_vehicle(operator, ground.recording_id, make=FORMULA, model="-1+1", lighting="daytime")["id"]
    second = add_vehicle(operator, ground.recording_id, notes="line one\nline two, with comma")["id"]
    tyres = {"frame": 2, "first": pixel(-1.0, 0.0, 0.0), "second": pixel(1.0, 0.0, 0.0)}
    operator.made(f"/vehicles/{first}/wheel-pair", tyres)
    roof = measure(operator, first, inset_m=0.1234567, u_inset_m=0.1)
    eye = measure(operator, first, target="driver_eye", contact=[140.123456789, 185.987654321])
    rejected = measure(operator, first, target="taillight")
    measure(reviewer, first, frame=4, repeat_of=roof["id"], inset_m=None, u_inset_m=None)
    gone = measure(operator, second)
    measure(operator, second, target="other", contact=[160.0, 3.0])
    operator.put(f"/measurements/{roof['id']}", {**clicks(1.31), "revision": 1})
    review = f"/measurements/{eye['id']}/reviews"
    reviewer.made(
        review,
        {
            "revision": 1,
            "verdict": "fixed",
            "contact": eye["contact"],
            "point": eye["point"],
            "reason": "@home",
        },
    )
    reviewer.made(
        f"/measurements/{rejected['id']}/reviews",
        {"revision": 1, "verdict": "rejected", "reason": "Kerb."},
    )
    operator.delete(f"/measurements/{gone['id']}?revision=1")
    return ground


def written(services: Services, survey_id: int, place: Path) -> Path:
    with services.reading() as session:
        package = exporting.package_of(exporting.state_of(session, survey_id))
    write_directory(package, place)
    return place


def test_room_is_looked_at_before_an_export(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("backend.media.store.shutil.disk_usage", lambda _: SimpleNamespace(free=10))
    with pytest.raises(NoRoom, match="no room for this export"):
        write_directory(with_checksums({"a.csv": b"1"}), tmp_path / "package")
    assert list(tmp_path.iterdir()) == []


def rows(place: Path, name: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO((place / name).read_text("utf-8"), newline="")))


def test_the_button_makes_a_package_that_holds_everything(
    operator: Client, viewer: Client, worked: Ground, work: Callable[[], list[Job]], tmp_path: Path
) -> None:
    job = viewer.made(f"/surveys/{worked.survey_id}/exports")
    assert [one.state for one in work()] == ["done"]
    made = viewer.seen(f"/surveys/{worked.survey_id}/exports")
    assert [one["id"] for one in made] == [viewer.seen(f"/jobs/{job['id']}")["result"]["export_id"]]
    answer = viewer.http.get(made[0]["url"])
    assert (
        answer.headers["content-type"] == "application/zip" and len(answer.content) == made[0]["size_bytes"]
    )
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        archive.extractall(tmp_path / "export")
    assert len(rows(tmp_path / "export", "measurements.csv")) == 5
    assert len(rows(tmp_path / "export", "revisions.csv")) == 8
    again = rows(tmp_path / "export", "repeats.csv")
    assert [(row["target"], row["frame"], row["withdrawn"]) for row in again] == [("roof", "4", "false")]
    assert {row["verdict"] for row in rows(tmp_path / "export", "reviews.csv")} == {"fixed", "rejected"}
    assert set(rows(tmp_path / "export", "people.csv")[0]) == {"id", "name"}
    assert [row["frame"] for row in rows(tmp_path / "export", "wheel_pairs.csv")] == ["2"]
    everything = b"".join(path.read_bytes() for path in (tmp_path / "export").rglob("*") if path.is_file())
    assert b'example.org"' not in everything.replace(b"http://example.org", b"")
    assert b"operator@example.org" not in everything
    found = verify_package(read_package(tmp_path / "export"))
    assert (found.ok, found.heights) == (True, 4), found.problem


def test_frictionless_finds_nothing_to_complain_about(
    services: Services, worked: Ground, tmp_path: Path
) -> None:
    place = written(services, worked.survey_id, tmp_path / "export")
    report = Frictionless(str(place / "datapackage.json")).validate()
    assert report.valid, report.flatten(["title", "fieldName", "rowNumber", "note", "message"])
    described = json.loads((place / "datapackage.json").read_text())
    for resource in described["resources"]:
        with (place / resource["path"]).open(encoding="utf-8", newline="") as file:
            header = next(csv.reader(file))
        fields = resource["schema"]["fields"]
        assert header == [field["name"] for field in fields]
        assert all(field["description"] for field in fields)
        for field in fields:
            if field["name"].endswith(("_m", "_px", "_s", "_rad")):
                assert field["unit"] == field["name"].rpartition("_")[2], field


def test_the_same_state_gives_the_same_bytes(services: Services, worked: Ground, tmp_path: Path) -> None:
    once = read_package(written(services, worked.survey_id, tmp_path / "once"))
    again = read_package(written(services, worked.survey_id, tmp_path / "again"))
    assert once == again
    # an earlier export is replaced, anybody else's folder is not
    written(services, worked.survey_id, tmp_path / "once")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear all")
    with pytest.raises(Exception, match="holds other files"):
        written(services, worked.survey_id, tmp_path / "mine")
    assert sorted(path.name for path in tmp_path.glob(".*")) == []


def test_clicks_and_pose_give_the_same_heights_on_the_command_line(
    services: Services, worked: Ground, tmp_path: Path
) -> None:
    place = written(services, worked.survey_id, tmp_path / "export")
    stored = {f"m{row['id']}": row for row in rows(place, "measurements.csv")}
    compared = 0
    for pose in sorted((place / "clicks").glob("pose-*.csv")):
        out = tmp_path / pose.name
        document = str(place / "poses" / f"{pose.stem}.json")
        assert main(["height", "--pose", document, "--clicks", str(pose), "-o", str(out)]) == 0
        for row in csv.DictReader(out.open(encoding="utf-8", newline="")):
            for name in ("height_m", "u_height_m", "U95_height_m", "status", "reason"):
                assert row[name] == stored[row["id"]][name], (row["id"], name)
            compared += 1
    assert compared == 4


def test_nothing_in_a_cell_runs(services: Services, worked: Ground, tmp_path: Path) -> None:
    place = written(services, worked.survey_id, tmp_path / "export")
    vehicle = rows(place, "vehicles.csv")[0]
    assert (vehicle["make"], vehicle["model"]) == ("'" + FORMULA, "'-1+1")
    assert rows(place, "vehicles.csv")[1]["notes"] == "line one\nline two, with comma"
    assert "'@home" in {row["reason"] for row in rows(place, "reviews.csv")}
    for path in place.rglob("*.csv"):
        for row in csv.reader(path.open(encoding="utf-8", newline="")):
            for cell in row:
                if cell[:1] in ("=", "+", "-", "@"):
                    float(cell)


def change(place: Path, name: str, before: str, after: str, *, resum: bool = True) -> None:
    """Change a file of an export as somebody with a text editor, and (by default) sha256sum, would."""
    path = place / name
    text = path.read_text("utf-8")
    assert before in text
    path.write_text(text.replace(before, after, 1), "utf-8")
    if resum:
        from backend.work.packaging import CHECKSUMS, sha256_hex

        lines = (place / CHECKSUMS).read_text().splitlines()
        renewed = [
            line if line[66:] != name else f"{sha256_hex(path.read_bytes())}  {name}" for line in lines
        ]
        (place / CHECKSUMS).write_text("".join(f"{line}\n" for line in renewed))


@pytest.mark.parametrize(
    ("name", "before", "after", "resum", "said"),
    [
        ("measurements.csv", "1.310000", "1.210000", False, "changed after"),
        ("measurements.csv", "1.310000", "1.210000", True, "its clicks give 1.310000"),
        ("clicks.csv", "140.123456789", "141.123456789", True, "another contact_x_px"),
        ("measurements.csv", "140.123456789", "141.123456789", True, "another contact_x_px"),
        ("audit.csv", "revise", "create", True, "not the one that was hashed"),
        ("poses/pose-1.json", "translation_m", "translation_n", True, "no road pose"),
    ],
)
def test_what_is_changed_afterwards_is_found(
    services: Services,
    worked: Ground,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    name: str,
    before: str,
    after: str,
    resum: bool,
    said: str,
) -> None:
    place = written(services, worked.survey_id, tmp_path / "export")
    assert main(["verify", str(place)]) == 0
    if name.startswith("poses"):
        name = next(place.glob("poses/*.json")).relative_to(place).as_posix()
    change(place, name, before, after, resum=resum)
    capsys.readouterr()
    assert main(["verify", str(place), "--json"]) == 1
    printed = capsys.readouterr()
    assert json.loads(printed.out)["ok"] is False and said in json.loads(printed.out)["problem"]
    assert said in printed.err and "\n" not in printed.err.strip()


def test_a_row_or_file_that_is_taken_out_is_missed(
    services: Services, worked: Ground, tmp_path: Path
) -> None:
    place = written(services, worked.survey_id, tmp_path / "export")
    files: dict[str, Any] = dict(read_package(place))
    del files["reviews.csv"]
    assert "reviews.csv is missing" in str(verify_package(files).problem)
    lines = (place / "audit.csv").read_text("utf-8").splitlines()
    change(place, "audit.csv", lines[3] + "\n", "")
    assert "does not follow" in str(verify_package(read_package(place)).problem)


@pytest.fixture
def followed(operator: Client, worked: Ground, services: Services, tmp_path: Path) -> Path:
    """An export in which an event of another survey, withheld, stands between two of this one."""
    operator.made("/surveys", {"name": "Other"})
    add_vehicle(operator, worked.recording_id)
    return written(services, worked.survey_id, tmp_path / "export")


def rewrite(place: Path, events: list[dict[str, str]]) -> None:
    """Write audit.csv anew and sum it."""
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, list(events[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(events)
    change(place, "audit.csv", (place / "audit.csv").read_text("utf-8"), text.getvalue())


def before_withheld(events: list[dict[str, str]]) -> int:
    """Where an event of this survey is followed by a withheld one."""
    held = [event["withheld"] for event in events]
    return next(n for n in range(len(held) - 2, -1, -1) if held[n : n + 2] == ["false", "true"])


def test_an_event_forged_with_the_link_of_the_withheld_one_after_it_is_found(followed: Path) -> None:
    events = rows(followed, "audit.csv")
    at = before_withheld(events)
    assert events[at]["entity"] == "measurement" and len(events) > at + 2
    rewrite(followed, events)
    assert verify_package(read_package(followed)).ok  # writing it anew alone changes nothing
    events[at]["actor_id"] = str(int(events[at]["actor_id"]) + 1)
    events[at]["content_sha256"] = event_hash(_hashed(events[at]))
    events[at]["hash"] = link_hash(events[at]["previous_hash"], events[at]["content_sha256"])
    events[at + 1]["previous_hash"] = events[at]["hash"]
    rewrite(followed, events)
    problem = str(verify_package(read_package(followed)).problem)
    assert f"event {events[at + 1]['id']} is not the one that was hashed" in problem


def test_a_forger_who_hashes_the_withheld_one_anew_breaks_the_next_link(followed: Path) -> None:
    events = rows(followed, "audit.csv")
    at = before_withheld(events) + 1
    events[at]["content_sha256"] = "0" * 64
    events[at]["hash"] = link_hash(events[at]["previous_hash"], events[at]["content_sha256"])
    rewrite(followed, events)
    assert "does not follow" in str(verify_package(read_package(followed)).problem)


def test_an_event_that_is_withheld_tells_nothing(followed: Path) -> None:
    """Else a forged measurement would be vouched for by an event whose content nobody checks."""
    events = rows(followed, "audit.csv")
    at = before_withheld(events)
    events[at]["withheld"] = "true"
    rewrite(followed, events)
    problem = str(verify_package(read_package(followed)).problem)
    assert f"event {events[at]['id']} is not the one that was hashed" in problem


@pytest.mark.parametrize("column", ["content_sha256", "previous_hash"])
def test_a_column_that_is_missing_is_told_in_one_sentence(followed: Path, column: str) -> None:
    events = rows(followed, "audit.csv")
    for event in events:
        del event[column]
    rewrite(followed, events)
    check = verify_package(read_package(followed))
    assert not check.ok and column in str(check.problem) and "\n" not in str(check.problem)
