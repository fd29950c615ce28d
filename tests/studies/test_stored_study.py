"""A study of this installation's surveys: by the API, audited, with the command's own figures."""

import csv
import io
import json
import zipfile
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.demo import invented
from sightline.demo.request import STUDY_KIND
from sightline.infra.audit import trail
from sightline.infra.audit.verification import verify_records
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.results.usual_standards import STANDARDS
from sightline.studies.document import consequence_in
from tests.export.report.pdf_text import pages
from tests.support.app import Client, error_of

FLEET_CSV = "category,share\nhatchback,0.4\nsaloon,0.2\nestate,0.1\nsuv,0.3\nvan,0\nlorry,0\n"
Work = Callable[[], list[Job]]
Unread = Callable[[], AbstractContextManager[None]]
CODES = {None, *(one.code for one in STANDARDS)}
TABLES = ("figures", "rules", "years", "errors", "classes", "plan")


@pytest.fixture
def simulated(services: Services, work: Work, monkeypatch: pytest.MonkeyPatch) -> int:
    """The demonstration study of two small sites; its number."""
    sites = tuple(replace(one, daytime=22, low_light=16) for one in invented.SITES[:2])
    monkeypatch.setattr(invented, "SITES", sites)
    monkeypatch.setattr(invented, "FLEET_CSV", FLEET_CSV)
    with services.writing() as session:
        registry.enqueue(session, STUDY_KIND, {}, survey_id=None, actor=None)
    (job,) = work()
    assert job.error is None and job.result is not None
    return int(job.result["study_id"])


def changed(page: dict[str, Any], **more: Any) -> dict[str, Any]:
    """What changes a study as it stands."""
    names = ("name", "description", "fleet_csv", "sites_csv", "goal_m", "version")
    kept = ("survey_id", "site", "stratum", "year")
    surveys = [{name: one[name] for name in kept} for one in page["study"]["surveys"]]
    return {**{name: page["study"][name] for name in names}, "surveys": surveys, **more}


def package(operator: Client, work: Work, survey_id: int, folder: Path) -> str:
    """A survey's package, unpacked."""
    operator.made(f"/surveys/{survey_id}/exports", {"crops": False})
    work()
    made = operator.seen(f"/surveys/{survey_id}/exports")[0]
    place = folder / f"package-{survey_id}"
    with zipfile.ZipFile(io.BytesIO(operator.http.get(made["url"]).content)) as archive:
        archive.extractall(place)
    return str(place)


@pytest.mark.once
def test_what_heights_change_is_told_in_the_units_that_are_stored() -> None:
    """A result of an earlier version has the sentence in metres alone, one without a rule has none."""
    assert consequence_in({"consequence": {"en": "1.080 m", "fr": "1,080 m"}}, "fr") == {"m": "1,080 m"}
    both = {"m": "1.080 m", "ft": "3.543 ft"}
    assert consequence_in({"consequence": {"en": both}}, "en") == both
    assert consequence_in({"consequence": None}, "en") is None


@pytest.mark.once
@pytest.mark.parametrize("drawn", [False, pytest.param(True, marks=pytest.mark.proof)])
def test_a_study_of_two_sites(
    drawn: bool,
    simulated: int,
    operator: Client,
    services: Services,
    work: Work,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One ground for all of it, for making the sites is what takes long; `drawn`: with every report."""
    unread: Unread = nullcontext if drawn else partial(_reports_that_nobody_reads, monkeypatch)
    page = operator.seen(f"/studies/{simulated}")
    assert page["study"]["simulated"] and page["job"] is None
    first = page["result"]["found"]
    assert first["heights"] > 80, first["notes"]
    assert "Too few heights for the percentile" in first["consequence"]["m"], first["rules"]
    assert first["consequence"]["ft"] == first["consequence"]["m"], "it names no length"
    assert {one["whose"] for one in first["rules"]} <= {"cars", "trucks", "all"}
    asked = operator.get(f"/studies/{simulated}", headers={"Accept-Language": "fr"}).json()
    assert "Trop peu de hauteurs pour le centile" in asked["result"]["found"]["consequence"]["m"]
    _the_report_says_what_matters_first(operator, page["result"])
    _a_class_that_no_survey_saw_is_said(operator, work, page)
    page = operator.seen(f"/studies/{simulated}")
    with unread():
        result, sites_csv = _computed_again(operator, work, page)
        told = _by_the_command(operator, work, page, sites_csv, tmp_path, capsys)
    _are_the_same(result["found"], told)
    with zipfile.ZipFile(io.BytesIO(operator.http.get(result["package_url"]).content)) as archive:
        for name in TABLES:
            written = (tmp_path / "study" / f"{name}.csv").read_text()
            assert archive.read(f"{name}.csv").decode() == written
        rows = list(csv.DictReader(io.StringIO(archive.read("packages.csv").decode())))
        assert [one["place"] for one in rows] == ["survey 1", "survey 2"]
        assert "Simulated" in archive.read("datapackage.json").decode()
    with unread():
        _two_years_are_compared(operator, work, operator.seen(f"/studies/{simulated}"))
    _two_studies_are_compared(operator, work, operator.seen(f"/studies/{simulated}"), unread)
    with services.reading() as session:
        assert verify_records(session).ok


@contextmanager
def _reports_that_nobody_reads(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Of studies, and of packages with their figures: drawing them takes longer than all else."""
    with monkeypatch.context() as unread:
        unread.setattr("sightline.studies.report.report.study_report", lambda *_: b"")
        unread.setattr("sightline.export.build.draw_derived_files", lambda *_: [])
        yield


def _computed_again(operator: Client, work: Work, page: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """With strata, traffic, and a rule that takes every other vehicle: what packages say in their own way."""
    address, surveys = f"/studies/{page['study']['id']}", page["study"]["surveys"]
    survey_id = surveys[0]["survey_id"]
    survey = operator.seen(f"/surveys/{survey_id}")
    sampling = {**survey["sampling"], "method": "nth", "step": 2, "start": 1}
    body = {"name": survey["name"], "site": survey["site"], "version": survey["version"]}
    assert operator.put(f"/surveys/{survey_id}", {**body, "sampling": sampling}).status_code == 200
    sites_csv = "site,stratum,sites_there,traffic\n"
    sites_csv += "".join(f'"{one["site"]}",all,9,{n + 2}\n' for n, one in enumerate(surveys))
    assert operator.put(address, changed(page, sites_csv=sites_csv)).status_code == 200
    stale = operator.seen(address)["result"]
    assert stale["study_changed"] and stale["surveys_changed"] == [survey["name"]]
    operator.made(f"{address}/computings")
    assert [one.error for one in work()] == [None]
    result = operator.seen(address)["result"]
    assert not result["study_changed"] and result["surveys_changed"] == []
    return result, sites_csv


def _by_the_command(
    operator: Client,
    work: Work,
    page: dict[str, Any],
    sites_csv: str,
    folder: Path,
    capsys: pytest.CaptureFixture[str],
) -> dict[str, Any]:
    places = [package(operator, work, one["survey_id"], folder) for one in page["study"]["surveys"]]
    for name, text in (("fleet.csv", page["study"]["fleet_csv"]), ("sites.csv", sites_csv)):
        (folder / name).write_text(text)
    options = ["--weights", str(folder / "fleet.csv"), "--sites", str(folder / "sites.csv")]
    assert main(["study", *places, *options, "--quick", "--json", "-o", str(folder / "study")]) == 0
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


def _are_the_same(mine: dict[str, Any], told: dict[str, Any]) -> None:
    """Every figure to the last digit: floats are compared exactly."""
    assert (told["heights"], told["vehicles"]) == (mine["heights"], mine["vehicles"])
    assert sum(one["out_of_sample"] for one in mine["packages"]) > 10
    for name in TABLES:
        assert len(mine[name]) == len(told[name])
        for one, other in zip(mine[name], told[name], strict=True):
            assert one.pop("standard_code", None) in CODES  # by which pages say it; no column
            assert (one.pop("whose", "all") == "all") == (not one.get("by_class"))  # follows from it
            said = {key: value["message"] for key, value in one.items() if isinstance(value, dict)}
            assert {key: value for key, value in {**one, **said}.items() if value is not None} == {
                key: value for key, value in other.items() if value is not None and key in one
            }


def _the_report_says_what_matters_first(operator: Client, result: dict[str, Any]) -> None:
    """Percentile, total U95, rule, verdict and consequence on the first two pages."""
    text = pages(operator.http.get(result["report_url"]).content)
    first = " ".join(" ".join(text[:2]).split())
    for said in (
        "Simulated.",
        "total 95 % intervals",
        "the same percentile",
        "Verdict",
        "Too few heights for the percentile",  # P5 of taillights needs 72
    ):
        assert said in first, said
    tenth = next(
        one for one in result["found"]["figures"] if (one["target"], one["percent"]) == ("driver_eye", 10.0)
    )
    assert f"{tenth['value_m']:.3f}" in first and f"{tenth['low_m']:.3f}" in first


def _a_class_that_no_survey_saw_is_said(operator: Client, work: Work, page: dict[str, Any]) -> None:
    address = f"/studies/{page['study']['id']}"
    fleet = page["study"]["fleet_csv"].replace("suv,0.3", "suv,0.28") + "bus,0.02\n"
    assert operator.put(address, changed(page, fleet_csv=fleet)).status_code == 200
    operator.made(f"{address}/computings")
    (job,) = work()
    assert job.error is not None and "bus, which no survey contains" in str(job.error)
    again = changed(operator.seen(address), fleet_csv=page["study"]["fleet_csv"])
    assert operator.put(address, again).status_code == 200


def _two_years_are_compared(operator: Client, work: Work, page: dict[str, Any]) -> None:
    address = f"/studies/{page['study']['id']}"
    surveys = changed(page)["surveys"]
    dated = [{**one, "year": year} for one, year in zip(surveys, (2020, 2025), strict=True)]
    assert operator.put(address, changed(page, surveys=dated, sites_csv="")).status_code == 200
    operator.made(f"{address}/computings")
    work()
    years = operator.seen(address)["result"]["found"]["years"]
    assert {(one["first_year"], one["second_year"]) for one in years} == {(2020, 2025)}
    mean = next(one for one in years if (one["target"], one["percent"]) == ("roof", None))
    assert mean["low_m"] < mean["value_m"] < mean["high_m"] and mean["verdict"] is not None


def _a_study_of_simulated_surveys_says_so(operator: Client, page: dict[str, Any]) -> None:
    """Who joins them has a study that is as simulated as the demonstration's own."""
    listed = {one["id"]: one["simulated"] for one in operator.seen("/studies")}
    assert page["study"]["simulated"] and listed[page["study"]["id"]]
    result = page["result"]
    assert any(note["message"].startswith("Simulated:") for note in result["found"]["notes"])
    assert "Simulated." in pages(operator.http.get(result["report_url"]).content)[0]
    with zipfile.ZipFile(io.BytesIO(operator.http.get(result["package_url"]).content)) as archive:
        assert "Simulated:" in archive.read("datapackage.json").decode()
        assert "true" in archive.read("packages.csv").decode().splitlines()[1].split(",")


def _two_studies_are_compared(operator: Client, work: Work, page: dict[str, Any], unread: Unread) -> None:
    """A study of each site alone: what years told of the two, studies tell too."""
    made = []
    for one in changed(page)["surveys"]:
        alone = {**changed(page, sites_csv="", surveys=[one]), "name": one["site"]}
        made.append(operator.made("/studies", {key: alone[key] for key in alone if key != "version"}))
    first, second = made
    operator.made(f"/studies/{first['id']}/computings")
    work()
    operator.made(f"/studies/{second['id']}/computings")
    with unread():
        work()
    _a_study_of_simulated_surveys_says_so(operator, operator.seen(f"/studies/{first['id']}"))
    found = operator.seen(f"/studies/{second['id']}/beside/studies/{first['id']}")
    assert (found["first"], found["second"], found["shared_surveys"]) == (
        first["name"],
        second["name"],
        [],
    )
    years = operator.seen(f"/studies/{page['study']['id']}")["result"]["found"]["years"]
    told = {(one["target"], one["percent"]): one for one in found["differences"]}
    assert set(told) == {(one["target"], one["percent"]) for one in years}
    for one in years:
        mine = told[one["target"], one["percent"]]
        assert {name: mine[name] for name in mine} == {name: one[name] for name in mine}
    both = operator.seen(f"/studies/{second['id']}/beside/studies/{page['study']['id']}")
    assert both["shared_surveys"] == [second["surveys"][0]["name"]]


def test_a_study_is_made_changed_and_removed_with_its_audit(
    operator: Client, services: Services, viewer: Client
) -> None:
    survey = operator.made("/surveys", {"name": "Hill", "site": "Hill road", "open_to_all": True})
    made = operator.made("/studies", {"name": "One", "surveys": [{"survey_id": survey["id"]}]})
    assert made["surveys"][0]["site"] == "Hill road" and not made["simulated"]
    address = f"/studies/{made['id']}"
    assert viewer.put(address, {"name": "Two", "version": 1}).status_code == 404
    person = viewer.seen("/session")["person"]["id"]
    assert operator.put(f"{address}/members/{person}").status_code == 200
    assert viewer.put(address, {"name": "Two", "version": 1}).status_code == 403
    assert operator.put(address, {"name": "Two", "version": 1}).json()["version"] == 2
    late = operator.put(address, {"name": "Three", "version": 1})
    assert late.status_code == 409 and "Operator changed this study" in error_of(late)
    assert [one["name"] for one in operator.seen("/studies")] == ["Two"]
    assert operator.delete(f"{address}?version=2").status_code == 204
    assert operator.seen("/studies") == [] and operator.get(address).status_code == 404
    with services.reading() as session:
        events = trail.listing(session, entity="study")
    assert [one.action for one in events] == ["delete", "update", "create"]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"fleet_csv": "category,share\nsuv,0.4\nvan,0.4\n"}, "sum to 0.8, not to 1"),
        ({"fleet_csv": "category\nsuv\n"}, "needs a column"),
        ({"sites_csv": "site,stratum\nElsewhere,a\n"}, "no row for Hill"),
        ({"goal_m": 0.0}, "not a U95"),
        ({"name": "  "}, "needs a name"),
        ({"surveys": [{"survey_id": 1}, {"survey_id": 1}]}, "is in the study twice"),
        ({"surveys": [{"survey_id": 1, "year": 25}]}, "not a possible year"),
        ({"surveys": [{"survey_id": 99}]}, "There is no survey 99"),
    ],
)
def test_bad_input_is_one_sentence(change: dict[str, Any], said: str, operator: Client) -> None:
    operator.made("/surveys", {"name": "Hill"})
    answer = operator.post("/studies", {"name": "A", "surveys": [{"survey_id": 1}], **change})
    assert answer.status_code in (400, 404, 422) and said in error_of(answer)


def test_what_cannot_be_computed_says_why(operator: Client, work: Work) -> None:
    operator.made("/surveys", {"name": "Hill"})
    empty = operator.made("/studies", {"name": "A"})
    assert "has no survey" in error_of(operator.post(f"/studies/{empty['id']}/computings"))
    made = operator.made("/studies", {"name": "B", "surveys": [{"survey_id": 1}]})
    operator.made(f"/studies/{made['id']}/computings")
    (job,) = work()
    assert job.state == "failed" and job.error is not None and "Hill has no camera pose" in str(job.error)
    page = operator.seen(f"/studies/{made['id']}")
    assert page["result"] is None and page["job"]["error"] == job.error.body


def test_studies_without_figures_or_alone_are_not_compared(operator: Client, viewer: Client) -> None:
    for name in ("One", "Two"):
        operator.made("/studies", {"name": name})
    refused = operator.get("/studies/1/beside/studies/2")
    assert refused.status_code == 422 and "has not been computed" in error_of(refused)
    assert operator.get("/studies/1/beside/studies/99").status_code == 404
    assert viewer.get("/studies/1/beside/studies/2").status_code == 404


def test_people_see_the_studies_that_they_belong_to(
    operator: Client, reviewer: Client, admin: Client, viewer: Client
) -> None:
    survey = operator.made("/surveys", {"name": "Hill"})
    made = operator.made("/studies", {"name": "One", "surveys": [{"survey_id": survey["id"]}]})
    address = f"/studies/{made['id']}"
    for other in (reviewer, viewer):
        assert other.seen("/studies") == []
        for asked in (address, f"{address}/members", f"{address}/results/1.zip", f"{address}/results/1.pdf"):
            assert other.get(asked).status_code == 404, asked
    changes = {"name": "Mine", "version": 1}
    assert reviewer.put(address, changes).status_code == 404
    assert reviewer.delete(f"{address}?version=1").status_code == 404
    assert reviewer.post(f"{address}/computings").status_code == 404
    assert reviewer.put(f"{address}/open-to-all", {"open_to_all": True}).status_code == 404
    assert [one["name"] for one in admin.seen("/studies")] == ["One"]
    job = operator.made(f"{address}/computings")["id"]
    for other, mine in ((reviewer, False), (viewer, False), (operator, True), (admin, True)):
        assert (job in [one["id"] for one in other.seen("/jobs")]) == mine
        assert other.get(f"/jobs/{job}").status_code == (200 if mine else 404)
    assert reviewer.post(f"/jobs/{job}/cancel").status_code == 404
    found = operator.seen(f"{address}/members")
    assert [one["name"] for one in found["members"]] == ["Operator"] and not found["open_to_all"]
    person = next(one["id"] for one in found["others"] if one["name"] == "Viewer")
    assert operator.put(f"{address}/members/{person}").status_code == 200
    assert viewer.seen("/studies") == []  # not before they see its survey
    assert operator.put(f"/surveys/{survey['id']}/members/{person}", {"role": "viewer"}).status_code == 200
    assert [one["name"] for one in viewer.seen("/studies")] == ["One"]
    assert viewer.seen(address)["study"]["name"] == "One" and viewer.seen(f"/jobs/{job}")["id"] == job
    assert operator.delete(f"{address}/members/{person}").status_code == 200
    assert viewer.get(address).status_code == 404
    assert operator.put(f"{address}/open-to-all", {"open_to_all": True}).status_code == 200
    assert viewer.get(address).status_code == 200 and reviewer.get(address).status_code == 200
