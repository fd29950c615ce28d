"""A package whose figures and report are in the language of who asked for it; its tables are in none."""

import io
import json
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.export import page
from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.columns import code_in, words_of
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure
from tests.support.packages import reseal, rows


@pytest.fixture
def ground(
    services: Services, survey_id: int, recording_id: int, operator: Client, reviewer: Client
) -> Ground:
    """A survey with one accepted height, and one that waits for its review."""
    laid = lay_ground(services, survey_id, recording_id)
    car = add_vehicle(operator, laid.recording_id, category="saloon", manufacturer_height_m=1.31)["id"]
    made = measure(operator, car)
    reviewer.made(f"/measurements/{made['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    measure(operator, add_vehicle(operator, laid.recording_id, category="saloon")["id"])
    return laid


def fetched(viewer: Client, ground: Ground, work: Callable[[], list[Job]], place: Path) -> Path:
    """The newest package, unpacked."""
    assert [one.state for one in work()] == ["done"]
    made = viewer.seen(f"/surveys/{ground.survey_id}/exports")[0]
    with zipfile.ZipFile(io.BytesIO(viewer.http.get(made["url"]).content)) as archive:
        archive.extractall(place)
    assert made["language"] == described(place)["language"]
    return place


def described(place: Path) -> dict[str, object]:
    found: dict[str, object] = json.loads((place / "datapackage.json").read_text("utf-8"))
    return found


def told_by_page(place: Path) -> dict[str, Any]:
    """What the package's own page is told of the package."""
    about = re.search(r'id="about">(.*?)</script>', (place / "index.html").read_text("utf-8"))
    assert about
    found: dict[str, Any] = json.loads(about[1])
    return found


@pytest.mark.skipif(page.template() is None, reason="the front end is not built")
def test_figures_report_and_page_are_in_the_language_of_who_asked(
    viewer: Client, ground: Ground, work: Callable[[], list[Job]], tmp_path: Path
) -> None:
    address = f"/api/surveys/{ground.survey_id}/exports"
    asked = viewer.http.post(address, headers={"Accept-Language": "fr-FR, en;q=0.5"})
    assert asked.status_code == 202
    french = fetched(viewer, ground, work, tmp_path / "fr")
    viewer.made(f"/surveys/{ground.survey_id}/exports", {"language": "en"})
    english = fetched(viewer, ground, work, tmp_path / "en")
    for place, kind in ((french, "RAPPORTDEMESURE"), (english, "MEASUREMENTREPORT")):
        assert kind in "".join(words((place / "report.pdf").read_bytes()).split())
        checked = verify_package(FolderFiles(place))
        assert checked.ok and checked.drawings > 1, checked.problem
    assert (told_by_page(french)["language"], told_by_page(english)["language"]) == ("fr", "en")
    in_french = told_by_page(french)["said"]["fr"]
    assert in_french["click, target"] == "Pointé de la cible"
    assert told_by_page(french)["said"]["en"]["click, target"] == "Click on the target"
    assert in_french["It has not been reviewed yet."] == "Elle n’est pas encore vérifiée."
    assert told_by_page(english)["said"] == told_by_page(french)["said"]
    same = {path.name: path.read_bytes() for path in english.glob("statistics/*.csv")}
    assert same and same == {path.name: path.read_bytes() for path in french.glob("statistics/*.csv")}
    assert described(french)["description"] == described(english)["description"]
    for row in rows(french, "statistics/error_table.csv"):
        assert (row["reason"] != "") == (row["reason_code"] != "")
    told = {row["reason"]: code_in(row["reason_code"]) for row in rows(french, "statistics/percentiles.csv")}
    told.pop("", None)
    assert told and all(in_french[words] == words_of(code, "fr") != words for words, code in told.items())


@pytest.mark.parametrize("language", ["en", "xx"])
def test_another_language_than_the_report_is_found(
    viewer: Client, ground: Ground, work: Callable[[], list[Job]], tmp_path: Path, language: str
) -> None:
    viewer.made(f"/surveys/{ground.survey_id}/exports", {"language": "fr"})
    place = fetched(viewer, ground, work, tmp_path / "fr")
    path = place / "datapackage.json"
    path.write_text(path.read_text("utf-8").replace('"language": "fr"', f'"language": "{language}"'), "utf-8")
    reseal(place, page=True)
    assert not verify_package(FolderFiles(place)).ok


def test_a_language_that_there_is_not_is_refused(
    viewer: Client, ground: Ground, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    answer = viewer.post(f"/surveys/{ground.survey_id}/exports", {"language": "xx"})
    assert answer.status_code == 422
    assert "no report in the language “xx”. Choose one of en, fr" in error_of(answer)
    out = ["export", "--survey", "1", "-o", str(tmp_path / "out"), "--language", "xx"]
    assert main(out) == 2
    assert "Choose one of en, fr" in capsys.readouterr().err
