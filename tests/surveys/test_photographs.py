"""Photographs of the set-up: taken in as plain JPEGs, in order, with undo; in the package, vouched for."""

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from sqlalchemy.exc import ProgrammingError

from sightline.errors import NoRoom
from sightline.export.verify.package import verify_package
from sightline.infra import stored_bytes
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.csv_package.schema import sha256_hex
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.surveys.photographs import service
from tests.support.app import Client, error_of
from tests.support.packages import drop, edit, ground, package, photograph, reseal, rows, worked, written

__all__ = ["ground", "package", "worked"]

pytestmark = pytest.mark.once
Work = Callable[[], list[Job]]
_ORIENTATION, _GPS, _LATITUDE = 0x0112, 0x8825, 2


def told_bytes(width: int = 80, height: int = 40, form: str = "JPEG") -> bytes:
    """A picture that a camera lying on its side took, with the place in its metadata."""
    exif = Image.Exif()
    exif[_ORIENTATION] = 6
    exif.get_ifd(_GPS)[_LATITUDE] = (59.0, 19.0, 46.0)
    out = io.BytesIO()
    Image.new("RGB", (width, height), (200, 30, 30)).save(out, form, exif=exif)
    return out.getvalue()


def listed(client: Client, survey_id: int) -> list[Any]:
    found: list[Any] = client.seen(f"/surveys/{survey_id}/photographs")
    return found


def test_what_is_kept_is_small_upright_and_tells_no_place(
    operator: Client, viewer: Client, survey_id: int
) -> None:
    assert b"Exif" in told_bytes()
    made = photograph(operator, survey_id, told_bytes(3200, 1000), "rig.jpg", " The   rig ")
    assert (made["width_px"], made["height_px"]) == (500, 1600)
    assert (made["caption"], made["name"], made["version"]) == ("The rig", "rig.jpg", 1)
    content = viewer.http.get(made["url"]).content
    assert sha256_hex(content) == made["sha256"] and len(content) == made["size_bytes"]
    shown = Image.open(io.BytesIO(content))
    assert shown.size == (500, 1600) and not dict(shown.getexif()) and b"Exif" not in content
    event = operator.seen(f"/audit?survey_id={survey_id}")[0]
    assert (event["entity"], event["action"]) == ("photograph", "create")


@pytest.mark.parametrize("form", ["PNG", "WEBP", "TIFF"])
def test_other_formats_become_the_same_kind(operator: Client, survey_id: int, form: str) -> None:
    made = photograph(operator, survey_id, told_bytes(form=form), f"rig.{form.lower()}")
    assert operator.http.get(made["url"]).content[:3] == b"\xff\xd8\xff"


@pytest.mark.parametrize(
    ("content", "said"),
    [(b"", "empty"), (b"%PDF-1.7", "not an image"), (told_bytes()[:200], "damaged")],
    ids=["empty", "no image", "cut off"],
)
def test_what_is_no_picture_is_refused_by_name(
    operator: Client, survey_id: int, content: bytes, said: str
) -> None:
    path = f"/surveys/{survey_id}/photographs"
    answer = operator.post(path, files={"file": ("rig.jpg", content)})
    assert answer.status_code == 422 and "rig.jpg" in error_of(answer) and said in error_of(answer)
    assert listed(operator, survey_id) == []


def test_caption_order_and_undo(operator: Client, survey_id: int) -> None:
    one, two = (photograph(operator, survey_id, told_bytes(), f"{n}.jpg") for n in "ab")
    words = operator.put(f"/photographs/{one['id']}", {"caption": "Mast", "version": 1}).json()
    assert (words["caption"], words["version"]) == ("Mast", 2)
    late = operator.put(f"/photographs/{one['id']}", {"caption": "Pole", "version": 1})
    assert late.status_code == 409 and "Operator changed this photograph" in error_of(late)
    order = f"/surveys/{survey_id}/photographs/order"
    turned = operator.put(order, {"ids": [two["id"], one["id"]]}).json()
    assert [entry["id"] for entry in turned] == [two["id"], one["id"]]
    short = operator.put(order, {"ids": [two["id"]]})
    assert short.status_code == 409 and "added or removed" in error_of(short)
    assert operator.delete(f"/photographs/{two['id']}?version=1").status_code == 204
    assert [entry["id"] for entry in listed(operator, survey_id)] == [one["id"]]
    assert operator.get(f"/photographs/{two['id']}.jpg").status_code == 404
    operator.made(f"/photographs/{two['id']}/restore")
    assert [entry["id"] for entry in listed(operator, survey_id)] == [two["id"], one["id"]]


def test_the_package_holds_them_twice_alike(
    operator: Client, services: Services, survey_id: int, tmp_path: Path
) -> None:
    gone, one, two = (photograph(operator, survey_id, told_bytes(), f"{n}.jpg", n) for n in "xab")
    operator.delete(f"/photographs/{gone['id']}?version=1")
    operator.put(f"/surveys/{survey_id}/photographs/order", {"ids": [two["id"], one["id"]]})
    places = [written(services, survey_id, tmp_path / name) for name in ("first", "second")]
    assert [row["caption"] for row in rows(places[0], "photographs.csv")] == ["b", "a"]
    found = verify_package(FolderFiles(places[0]))
    assert found.ok, found.problem
    sums = [(place / "SHA256SUMS").read_text().splitlines() for place in places]
    alike = set(sums[0]) & set(sums[1])
    # each has a seal and a signature of its own, and both again for the page
    assert len(alike) == len(sums[0]) - 3 and any("photographs/photograph-" in line for line in alike)


def test_a_file_that_is_gone_is_named(
    operator: Client, services: Services, survey_id: int, tmp_path: Path
) -> None:
    made = photograph(operator, survey_id, told_bytes(), "rig.jpg")
    for path in services.settings.data_dir.rglob("*-setup.jpg"):
        path.unlink()
    answer = operator.get(made["url"].removeprefix("/api"))
    assert answer.status_code >= 400 and "“rig.jpg” is missing" in error_of(answer)


def test_what_a_request_met_is_said_where_its_file_cannot_be_let_go_either(
    operator: Client, survey_id: int, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def full(*_given: object, **_more: object) -> None:
        raise NoRoom("database-disk-full")

    def broken(*_given: object) -> None:
        raise ProgrammingError("INSERT INTO jobs", {}, Exception("no such table: jobs"))

    monkeypatch.setattr(service, "add_photograph", full)
    monkeypatch.setattr(stored_bytes, "let_go", broken)
    refused = operator.post(f"/surveys/{survey_id}/photographs", files={"file": ("rig.jpg", told_bytes())})
    assert (refused.status_code, refused.json()["error"]["code"]) == (507, "database-disk-full")
    assert "stays in the media store" in caplog.text and "no such table: jobs" in caplog.text


def test_a_photograph_that_is_not_noted_leaves_no_file_and_may_be_sent_again(
    operator: Client, services: Services, survey_id: int, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_given: object, **_more: object) -> None:
        raise NoRoom("database-disk-full")

    path, file = f"/surveys/{survey_id}/photographs", {"file": ("rig.jpg", told_bytes())}
    key = {"Idempotency-Key": "once"}
    with monkeypatch.context() as filled:
        filled.setattr(service, "add_photograph", full)
        refused = operator.post(path, files=file, headers=key)
    assert (refused.status_code, refused.json()["error"]["code"]) == (507, "database-disk-full")
    assert len(list(services.media.listing())) == 1
    assert [(job.kind, job.state) for job in work()] == [("tidy", "done")]
    assert not list(services.media.listing())
    assert operator.post(path, files=file, headers=key).status_code == 201
    with monkeypatch.context() as filled:
        filled.setattr(service, "add_photograph", full)
        assert operator.post(path, files=file).status_code == 507
    assert [(job.kind, job.state) for job in work()] == [("tidy", "done")]
    assert len(list(services.media.listing())) == 1  # the one before has the same content


def exchanged(place: Path) -> str:
    """Another picture, with every sum made to fit, in the table too."""
    row = rows(place, "photographs.csv")[0]
    content = told_bytes(30, 60)
    (place / row["file"]).write_bytes(content)
    cells = {"sha256": sha256_hex(content), "size_bytes": str(len(content))}
    edit(place, "photographs.csv", lambda one: one["id"] == row["id"], **cells)
    reseal(place)
    return "differs from its audit events"


def exchanged_alone(place: Path) -> str:
    row = rows(place, "photographs.csv")[0]
    (place / row["file"]).write_bytes(told_bytes(30, 60))
    reseal(place)
    return f"{row['file']} is not the photograph named by its audit event"


def a_caption(place: Path) -> str:
    edit(place, "photographs.csv", lambda row: row["position"] == "1", caption="Another road")
    reseal(place)
    return "photographs.csv: caption of row"


def taken_out(place: Path) -> str:
    drop(place, "photographs.csv", lambda row: row["position"] == "2")
    reseal(place)
    return "photographs.csv: row 2 is missing, although it has an audit event"


@pytest.mark.parametrize("forge", [exchanged, exchanged_alone, a_caption, taken_out])
def test_what_is_forged_is_found(package: Path, forge: Any) -> None:
    said = forge(package)
    found = verify_package(FolderFiles(package))
    assert not found.ok and said in str(found.problem), found.problem
