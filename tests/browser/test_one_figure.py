"""One figure: every place that prints THE percentile of a rule prints the same digits of it.

A site of the demonstration study is measured; what is compared is what a person reads: the pages, the report,
the package's own page and its tables, the command line.
"""

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from sightline.cli import main
from sightline.demo import invented
from sightline.demo.invented import make_site
from sightline.export.build import build
from sightline.infra.csv_package.files import Staging
from sightline.infra.database.engine import migrate
from sightline.infra.services import open_services
from sightline.people.service import first_sign_in_link
from sightline.settings import load_settings
from sightline.studies.records import StudyFacts, StudySurvey
from sightline.studies.store import create_study
from sightline.studies.stored import ask_to_compute
from tests.export.report.pdf_text import words
from tests.support.working import run_jobs

from .server import Server, start

Printed = tuple[str, str, str]
RULES = ("AASHTO (USA) P10", "AASHTO (USA) P5", "United Kingdom P5", "France P10")
EYE, OBJECT = RULES[:2]
_NUMBER = r"\d\.\d{3}"


@dataclass(frozen=True)
class Measured:
    """Where the site is told of: the folder of its data, its package, and its study."""

    data_dir: Path
    package: Path
    survey_id: int
    study_id: int


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> Measured:
    """The first site of the demonstration, with taillights enough for a percentile, alone in a study."""
    folder = tmp_path_factory.mktemp("one-figure")
    services = open_services(load_settings(data_dir=folder / "data", find_passes=False))
    migrate(services.engine)
    assert first_sign_in_link(services)
    survey_id = make_site(services, replace(invented.SITES[0], low_light=90))
    with services.writing() as session:
        facts = StudyFacts(name="One site", surveys=(StudySurvey(survey_id, "A"),))
        study_id = create_study(session, facts, simulated=True, actor=None).id
        ask_to_compute(session, study_id, actor=None)
    assert [job.error for job in run_jobs(services)] == [None]
    package = folder / "package"
    package.mkdir()
    with services.reading() as session:
        build(Staging(package), session, survey_id, services)
    services.close()
    return Measured(folder / "data", package, survey_id, study_id)


@pytest.fixture(scope="module")
def site(measured: Measured) -> Iterator[Server]:
    server = start("serve --workers 0", measured.data_dir)  # nothing is left to do
    try:
        server.wait()
        yield server
    finally:
        server.stop()


@pytest.fixture(scope="module")  # the link signs in once, a second try too
def page(browser: Browser, site: Server) -> Iterator[Page]:
    context = browser.new_context(base_url=site.url, viewport={"width": 1440, "height": 900})
    page = context.new_page()
    page.goto(site.sign_in_link())
    page.wait_for_url(lambda url: "sign-in" not in url)
    yield page
    context.close()


def three(text: str) -> Printed:
    """The value and the ends of its interval, which a text names one after the other."""
    found = re.findall(_NUMBER, text)
    assert len(found) == 3, text
    value, low, high = found
    return value, low, high


def of_rules(rows: Locator, today: int) -> dict[str, Printed]:
    """What a table of rules prints: of each row the `today`th cell behind its name."""
    found = {}
    for row in rows.all():
        name = row.locator("th").first.inner_text()
        rule = row.locator("td").first.inner_text()  # "Driver’s eye: P10 of passenger cars"
        percent, _, _ = rule.partition(": ")[2].partition(" ")
        if (which := f"{name} {percent}") in RULES:
            found[which] = three(row.locator("td").nth(today).inner_text())
    return found


def to_the_millimetre(path: Path, *names: str) -> dict[str, Printed]:
    """A table of rules as CSV, its unrounded numbers printed as a person would by hand."""
    with path.open(encoding="utf-8", newline="") as file:
        there = [one for one in csv.DictReader(file) if one[names[0]]]
    rows = {f"{one['standard']} P{float(one['percent']):g}": one for one in there}
    return {which: three(" ".join(_rounded(rows[which][name]) for name in names)) for which in RULES}


def unrounded(path: Path) -> list[Printed]:
    """The figures of every rule of a package's table, in all their digits."""
    with path.open(encoding="utf-8", newline="") as file:
        return [(one["height_m"], one["low_m"], one["high_m"]) for one in csv.DictReader(file)]


def _rounded(cell: str) -> str:
    return str(Decimal(cell).quantize(Decimal("0.001"), ROUND_HALF_UP))


def of_report(path: Path) -> dict[str, Printed]:
    """The rows of the report's table of rules."""
    text = " ".join(words(path.read_bytes()).split())
    found = {}
    for which in RULES:
        name, percent = which.rsplit(" ", 1)
        cells = rf"{re.escape(name)}[^.]*? {percent} of .*? {_NUMBER} ({_NUMBER}) ({_NUMBER}) to ({_NUMBER})"
        row = re.search(cells, text)
        assert row, which
        found[which] = (row[1], row[2], row[3])
    return found


def test_every_place_prints_the_same_digits(
    page: Page, browser: Browser, measured: Measured, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page.goto(f"/statistics?survey={measured.survey_id}")
    rules = page.get_by_test_id("same-rule").locator("tbody tr")
    expect(rules.first).to_be_visible()
    figure = of_rules(rules, 2)
    assert set(figure) == set(RULES), figure

    told = page.request.get(f"/api/statistics?survey={measured.survey_id}").json()["rules"]

    page.goto(f"/sight-distance?survey={measured.survey_id}")
    own = page.get_by_test_id("sight-cases").locator("tbody tr").nth(1).locator("td")
    assert three(own.nth(0).inner_text()) == figure[EYE]
    assert three(own.nth(1).inner_text()) == figure[OBJECT]
    said = f"(eye {figure[EYE][0]}\u00a0m, object {figure[OBJECT][0]}\u00a0m)"
    expect(page.get_by_test_id("sight-sentence")).to_contain_text(said)
    sentence = page.get_by_test_id("sight-sentence").locator("p").first.inner_text()

    page.goto(f"/study?id={measured.study_id}")
    rules = page.get_by_test_id("same-rule").locator("tbody tr")
    expect(rules.first).to_be_visible()
    assert of_rules(rules, 2) == figure
    consequence = page.get_by_test_id("study-consequence").inner_text()
    assert consequence.split() == sentence.replace("survey’s heights", "study’s heights").split()

    table = measured.package / "statistics/same_rule.csv"
    assert to_the_millimetre(table, "height_m", "low_m", "high_m") == figure
    ends = ("value_m", "U95_low_m", "U95_high_m")
    assert unrounded(table) == [
        tuple("" if one[name] is None else f"{one[name]:.6f}" for name in ends) for one in told
    ]
    assert of_report(measured.package / "report.pdf") == figure
    report = "".join(words((measured.package / "report.pdf").read_bytes()).split())
    assert "".join(sentence.split()) in report
    readme = " ".join((measured.package / "README.txt").read_text("utf-8").split())
    assert " ".join(sentence.split()) in readme
    concluded = [f"{value} m (95 %: {low} to {high})" for value, low, high in (figure[EYE], figure[OBJECT])]
    assert [readme.count(one) for one in concluded] == [1, 1]

    opened = browser.new_context(offline=True).new_page()
    opened.goto(f"file://{measured.package}/index.html")
    opens_with = opened.locator("[data-conclusion]").first
    for one in (sentence, *concluded):
        expect(opens_with).to_contain_text(one)
    opened.get_by_text("statistics/same_rule.csv").locator("..").click(position={"x": 4, "y": 8})
    for which, printed in figure.items():
        name, percent = which.rsplit(" P", 1)
        row = opened.locator("tr", has_text=re.compile(rf"{re.escape(name)}\d\.\d{{3}}{percent}\D"))
        for one in printed:
            expect(row.get_by_role("cell", name=one, exact=True)).to_be_visible()

    assert main(["study", str(measured.package), "-o", str(tmp_path / "study"), "--quick"]) == 0
    capsys.readouterr()
    table = next((tmp_path / "study").rglob("rules.csv"))
    assert to_the_millimetre(table, "value_m", "low_m", "high_m") == figure
