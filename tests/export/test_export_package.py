"""The export: valid Frictionless data, same state same bytes, heights compute again, nothing that runs."""

import csv
import io
import json
import xml.etree.ElementTree as ElementTree
import zipfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import cv2
import pyarrow.parquet as pq
import pytest

from sightline.cli import main
from sightline.errors import NoRoom, SightlineError, Stopped
from sightline.export.verify.package import verify_package
from sightline.infra.audit.anchors import Anchors
from sightline.infra.csv_package.files import FolderFiles, Staging
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import get_job
from sightline.infra.services import Services
from sightline.media.store.local import LocalStore
from sightline.media.store.s3 import StorageAway
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_recording
from tests.export.report.pdf_text import words
from tests.support.app import Client
from tests.support.ground import Ground, measure
from tests.support.packages import FORMULA, ground, package, rows, worked, written

__all__ = ["ground", "package", "worked"]


def test_room_is_looked_at_before_an_export(
    services: Services, survey_id: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sightline.media.store.local.shutil.disk_usage", lambda _: SimpleNamespace(free=10))
    (tmp_path / "out").mkdir()
    with pytest.raises(NoRoom, match="not enough space"):
        written(services, survey_id, tmp_path / "out" / "package")
    assert list((tmp_path / "out").iterdir()) == []


def test_the_button_makes_a_package_that_holds_everything_and_the_same_state_the_same_bytes(
    viewer: Client,
    operator: Client,
    worked: Ground,
    work: Callable[[], list[Job]],
    services: Services,
    tmp_path: Path,
) -> None:
    job = viewer.made(f"/surveys/{worked.survey_id}/exports")
    assert [one.state for one in work()] == ["done"]
    made = viewer.seen(f"/surveys/{worked.survey_id}/exports")
    result = viewer.seen(f"/jobs/{job['id']}")["result"]
    assert result == {"export_id": made[0]["id"], "measurements": 5, "vehicles": 2, "crops": 4}
    answer = viewer.http.get(made[0]["url"])
    assert answer.headers["content-type"] == "application/zip"
    assert made[0]["filename"] == f"sightline-test-road-{made[0]['id']}.zip"
    assert made[0]["filename"] in answer.headers["content-disposition"]
    assert len(answer.content) == made[0]["size_bytes"]
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        archive.extractall(tmp_path / "export")
    assert len(rows(tmp_path / "export", "measurements.csv")) == 5
    assert len(rows(tmp_path / "export", "revisions.csv")) == 8
    again = rows(tmp_path / "export", "repeats.csv")
    assert [(row["target"], row["frame"], row["withdrawn"]) for row in again] == [("roof", "4", "false")]
    verdicts = {row["verdict"] for row in rows(tmp_path / "export", "reviews.csv")}
    assert verdicts == {"fixed", "rejected", "accepted"}
    assert set(rows(tmp_path / "export", "people.csv")[0]) == {"id", "name"}
    assert [row["frame"] for row in rows(tmp_path / "export", "wheel_pairs.csv")] == ["2"]
    everything = b"".join(path.read_bytes() for path in (tmp_path / "export").rglob("*") if path.is_file())
    assert b"operator@example.org" not in everything
    found = verify_package(FolderFiles(tmp_path / "export"), Anchors(heads=[made[0]["audit_head"]]))
    assert (found.ok, found.heights, found.crops) == (True, 9, 4), found.problem
    assert list(services.scratch.iterdir()) == []
    # the same state, which the export itself has moved on by its own events, gives the same bytes
    (once, twice) = (_bytes(written(services, worked.survey_id, tmp_path / name)) for name in ("a", "b"))
    # but for the chain, which has a seal more, and its sum
    assert {name for name in once if once[name] != twice.get(name)} == {
        "audit.csv",
        "audit.js",
        "checkpoint.json",
        "SHA256SUMS",
    }
    assert once.keys() == twice.keys()
    # it holds all there is until a height is added, and says how many it lacks then
    assert made[0]["since"] == {"heights": 0, "reviews": 0, "other": 0}
    first = int(rows(tmp_path / "export", "vehicles.csv")[0]["id"])
    measure(operator, first, target="headlight")
    lacks = {"heights": 1, "reviews": 0, "other": 0}
    assert viewer.seen(f"/surveys/{worked.survey_id}/exports")[0]["since"] == lacks
    survey = viewer.seen(f"/surveys/{worked.survey_id}")
    assert survey["since_package"] == lacks and survey["steps"][-1]["state"] != "done"


def test_an_export_that_is_cancelled_leaves_nothing(
    viewer: Client,
    survey_id: int,
    work: Callable[[], list[Job]],
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def stopped(staging: Staging, *_rest: object, **_options: object) -> None:
        staging.add("tables/measurements.csv", b"half")
        raise Stopped("said", sentence="Cancelled.")

    monkeypatch.setattr("sightline.export.build.build", stopped)
    viewer.made(f"/surveys/{survey_id}/exports")
    assert [one.state for one in work()] == ["cancelled"]
    assert viewer.seen(f"/surveys/{survey_id}/exports") == []
    assert list(services.scratch.iterdir()) == []


def _bytes(place: Path) -> dict[str, bytes]:
    return {str(path.relative_to(place)): path.read_bytes() for path in place.rglob("*") if path.is_file()}


def test_the_report_says_which_measurements_the_survey_page_leaves_out(
    operator: Client, worked: Ground, services: Services, tmp_path: Path
) -> None:
    """The report counts all that its tables hold, the page those that stand."""
    told = rows(written(services, worked.survey_id, tmp_path / "package"), "measurements.csv")
    standing = [row for row in told if row["withdrawn"] == "false"]
    counts = operator.seen(f"/surveys/{worked.survey_id}")["counts"]
    assert counts["measurements"] == len(standing) < len(told)
    report = " ".join(words((tmp_path / "package" / "report.pdf").read_bytes()).split())
    assert "withdrawn ones included" in report and "discarded ones included" in report


def test_frictionless_finds_nothing_to_complain_about(package: Path) -> None:
    from frictionless import Package as Frictionless

    report = Frictionless(str(package / "datapackage.json")).validate()
    assert report.valid, report.flatten(["title", "fieldName", "rowNumber", "note", "message"])
    described = json.loads((package / "datapackage.json").read_text())
    tables = [one for one in described["resources"] if "schema" in one]
    for resource in tables:
        with (package / resource["path"]).open(encoding="utf-8", newline="") as file:
            header = next(csv.reader(file))
        fields = resource["schema"]["fields"]
        assert header == [field["name"] for field in fields]
        assert all(field["description"] for field in fields)
        for field in fields:
            if field["name"].endswith(("_m", "_px", "_s", "_rad")):
                assert field["unit"] == field["name"].rpartition("_")[2], field
    named = {one["path"] for one in described["resources"]}
    there = {str(path.relative_to(package)) for path in package.rglob("*") if path.is_file()}
    assert {path for path in there - named if not path.startswith("crops/")} == {
        "SHA256SUMS",
        "datapackage.json",
        "audit.js",
        "checkpoint.json",
    }


@pytest.mark.once
def test_pandas_reads_every_table_as_it_is_described(package: Path) -> None:
    import pandas

    described = json.loads((package / "datapackage.json").read_text())
    kinds = {"integer": "iuf", "number": "iuf", "boolean": "bO", "string": "OSU", "datetime": "OSU"}
    for resource in described["resources"]:
        if "schema" not in resource:
            continue
        table = pandas.read_csv(package / resource["path"])
        for field in resource["schema"]["fields"]:
            column = table[field["name"]].dropna()
            assert column.empty or column.dtype.kind in kinds[field["type"]], field


@pytest.mark.once
def test_every_table_stands_as_parquet_too_typed_and_with_its_units(package: Path) -> None:
    described = json.loads((package / "datapackage.json").read_text())
    tables = [one for one in described["resources"] if "schema" in one and one["path"] != "audit.csv"]
    assert {f"parquet/{one['path'].removeprefix('tables/')[:-4]}.parquet" for one in tables} == {
        str(path.relative_to(package)) for path in package.rglob("*.parquet")
    }
    found = pq.read_table(package / "parquet" / "measurements.parquet")
    height = found.schema.field("height_m")
    assert str(height.type) == "double" and height.metadata[b"unit"] == b"m"
    assert b"height of the target above the road" in height.metadata[b"description"]
    assert str(found.schema.field("created_at").type) == "timestamp[us, tz=UTC]"
    told = [float(row["height_m"]) if row["height_m"] else None for row in rows(package, "measurements.csv")]
    assert found["height_m"].to_pylist() == told and None in told


@pytest.mark.once
def test_a_crop_shows_the_frame_and_its_points(package: Path) -> None:
    measured = {row["id"]: row for row in rows(package, "measurements.csv")}
    found = rows(package, "crops.csv")
    assert [row["measurement_id"] for row in found] == sorted(
        row["id"] for row in measured.values() if row["withdrawn"] == "false"
    )
    for row in found:
        picture = cv2.imread(str(package / row["file"]))
        assert picture.shape[:2] == (int(row["height_px"]), int(row["width_px"]))
        one = measured[row["measurement_id"]]
        for word in ("contact", "target"):
            inside = [float(row[f"{word}_{axis}_px"]) + float(row[f"{axis}_px"]) for axis in "xy"]
            assert inside == pytest.approx([float(one[f"{word}_{axis}_px"]) for axis in "xy"])
        drawn = ElementTree.parse(package / row["overlay"]).getroot()
        (image,) = drawn.iter("{http://www.w3.org/2000/svg}image")
        assert image.get("href") == Path(row["file"]).name
        assert (drawn.get("width"), drawn.get("height")) == (row["width_px"], row["height_px"])


@pytest.mark.once
def test_what_does_not_count_is_listed_with_its_reason(package: Path) -> None:
    found = {row["measurement_id"]: (row["state"], row["reason"]) for row in rows(package, "exclusions.csv")}
    by_id = {row["id"]: row for row in rows(package, "measurements.csv")}
    counted = [id_ for id_ in by_id if id_ not in found]
    assert [by_id[id_]["verdict"] for id_ in counted] == ["accepted", "fixed"]
    assert sorted(found.values()) == sorted(
        [
            ("rejected", "Kerb."),
            ("withdrawn", "The measurement was withdrawn."),
            ("not_measurable", next(row["reason"] for row in by_id.values() if row["status"] != "ok")),
        ]
    )
    errors = {
        (row["heights"], row["rounding"], row["group"], row["figure"]): row
        for row in rows(package, "statistics/error_table.csv")
    }
    bias = errors["inset", "none", "daytime", "bias_m"]
    assert (bias["n"], float(bias["value"])) == ("1", pytest.approx(0.01, abs=1e-6))


@pytest.mark.once
def test_clicks_and_pose_give_the_same_heights_on_the_command_line(package: Path, tmp_path: Path) -> None:
    stored = {f"m{row['id']}": row for row in rows(package, "measurements.csv")}
    compared = 0
    for pose in sorted((package / "clicks").glob("pose-*.csv")):
        out = tmp_path / pose.name
        document = str(package / "poses" / f"{pose.stem}.json")
        assert main(["height", "--pose", document, "--clicks", str(pose), "-o", str(out)]) == 0
        for row in csv.DictReader(out.read_text(encoding="utf-8").splitlines()):
            for name in ("height_m", "u_height_m", "U95_height_m", "status", "reason"):
                assert row[name] == stored[row["id"]][name], (row["id"], name)
            compared += 1
    assert compared == 4


@pytest.mark.once
def test_nothing_in_a_cell_runs(package: Path) -> None:
    vehicle = rows(package, "vehicles.csv")[0]
    assert (vehicle["make"], vehicle["model"]) == ("'" + FORMULA, "'-1+1")
    assert rows(package, "vehicles.csv")[1]["notes"] == "line one\nline two, with comma"
    assert "'@home" in {row["reason"] for row in rows(package, "reviews.csv")}
    for path in package.rglob("*.csv"):
        for row in csv.reader(path.read_text(encoding="utf-8").splitlines()):
            for cell in row:
                if cell[:1] in ("=", "+", "-", "@"):
                    float(cell)


@pytest.mark.parametrize(
    "trouble", [StorageAway("store-no-answer", key="k", name="Timeout"), NoRoom("database-disk-full")]
)
def test_storage_that_does_not_answer_stops_an_export(
    trouble: SightlineError,
    worked: Ground,
    services: Services,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with services.reading() as session:
        film = get_recording(session, worked.recording_id).media_key
    local_path = LocalStore.local_path

    def away(store: LocalStore, key: str) -> Path:
        if key == film:
            raise trouble
        return local_path(store, key)

    stills_of(services).forget(worked.recording_id)
    monkeypatch.setattr(LocalStore, "local_path", away)
    with pytest.raises(type(trouble)):
        written(services, worked.survey_id, tmp_path / "export")
    assert list(tmp_path.glob("*export*")) == []


def test_a_video_that_is_gone_gives_reasons_in_the_place_of_crops(
    viewer: Client, worked: Ground, services: Services, tmp_path: Path
) -> None:
    with services.reading() as session:
        services.media.delete(get_recording(session, worked.recording_id).media_key)
    stills_of(services).forget(worked.recording_id)
    place = written(services, worked.survey_id, tmp_path / "export")
    found = rows(place, "crops.csv")
    assert [row["file"] for row in found] == [""] * 4
    assert all("missing from the store" in row["reason"] for row in found)
    assert verify_package(FolderFiles(place)).ok
    job = viewer.made(f"/surveys/{worked.survey_id}/exports", {"crops": False})
    with services.reading() as session:
        payload = get_job(session, job["id"]).payload
    assert (payload["survey_id"], payload["crops"]) == (worked.survey_id, False)
