"""A package of some vehicles: statistics and report of them alone, said on its first page, verified."""

import io
import json
import re
import zipfile
from collections.abc import Callable
from datetime import date
from pathlib import Path

import pytest
from sqlalchemy import text

from sightline.cli import main
from sightline.export import page
from sightline.export.measured import statistics_of
from sightline.export.report.package_facts import report_facts
from sightline.export.report.said import speaking
from sightline.export.report.words import selection_words
from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.recordings.ingest_job import correct_durations
from sightline.results.selection import Selection
from tests.export.report.pdf_text import words
from tests.media.clips import QVGA, TICKS, Spec, write
from tests.support.app import Client, add_recording, error_of
from tests.support.events import events_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure
from tests.support.packages import edit, reseal, rows


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


KINDS = (
    ("saloon", "daytime", 1.31),
    ("suv", "daytime", 1.32),
    ("suv", "low_light", 1.33),
    ("van", "daytime", 1.34),
    ("lorry", "low_light", 1.35),
    (None, "daytime", 1.36),
)


@pytest.fixture
def fleet(operator: Client, reviewer: Client, ground: Ground) -> Ground:
    """Vehicles of every set, and one of no class, by day and in low light, all accepted."""
    for category, lighting, height in KINDS:
        known = {"category": category, "lighting": lighting, "manufacturer_height_m": height}
        car = add_vehicle(operator, ground.recording_id, **known)["id"]
        made = measure(operator, car)
        reviewer.made(f"/measurements/{made['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    return ground


def built(
    viewer: Client, ground: Ground, work: Callable[[], list[Job]], place: Path, chosen: dict[str, object]
) -> Path:
    """A package made by the button, unpacked."""
    viewer.made(f"/surveys/{ground.survey_id}/exports", chosen)
    assert [one.state for one in work()] == ["done"]
    made = viewer.seen(f"/surveys/{ground.survey_id}/exports")[0]
    with zipfile.ZipFile(io.BytesIO(viewer.http.get(made["url"]).content)) as archive:
        archive.extractall(place)
    no_words: dict[str, object] = {"lighting": None, "class_sets": [], "categories": []}
    any_time = dict.fromkeys(("filmed_from", "filmed_to", "hour_from", "hour_to"))
    assert made["selection"] == {**no_words, **any_time, **chosen}
    return place


def limits_on_the_page(place: Path) -> object:
    """What index.html says at its top that the package is limited to."""
    if page.template() is None:
        pytest.skip("the front end is not built")
    found = re.search(r'id="about">(.*?)</script>', (place / "index.html").read_text())
    assert found
    return json.loads(found[1])["only"]


def counted(place: Path) -> set[str]:
    """The vehicles whose measurements count."""
    left_out = {row["measurement_id"] for row in rows(place, "exclusions.csv")}
    return {row["vehicle_id"] for row in rows(place, "measurements.csv") if row["id"] not in left_out}


CHOICES = (
    pytest.param({"lighting": "daytime"}, {0, 1, 3, 5}, "daytime", marks=pytest.mark.proof),
    pytest.param({"class_sets": ["passenger_cars"]}, {0, 1, 2}, "passenger cars", marks=pytest.mark.proof),
    (
        {"lighting": "low_light", "class_sets": ["heavy"], "categories": ["suv"]},
        {2, 4},
        "low light; heavy vehicles, SUV",
    ),
)


@pytest.mark.parametrize(("chosen", "kept", "said"), CHOICES)
def test_a_package_is_of_the_vehicles_chosen(
    viewer: Client,
    fleet: Ground,
    work: Callable[[], list[Job]],
    tmp_path: Path,
    chosen: dict[str, object],
    kept: set[int],
    said: str,
) -> None:
    place = built(viewer, fleet, work, tmp_path / "export", chosen)
    vehicles = [row["id"] for row in rows(place, "vehicles.csv")]
    assert len(vehicles) == len(KINDS)  # the tables stay whole
    assert counted(place) == {vehicles[k] for k in kept}
    pictured = {row["measurement_id"] for row in rows(place, "crops.csv")}
    of = {row["id"]: row["vehicle_id"] for row in rows(place, "measurements.csv")}
    assert {of[id_] for id_ in pictured} == {vehicles[k] for k in kept}
    errors = rows(place, "statistics/error_table.csv")
    of_all = {row["n"] for row in errors if row["group"] == "overall"}
    assert of_all == {str(len(kept))}
    states = [row["state"] for row in rows(place, "exclusions.csv")]
    assert states == ["not_selected"] * (len(KINDS) - len(kept))
    report = " ".join(words((place / "report.pdf").read_bytes()).split())
    assert f"Only: {said}." in report
    assert report.index("Only:") < report.index("Measured")  # on the first page, above the facts
    assert f"only of: {said}." in (place / "datapackage.json").read_text()
    found = verify_package(FolderFiles(place))
    assert found.ok, found.problem
    query = re.sub(r"'|\[|\]", "", "&".join(_query(chosen)))
    shown = viewer.seen(f"/statistics?survey={fleet.survey_id}&{query}")
    assert shown["counted"]["measurements"] == len(kept)
    what_is_said_of_all_is_of_them(place, {vehicles[k] for k in kept})
    assert limits_on_the_page(place) == said
    counts_are_of_the_heights_in_the_results(place, {vehicles[k] for k in kept})


def what_is_said_of_all_is_of_them(place: Path, kept: set[str]) -> None:
    """Days, poses, lenses and programs of measurements that no figure is of are not the report's."""
    files = FolderFiles(place)
    made, path = statistics_of(files), place / "tables" / "measurements.csv"
    before, written = report_facts(files, made, {}), path.read_bytes()
    another = {"clicked_at": "2020-01-01T00:00:00.000000Z", "pose_id": "99", "code_version": "0.0.1"}
    edit(place, "measurements.csv", lambda row: row["vehicle_id"] not in kept, **another)
    after = report_facts(files, made, {})
    assert (after.first_day, after.code_versions) == (before.first_day, before.code_versions)
    assert after.counts == before.counts and len(after.poses) == 1
    edit(place, "measurements.csv", lambda row: row["vehicle_id"] in kept, **another)
    assert report_facts(files, made, {}).poses == ()
    path.write_bytes(written)


def counts_are_of_the_heights_in_the_results(place: Path, kept: set[str]) -> None:
    """What other vehicles lack is not told; nor what check targets lack, nor rejected heights."""
    files = FolderFiles(place)
    made = statistics_of(files)

    def told() -> tuple[int, int, int]:
        facts = report_facts(files, made, {})
        return facts.out_of_date, facts.not_visible, facts.verdicts.individual

    assert told() == (0, 0, len(kept))
    edit(place, "measurements.csv", lambda row: row["vehicle_id"] not in kept, out_of_date="inset")
    edit(place, "vehicles.csv", lambda row: row["id"] not in kept, driver_eye_not_visible="glare")
    assert told() == (0, 0, len(kept))
    edit(place, "measurements.csv", lambda row: True, out_of_date="inset")
    edit(place, "vehicles.csv", lambda row: True, driver_eye_not_visible="glare")
    assert told() == (len(kept),) * 3
    checked, rejected = sorted(kept)[:2]
    edit(place, "vehicles.csv", lambda row: row["id"] == checked, check_target="true")
    assert told() == (len(kept) - 1,) * 3
    one = {"verdict": "rejected"}, {"verdict": "accepted", "status": "not_measurable", "height_m": ""}
    for without_height in one:
        edit(place, "measurements.csv", lambda row: row["vehicle_id"] == rejected, **without_height)
        assert told() == (len(kept) - 2, len(kept) - 1, len(kept) - 2), without_height


def _query(chosen: dict[str, object]) -> list[str]:
    names = {"lighting": "lighting", "class_sets": "class_set", "categories": "category"}
    return [
        f"{names[name]}={one}"
        for name, value in chosen.items()
        for one in (value if isinstance(value, list) else [value])
    ]


def test_a_whole_package_says_nothing_of_a_selection(
    viewer: Client, fleet: Ground, work: Callable[[], list[Job]], tmp_path: Path
) -> None:
    place = built(viewer, fleet, work, tmp_path / "export", {})
    assert rows(place, "selection.csv") == [] and rows(place, "exclusions.csv") == []
    assert "Only:" not in words((place / "report.pdf").read_bytes())
    assert limits_on_the_page(place) is None


def test_a_set_or_a_selection_that_was_changed_is_found(
    viewer: Client, fleet: Ground, work: Callable[[], list[Job]], tmp_path: Path
) -> None:
    place = built(viewer, fleet, work, tmp_path / "export", {"class_sets": ["heavy"]})
    edit(place, "classes.csv", lambda row: row["category"] == "van", class_set="heavy")
    reseal(place)
    found = verify_package(FolderFiles(place))
    assert not found.ok and "classes.csv" in str(found.problem)
    edit(place, "classes.csv", lambda row: row["category"] == "van", class_set="light_trucks")
    edit(place, "selection.csv", lambda row: row["word"] == "heavy", word="light_trucks")
    reseal(place, page=True)
    found = verify_package(FolderFiles(place))
    assert not found.ok


def test_a_survey_that_sorts_otherwise_is_counted_otherwise(
    operator: Client, viewer: Client, fleet: Ground
) -> None:
    path = f"/surveys/{fleet.survey_id}"
    asked = f"/statistics?survey={fleet.survey_id}&class_set=light_trucks"
    assert viewer.seen(asked)["counted"]["measurements"] == 1
    light = [{"category": "suv", "class_set": "light_trucks"}, {"category": "van", "class_set": None}]
    body = {"name": "Rouen", "version": operator.seen(path)["version"], "classes": light}
    assert operator.put(path, body).status_code == 200
    assert viewer.seen(asked)["counted"]["measurements"] == 2


def test_words_that_are_no_class_are_refused(viewer: Client, fleet: Ground) -> None:
    path = f"/surveys/{fleet.survey_id}/exports"
    for wrong in ({"lighting": "dusk"}, {"class_sets": ["taxis"]}, {"categories": ["tank"]}):
        assert viewer.post(path, wrong).status_code == 422
    assert viewer.get(f"/statistics?survey={fleet.survey_id}&class_set=taxis").status_code == 422
    backwards = {"filmed_from": "2026-01-02", "filmed_to": "2025-01-01"}
    assert "last day is before the first" in error_of(viewer.post(path, backwards))


def test_the_command_takes_several_sets_and_classes(
    fleet: Ground, database_url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", database_url)
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(tmp_path))
    asked = ["--set", "heavy", "--category", "saloon", "--category", "van", "--no-crops"]
    place = tmp_path / "package"
    backwards = ["--filmed-from", "2026-01-02", "--filmed-to", "2025-01-01"]
    assert main(["export", "--survey", str(fleet.survey_id), "-o", str(place), *backwards]) == 2
    assert not place.exists()
    assert main(["export", "--survey", str(fleet.survey_id), "-o", str(place), *asked]) == 0
    assert [(row["by"], row["word"]) for row in rows(place, "selection.csv")] == [
        ("class_set", "heavy"),
        ("category", "saloon"),
        ("category", "van"),
    ]
    assert len(counted(place)) == 3


def test_a_package_of_days_of_filming(
    operator: Client,
    reviewer: Client,
    viewer: Client,
    ground: Ground,
    work: Callable[[], list[Job]],
    tmp_path: Path,
) -> None:
    """Midnight passes while it is filmed: page and package take the same vehicles for a day."""
    start = {"local": "2026-05-03T23:59:59.900", "time_zone": "Europe/Paris"}
    for first, height in ((0, 1.31), (0, 1.32), (5, 1.33)):
        known = {"manufacturer_height_m": height, "first_frame": first}
        made = measure(operator, add_vehicle(operator, ground.recording_id, **known)["id"], frame=6)
        reviewer.made(f"/measurements/{made['id']}/reviews", {"revision": 1, "verdict": "accepted"})

    def counted(query: str) -> int:
        found = viewer.seen(f"/statistics?survey={ground.survey_id}&{query}")
        count: int = found["counted"]["vehicles"]
        return count

    assert (counted(""), counted("filmed_from=2026-05-03"), counted("filmed_to=2026-05-05")) == (3, 0, 0)
    asked = f"/statistics?survey={ground.survey_id}&hour_from=7"
    assert viewer.seen(asked)["counted"]["without_time"] == 3
    answer = operator.put(f"/recordings/{ground.recording_id}", {"start": start})
    assert answer.status_code == 200, answer.text
    assert (counted("filmed_from=2026-05-04"), counted("filmed_to=2026-05-03")) == (1, 2)
    assert counted("filmed_from=2026-05-03&filmed_to=2026-05-04") == 3
    by_hour = ("hour_from=23", "hour_to=1", "hour_from=22&hour_to=1", "hour_from=1&hour_to=23", "hour_to=24")
    assert [counted(one) for one in by_hour] == [2, 1, 3, 0, 3]
    assert counted("filmed_to=2026-05-03&hour_to=1") == 0
    assert viewer.seen(asked)["counted"]["without_time"] == 0
    refused = viewer.get("/statistics?filmed_from=2026-05-04&filmed_to=2026-05-03")
    assert refused.status_code == 422
    for wrong in ("hour_from=7&hour_to=7", "hour_from=24", "hour_to=0"):
        assert viewer.get(f"/statistics?{wrong}").status_code == 422

    place = built(viewer, ground, work, tmp_path / "day", {"filmed_from": "2026-05-04"})
    found = {row["id"]: row["filmed_at"] for row in rows(place, "vehicles.csv")}
    assert sorted(one[:10] for one in found.values()) == ["2026-05-03", "2026-05-03", "2026-05-04"]
    assert {row["filmed_at"] for row in rows(place, "measurements.csv")} == {"2026-05-04T00:00:00.140+02:00"}
    error = rows(place, "statistics/error_table.csv")
    assert {row["n"] for row in error if row["group"] == "overall"} == {"1"}
    first_page = words((place / "report.pdf").read_bytes())
    flat = " ".join(first_page.split())
    assert "Only: filmed from 2026-05-04" in flat
    assert "2026-05-03 23:59 to 2026-05-04 00:00 (Europe/Paris)" in flat
    assert verify_package(FolderFiles(place)).ok


def after_a_pause(n: int) -> int:
    """Time stamps of a frame a second: five, fifty minutes of nothing, then the others."""
    return int((n if n < 5 else 2996 + n) / TICKS)


@pytest.mark.dialect
def test_a_pause_in_a_recording_is_in_every_time(
    operator: Client,
    reviewer: Client,
    viewer: Client,
    services: Services,
    survey_id: int,
    work: Callable[[], list[Job]],
    tmp_path: Path,
) -> None:
    """A pass begins when its frame was filmed: on screen, in a selection, behind another, in the package."""
    spec = Spec("pause.mp4", pts_of=after_a_pause, count=12, size=QVGA)
    recording_id = add_recording(operator, services, survey_id, write(tmp_path / spec.name, spec))
    assert viewer.seen(f"/recordings/{recording_id}")["duration_s"] == pytest.approx(3008.0)
    with services.writing() as session:  # as an earlier version stored it
        session.execute(text("UPDATE recordings SET duration_s = :mean_s"), {"mean_s": 3007.0 * 12 / 11})
    for _ in range(2):
        correct_durations(services)
        assert viewer.seen(f"/recordings/{recording_id}")["duration_s"] == pytest.approx(3008.0)
    with services.reading() as session:
        events = [one.after or {} for one in events_of(session, survey_id) if one.entity == "recording"]
    told = [one["duration_s"] for one in events if "duration_s" in one]
    assert told == pytest.approx([3008.0, 3008.0])  # as it was read, and as it was corrected, once
    ground = lay_ground(services, survey_id, recording_id)
    rule = {"name": "Rouen", "version": 1, "sampling": {"free_flowing_s": 1.5}}
    rule["version"] = viewer.seen(f"/surveys/{survey_id}")["version"]
    assert operator.put(f"/surveys/{survey_id}", rule).status_code == 200
    start = {"local": "2026-05-03T08:10:00", "time_zone": "Europe/Paris"}
    assert operator.put(f"/recordings/{recording_id}", {"start": start}).status_code == 200
    cars = []
    for first, height in ((0, 1.31), (4, 1.32), (8, 1.33), (9, 1.34)):
        known = {"manufacturer_height_m": height, "first_frame": first, "last_frame": 10}
        cars.append(add_vehicle(operator, recording_id, direction="right", **known)["id"])
        made = measure(operator, cars[-1], frame=10)
        reviewer.made(f"/measurements/{made['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    seen = [viewer.seen(f"/vehicles/{car}") for car in cars]
    assert [one["first_s"] for one in seen] == [0.0, 4.0, 3004.0, 3005.0]
    clocks = ["08:10:00", "08:10:04", "09:00:04", "09:00:05"]
    times = [f"2026-05-03T{clock}.000+02:00" for clock in clocks]
    assert [one["filmed_at"] for one in seen] == times
    assert [one["in_sample"] for one in seen] == [True, True, True, False]  # the last is 1 s behind
    for hours, found in (("hour_to=9", 2), ("hour_from=9", 1), ("", 3)):
        assert viewer.seen(f"/statistics?survey={survey_id}&{hours}")["counted"]["vehicles"] == found

    place = built(viewer, ground, work, tmp_path / "package", {"hour_from": 9})
    assert [row["filmed_at"] for row in rows(place, "vehicles.csv")] == times
    assert verify_package(FolderFiles(place)).ok
    edit(place, "vehicles.csv", lambda row: row["first_frame"] == "9", first_s="3009.0", in_sample="true")
    reseal(place)
    assert "does not fit the frames around it" in str(verify_package(FolderFiles(place)).problem)


def test_hours_past_midnight_are_said_to_be_of_the_night_that_begins() -> None:
    """It said "filmed up to 2026-05-04", and the night that begins then ends on the 5th at 06:00."""
    first, last = date(2026, 5, 1), date(2026, 5, 4)
    said = {
        (first, last): "filmed in the nights that begin on 2026-05-01 to 2026-05-04, 22:00 to 06:00",
        (last, last): "filmed in the night that begins on 2026-05-04, 22:00 to 06:00",
        (first, None): "filmed in the nights that begin on 2026-05-01 or later, 22:00 to 06:00",
        (None, last): "filmed in the nights that begin on 2026-05-04 or earlier, 22:00 to 06:00",
        (None, None): "filmed between 22:00 and 06:00",  # any night: packages before said so, and it was true
    }
    assert {days: selection_words(Selection(*days, 22, 6)) for days in said} == said
    evening = Selection(None, last, 22, None)
    assert selection_words(evening) == "filmed up to 2026-05-04; filmed between 22:00 and 24:00"
    with speaking("fr"):
        assert selection_words(Selection(first, last, 22, 6)) == (
            "filmé dans les nuits qui commencent du 01/05/2026 au 04/05/2026, de 22:00 à 06:00"
        )
