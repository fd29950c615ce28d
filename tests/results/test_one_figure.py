"""One figure: wherever THE percentile of a rule stands, it has the same digits."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.export.report.crest import cases_of
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.results.survey_statistics import (
    Filter,
    height_sample,
    measured_columns,
    survey_statistics,
)
from tests.bench.seed import seed
from tests.support.app import Client

Three = tuple[float, float, float]
ASKED = (("driver_eye", "eye_car", 10.0), ("taillight", "object_stopping", 5.0))


def three(row: dict[str, Any], *names: str) -> Three:
    value, low, high = (row[name] for name in names)
    return value, low, high


@pytest.fixture
def survey(services: Services) -> int:
    """300 vehicles of some classes, each with roof, eye and taillight."""
    return seed(services.sessions, 900).survey.id


def the_page(viewer: Client, survey: int, chosen: str = "") -> dict[str, Three]:
    rules = viewer.get(f"/statistics?survey={survey}{chosen}").json()["rules"]
    return {
        what: three(
            next(
                one
                for one in rules
                if (one["standard"]["what"], one["standard"]["percent"]) == (what, percent)
            ),
            "value_m",
            "U95_low_m",
            "U95_high_m",
        )
        for _, what, percent in ASKED
    }


def test_on_chosen_classes_every_place_says_the_same(services: Services, survey: int, viewer: Client) -> None:
    """Two classes of passenger cars and the vans are chosen: the rule is read on the cars among them."""
    chosen = "&class_set=light_trucks&category=suv&category=saloon"
    figure = the_page(viewer, survey, chosen)
    with services.reading() as session:
        asked = Filter(survey_ids=(survey,), class_sets=("light_trucks",), categories=("suv", "saloon"))
        found = cases_of(survey_statistics(session, asked), "m")
    assert found is not None and found[4].crest is not None
    of_report = {"eye_m": found[4].crest.eye_m, "object_m": found[4].crest.object_m}
    crest = viewer.get(f"/sightdistance?survey={survey}&object_target=taillight{chosen}").json()["cases"][1][
        "crest"
    ]
    for name, what in (("eye_m", "eye_car"), ("object_m", "object_stopping")):
        assert three(crest[name], "value", "low", "high") == figure[what], name
        assert (of_report[name].value, of_report[name].low, of_report[name].high) == figure[what], name


def by_the_command(services: Services, survey: int, folder: Path, target: str, percent: float) -> list[str]:
    """heights.csv of the class of the rule, as somebody would write it who has the numbers: in full."""
    with services.reading() as session:
        rows = measured_columns(session, Filter(survey_ids=(survey,), target=target))  # type: ignore[arg-type]
        rows = rows.where(rows.of_classes((), ("passenger_cars",)))
    sample = height_sample(rows)
    (shared,) = sample.shared  # the seed's heights share a pose, and assume no inset
    path = folder / f"{target}.csv"
    lines = ["height_m,u_random_m,shared_group,u_shared_m,status"]
    lines += [
        f"{height!r},{random!r},pose {group},{u!r},ok"
        for height, random, group, u in zip(
            sample.height_m.tolist(),
            sample.u_random_m.tolist(),
            shared.group.tolist(),
            shared.u_m.tolist(),
            strict=True,
        )
    ]
    path.write_text("\n".join(lines) + "\n", "utf-8")
    return [str(path), "--percentile", f"{percent:g}", "--json"]


def test_every_place_says_the_same_to_the_last_digit(
    services: Services,
    survey: int,
    operator: Client,
    viewer: Client,
    work: Callable[[], list[Job]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    figure = the_page(viewer, survey)
    assert all(one[1] < one[0] < one[2] for one in figure.values())
    # the sight-distance page
    crest = viewer.get(f"/sightdistance?survey={survey}&object_target=taillight").json()["cases"][1]["crest"]
    for name, what in (("eye_m", "eye_car"), ("object_m", "object_stopping")):
        assert three(crest[name], "value", "low", "high") == figure[what], name
    # the report's crest, from the statistics that it has at hand
    with services.reading() as session:
        found = cases_of(survey_statistics(session, Filter(survey_ids=(survey,))), "m")
    assert found is not None and found[4].crest is not None
    for one, what in ((found[4].crest.eye_m, "eye_car"), (found[4].crest.object_m, "object_stopping")):
        assert (one.value, one.low, one.high) == figure[what]
    # a study of this one survey
    study = operator.made("/studies", {"name": "One", "surveys": [{"survey_id": survey}]})
    operator.made(f"/studies/{study['id']}/computings")
    assert [one.error for one in work()] == [None]
    rules = operator.seen(f"/studies/{study['id']}")["result"]["found"]["rules"]
    for _, what, percent in ASKED:
        row = next(one for one in rules if (one["what"], one["percent"]) == (what, percent))
        assert three(row, "value_m", "low_m", "high_m") == figure[what], what
    # the command line: distribution, and sight distance of the same files
    paths = {}
    for target, what, percent in ASKED:
        arguments = by_the_command(services, survey, tmp_path, target, percent)
        paths[target] = arguments[0]
        assert main(["distribution", *arguments]) == 0
        (one,) = json.loads(capsys.readouterr().out)["groups"]["all"]["percentiles"].values()
        assert three(one, "value", "U95_low", "U95_high") == figure[what], what
    given = ["--eye-heights", paths["driver_eye"], "--object-heights", paths["taillight"]]
    assert main(["sightdistance", *given, "--distance", "185", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    for name, what in (("eye_m", "eye_car"), ("object_m", "object_stopping")):
        assert three(told, name, f"{name}_U95_low", f"{name}_U95_high") == figure[what]


def test_known_heights_without_a_u_have_the_same_one_on_the_page_and_in_the_package(
    services: Services, survey: int, viewer: Client
) -> None:
    page = viewer.seen(f"/statistics?survey={survey}")["errors"]["reference_part"]
    with services.reading() as session:
        found = survey_statistics(session, Filter(survey_ids=(survey,))).errors.reference_part
    assert not isinstance(found, Said)
    assert page["u_reference_m"] == found.u_reference_m
    assert page["share_of_variance"] == found.share_of_variance
