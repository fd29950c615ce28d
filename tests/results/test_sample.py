"""Sampling of a survey: the rule stored, quotas with progress, each pass ended, listed and exported."""

from pathlib import Path
from typing import Any

import pytest

from sightline.cli import main
from sightline.commands.distribution import read_groups
from sightline.commands.errors import read_heights
from sightline.errors import BadInput
from sightline.export.build import build
from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles, Staging, fresh_folder
from sightline.infra.services import Services
from sightline.results.selection import Selection
from sightline.studies.packages import read_packages
from sightline.studies.query import StudyTables
from sightline.studies.records import StudiedPackage
from sightline.studies.stored_query import StoredTables
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pixel
from tests.support.packages import edit, reseal, rows, written

pytestmark = pytest.mark.dialect
ASKED = {"daytime": ["roof"], "low_light": ["roof"]}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def said(client: Client, ground: Ground, **sampling: object) -> None:
    """The survey's rule from now on."""
    path = f"/surveys/{ground.survey_id}"
    body = {"name": "Rouen", "version": client.seen(path)["version"], "asked": ASKED, "sampling": sampling}
    answer = client.put(path, body)
    assert answer.status_code == 200, answer.text


def fleet(client: Client, ground: Ground, count: int) -> list[int]:
    """Cars by day, numbered from 1, one after the other."""
    made = [
        add_vehicle(
            client,
            ground.recording_id,
            lighting="daytime",
            category="saloon",
            direction="right",
            first_frame=n,
            last_frame=n + 2,
        )
        for n in range(count)
    ]
    return [one["id"] for one in made]


def lower(n: int) -> dict[str, Any]:
    """Clicks on a roof a little lower each time."""
    return {"contact": pixel(0.0, 0.0, 0.0), "target_point": pixel(0.0, 0.0, 1.4 - n / 50)}


def studied_package(place: Path) -> StudiedPackage:
    (found,) = read_packages([place], lambda files: None, place.parent / "scratch")
    return found


def test_each_pass_ends_and_quotas_tell_how_far(operator: Client, viewer: Client, ground: Ground) -> None:
    quota = {"lighting": "daytime", "class_set": "passenger_cars", "wanted": 400}
    said(operator, ground, method="nth", step=2, start=1, quotas=[quota])
    ids = fleet(operator, ground, 7)  # 1, 3, 5 and 7 are in the sample
    measure(operator, ids[0])
    vehicle = f"/vehicles/{ids[2]}"
    assert operator.put(vehicle, {"roof_not_visible": "glare", "version": 1}).status_code == 200
    assert operator.put(f"/vehicles/{ids[4]}", {"discarded": "twice", "version": 1}).status_code == 200
    measure(operator, ids[1])
    found = viewer.seen(f"/surveys/{ground.survey_id}/sample")
    assert found["quotas"] == [{**quota, "measured": 1, "open": 1}]
    of_all = next(
        row
        for row in found["response"]
        if (row["lighting"], row["class_set"], row["target"]) == ("all", "all", None)
    )
    ends = ("passes", "discarded", "out_of_sample", "in_sample", "measured", "not_visible", "open", "outside")
    assert [of_all[name] for name in ends] == [7, 1, 3, 3, 1, 1, 1, 1]
    states = [one["state"] for one in viewer.seen(f"/surveys/{ground.survey_id}/vehicles")]
    assert states == [
        "measured",
        "measured",  # though it is out of the sample: the response says so
        "not_visible",
        "out_of_sample",
        "discarded",
        "out_of_sample",
        "to_do",
    ]
    counts = viewer.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["vehicles"], counts["vehicles_measured"]) == (3, 2)


def test_a_rejected_height_measures_nothing(
    operator: Client, reviewer: Client, viewer: Client, ground: Ground, services: Services, tmp_path: Path
) -> None:
    """Its pass is open again, on the page, in the overview and in the package."""
    said(operator, ground)
    for car, verdict in zip(fleet(operator, ground, 2), ("accepted", "rejected"), strict=True):
        judged = {"revision": 1, "verdict": verdict, "reason": "wrong vehicle"}
        reviewer.made(f"/measurements/{measure(operator, car)['id']}/reviews", judged)
    ends = ("passes", "in_sample", "measured", "open", "rate")
    of_all = viewer.seen(f"/surveys/{ground.survey_id}/sample")["response"][0]
    assert [of_all[name] for name in ends] == [2, 2, 1, 1, 0.5]
    assert viewer.seen(f"/surveys/{ground.survey_id}")["counts"]["vehicles_measured"] == 1
    place = written(services, ground.survey_id, tmp_path / "package")
    assert [rows(place, "statistics/response.csv")[0][name] for name in ends] == ["2", "2", "1", "1", "0.5"]
    assert verify_package(FolderFiles(place)).ok


@pytest.mark.parametrize("rule", [{}, {"method": "nth", "step": 1, "start": 1}])
def test_a_check_target_is_to_do_whatever_the_sample(
    operator: Client, viewer: Client, ground: Ground, rule: dict[str, Any]
) -> None:
    said(operator, ground, **rule)
    car, staff = fleet(operator, ground, 2)
    assert operator.put(f"/vehicles/{staff}", {"check_target": True, "version": 1}).status_code == 200
    measure(operator, car)
    counts = viewer.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["vehicles"], counts["vehicles_measured"]) == (2, 1)


@pytest.mark.once
def test_clicks_without_a_height_measure_nothing(
    operator: Client, viewer: Client, ground: Ground, services: Services, tmp_path: Path
) -> None:
    """Their pass is still to do, on the page, in the list, in the overview and in the package."""
    said(operator, ground)
    measured, in_the_sky = fleet(operator, ground, 2)
    measure(operator, measured)
    made = measure(operator, in_the_sky, contact=(960.0, 2.0), target_point=(960.0, 1.0))
    assert made["status"] == "not_measurable"
    ends = ("in_sample", "measured", "open", "rate")
    of_all = viewer.seen(f"/surveys/{ground.survey_id}/sample")["response"][0]
    assert [of_all[name] for name in ends] == [2, 1, 1, 0.5]
    states = [one["state"] for one in viewer.seen(f"/surveys/{ground.survey_id}/vehicles")]
    assert states == ["measured", "partial"]
    assert viewer.seen(f"/surveys/{ground.survey_id}")["counts"]["vehicles_measured"] == 1
    place = written(services, ground.survey_id, tmp_path / "package")
    assert [rows(place, "statistics/response.csv")[0][name] for name in ends] == ["2", "1", "1", "0.5"]
    assert verify_package(FolderFiles(place)).ok


def test_free_flowing_vehicles_alone(operator: Client, viewer: Client, ground: Ground) -> None:
    ids = fleet(operator, ground, 3)
    recording = viewer.seen(f"/recordings/{ground.recording_id}")
    frame_s = recording["duration_s"] / recording["frame_count"]
    said(operator, ground, free_flowing_s=1.5 * frame_s)
    assert [viewer.seen(f"/vehicles/{one}")["in_sample"] for one in ids] == [True, False, False]
    assert operator.put(f"/vehicles/{ids[1]}", {"discarded": "no_vehicle", "version": 1}).status_code == 200
    assert [viewer.seen(f"/vehicles/{one}")["in_sample"] for one in ids] == [True, False, True]


@pytest.mark.once
def test_discarding_and_measuring_exclude_each_other(operator: Client, ground: Ground) -> None:
    (one, other) = fleet(operator, ground, 2)
    measure(operator, one)
    refused = operator.put(f"/vehicles/{one}", {"discarded": "stopped", "version": 1})
    assert refused.status_code == 422 and "withdraw" in error_of(refused)
    assert operator.seen(f"/vehicles/{one}")["discarded"] is None
    assert operator.put(f"/vehicles/{other}", {"discarded": "stopped", "version": 1}).status_code == 200
    measure(operator, other)
    assert operator.seen(f"/vehicles/{other}")["discarded"] is None
    assert operator.put(f"/vehicles/{other}", {"discarded": "tired", "version": 3}).status_code == 422


@pytest.mark.once
@pytest.mark.parametrize(
    ("wrong", "word"),
    [
        ({"method": "nth", "step": 3, "start": 4}, "from 1 to n"),
        ({"method": "nth", "step": 0}, "step"),
        ({"method": "share", "share_percent": 0}, "share_percent"),
        ({"free_flowing_s": 0}, "free_flowing_s"),
        ({"method": "some"}, "method"),
        ({"quotas": [{"lighting": "daytime", "wanted": 2}] * 2}, "given twice"),
        ({"quotas": [{"lighting": "daytime", "wanted": 0}]}, "wanted"),
    ],
)
def test_a_rule_that_cannot_be_is_refused(
    operator: Client, survey_id: int, wrong: dict[str, object], word: str
) -> None:
    answer = operator.put(f"/surveys/{survey_id}", {"name": "Rouen", "version": 1, "sampling": wrong})
    assert answer.status_code == 422 and word in answer.text
    assert operator.seen(f"/surveys/{survey_id}")["version"] == 1


@pytest.mark.once
def test_the_package_holds_rule_and_response_and_finds_a_forged_one(
    operator: Client,
    ground: Ground,
    services: Services,
    tmp_path: Path,
) -> None:
    said(
        operator,
        ground,
        method="share",
        share_percent=50,
        seed=3,
        quotas=[{"lighting": "daytime", "wanted": 9}],
    )
    ids = fleet(operator, ground, 8)
    taken = [one for one in ids if operator.seen(f"/vehicles/{one}")["in_sample"]]
    assert 0 < len(taken) < 8
    measure(operator, taken[0])
    assert operator.put(f"/vehicles/{taken[1]}", {"discarded": "cut_off", "version": 1}).status_code == 200
    place = written(services, ground.survey_id, tmp_path / "package")
    assert verify_package(FolderFiles(place)).ok
    (rule,) = rows(place, "sampling.csv")
    assert (rule["method"], rule["share_percent"], rule["seed"]) == ("share", "50.0", "3")
    assert [row["wanted"] for row in rows(place, "quotas.csv")] == ["9"]
    of_all = rows(place, "statistics/response.csv")[0]
    counted = [of_all[name] for name in ("passes", "discarded", "in_sample", "measured")]
    assert counted == ["8", "1", str(len(taken) - 1), "1"]
    report = " ".join(words((place / "report.pdf").read_bytes()).split())
    assert "A random share of 50 % of the passes (seed 3)" in report
    edit(place, "vehicles.csv", lambda row: row["in_sample"] == "false", in_sample="true")
    reseal(place)
    assert "sample" in str(verify_package(FolderFiles(place)).problem)


@pytest.mark.once
def test_the_rule_is_held_against_the_chain(
    operator: Client, ground: Ground, services: Services, tmp_path: Path
) -> None:
    said(operator, ground, method="nth", step=2)
    place = written(services, ground.survey_id, tmp_path / "package")
    edit(place, "sampling.csv", lambda row: True, step="3")
    reseal(place)
    assert "sampling.csv" in str(verify_package(FolderFiles(place)).problem)


@pytest.mark.parametrize("outside", [False, pytest.param(True, marks=pytest.mark.proof)])
def test_one_population_wherever_heights_are_counted(
    operator: Client,
    reviewer: Client,
    viewer: Client,
    ground: Ground,
    services: Services,
    tmp_path: Path,
    outside: bool,
) -> None:
    """Page, sight distance, package, report, study here and of packages, and the command count the same."""
    ids = fleet(operator, ground, 6)
    said(operator, ground, method="nth", step=3, start=1, outside_counts=outside)  # takes 1 and 4
    for n, one in enumerate(ids):
        made = measure(operator, one, **lower(n))
        reviewer.made(f"/measurements/{made['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    check = operator.put(f"/vehicles/{ids[5]}", {"check_target": True, "version": 1})
    assert check.status_code == 200 and not check.json()["counts"]
    counted, left = (5, 0) if outside else (2, 3)
    assert [viewer.seen(f"/vehicles/{one}")["counts"] for one in ids[:5]] == [
        outside or n in (0, 3) for n in range(5)
    ]

    page = viewer.seen(f"/statistics?survey={ground.survey_id}&target=roof")
    assert (page["counted"]["measurements"], page["targets"][0]["corrected"]["n"]) == (counted, counted)
    assert page["counted"]["left_out"] == ({} if outside else {"out_of_sample": 3})

    place = written(services, ground.survey_id, tmp_path / "package")
    assert verify_package(FolderFiles(place)).ok
    (rule,) = rows(place, "sampling.csv")
    assert rule["outside_counts"] == str(outside).lower()
    total = rows(place, "statistics/total_uncertainty.csv")
    assert {row["n"] for row in total if row["target"] == "roof"} == {str(counted)}
    assert [row["state"] for row in rows(place, "exclusions.csv")] == ["out_of_sample"] * left + [
        "check_target"
    ]
    report = " ".join(words((place / "report.pdf").read_bytes()).split())
    assert ("and count in the results" in report) == outside
    assert ("do not count in the results" in report) == (not outside)

    with services.reading() as session:
        here = StoredTables(session, [ground.survey_id])
    with StudyTables([studied_package(place)]) as there:
        for study in (here, there):
            assert [one.tolist() for one in study.counted()] == [[counted], [left]]
            assert len(study.heights("roof").height_m) == counted

    pose = next((place / "poses").glob("*.json"))
    heights = tmp_path / "heights.csv"
    clicks = next((place / "clicks").glob("*.csv"))
    assert main(["height", "--pose", str(pose), "--clicks", str(clicks), "-o", str(heights)]) == 0
    (of_command,) = read_groups(heights, None)[0].values()
    assert sorted(of_command.height_m) == sorted(here.heights("roof").height_m)


@pytest.mark.once
@pytest.mark.parametrize("selected", [pytest.param(False, marks=pytest.mark.proof), True])
def test_commands_evaluate_the_clicks_that_the_report_evaluates(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    tmp_path: Path,
    selected: bool,
) -> None:
    """Of accepted, rejected and waiting heights, of check targets alike, the accepted; of a selection's."""
    said(operator, ground)
    ids = fleet(operator, ground, 7)
    verdicts = ("accepted", "rejected", None, "accepted", "rejected", None, "accepted")
    for n, (one, verdict) in enumerate(zip(ids, verdicts, strict=True)):
        facts = {"check_target": n in (3, 4, 5), "category": "lorry" if n == 6 else "saloon"}
        known = {"manufacturer_height_m": 1.4 - n / 50, "height_source": "dealer", "version": 1}
        assert operator.put(f"/vehicles/{one}", {**facts, **known}).status_code == 200
        made = measure(operator, one, **lower(n))
        if verdict:
            judged = {"revision": 1, "verdict": verdict, "reason": "wrong vehicle"}
            reviewer.made(f"/measurements/{made['id']}/reviews", judged)
    chosen = Selection(categories=("saloon",)) if selected else Selection()
    with services.reading() as session, fresh_folder(tmp_path / "package") as folder:
        build(Staging(folder), session, ground.survey_id, services, selection=chosen)
    place = tmp_path / "package"
    found = verify_package(FolderFiles(place))
    assert found.ok, found.problem
    left_out = {row["measurement_id"]: row["state"] for row in rows(place, "exclusions.csv")}
    for row in rows(place, "clicks.csv"):
        state = left_out.get(row["id"].removeprefix("m"))
        assert (row["counts"] == "true") == (state is None), row["id"]
        assert (row["error_counts"] == "true") == (state in (None, "check_target")), row["id"]

    heights, (pose,) = tmp_path / "heights.csv", (place / "poses").glob("*.json")
    clicks = str(place / "tables" / "clicks.csv")
    assert main(["height", "--pose", str(pose), "--clicks", clicks, "-o", str(heights)]) == 0
    total = {row["n"] for row in rows(place, "statistics/total_uncertainty.csv") if row["target"] == "roof"}
    (of_command,) = read_groups(heights, None)[0].values()
    assert {str(len(of_command.height_m))} == total == {"1" if selected else "2"}
    with pytest.raises(BadInput, match=r"measurements.csv has verdicts and no column counts"):
        read_groups(place / "tables" / "measurements.csv", None)
    told = {
        (row["target"], row["check_target"] == "true"): int(row["n"])
        for row in rows(place, "statistics/errors_by_target.csv")
        if (row["heights"], row["grouping"], row["figure"]) == ("inset", "all", "bias_m")
    }
    (group,) = read_heights(heights, None).values()
    assert {key: len(of.height_m) for key, of in group.rows.items()} == told


@pytest.mark.once
def test_what_counts_is_held_against_the_chain_and_the_passes(
    operator: Client, ground: Ground, services: Services, tmp_path: Path
) -> None:
    ids = fleet(operator, ground, 2)
    said(operator, ground, method="nth", step=2)
    for n, one in enumerate(ids):
        measure(operator, one, **lower(n))
    for name, row, lie in (
        ("sampling.csv", {"outside_counts": "false"}, {"outside_counts": "true"}),
        ("vehicles.csv", {"counts": "false"}, {"counts": "true"}),
    ):
        place = written(services, ground.survey_id, tmp_path / name)
        edit(place, name, lambda one, row=row: row.items() <= one.items(), **lie)
        reseal(place)
        assert name in str(verify_package(FolderFiles(place)).problem)


def test_passes_of_a_deleted_recording_are_counted_nowhere(
    operator: Client, services: Services, ground: Ground, tmp_path: Path
) -> None:
    gone, *_ = fleet(operator, ground, 2)
    assert operator.delete(f"/recordings/{ground.recording_id}").status_code == 204
    path = f"/surveys/{ground.survey_id}"
    counts = operator.seen(path)["counts"]
    assert (counts["recordings"], counts["vehicles"]) == (0, 0)
    assert operator.seen(f"{path}/vehicles") == [] == operator.seen(f"{path}/sample")["response"]
    assert operator.post(f"/vehicles/{gone}/restore").status_code == 404
    package = written(services, ground.survey_id, tmp_path / "package")
    assert rows(package, "vehicles.csv") == []
    verify_package(FolderFiles(package))
