"""Heights in line scans computed again with those of recordings: one computing, one table, one undo."""

import shutil
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest

from sightline.errors import Damaged
from sightline.export.verify.package import verify_package
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.scans.again.service import AllAnswers, changes_to_come, compute_again
from sightline.scans.heights.csv import LINE_HEIGHTS
from sightline.scans.heights.verify import line_height_put_back
from sightline.scans.records import ScanMeasurement
from sightline.scans.verify import check_verdicts_gone_over
from tests.support import samples, scans_samples
from tests.support.app import Client, error_of
from tests.support.ground import add_vehicle, lay_ground, measure
from tests.support.packages import edit, reseal, rows, written
from tests.support.samples import Sample

pytestmark = pytest.mark.dialect
Work = Callable[[], list[Job]]
FOCAL_PX, MIDDLE, CAMERA_M, DISTANCE_M = 280.0, 120.0, 1.2, 3.0
USUAL, SMALL, LARGE = 0.3, 0.305, 0.9
STANDS = [(distance, height) for distance in (2.6, 4.5) for height in (0.0, 0.5, 1.0, 1.5)]
SLOPE = (1.45 - CAMERA_M) / (DISTANCE_M + USUAL)  # of the ray to the target that is clicked


def row_of(distance_m: float, height_m: float) -> float:
    """By similar triangles: a level camera 1.2 m above the road."""
    return MIDDLE - FOCAL_PX * (height_m - CAMERA_M) / distance_m


def rod(revision: int = 0, scale: float = 1.0) -> dict[str, Any]:
    """A rod whose every length is `scale` times as long: so is the height of the camera, and of all else."""
    marks = [
        {"distance_m": d * scale, "height_m": h * scale, "row_px": row_of(d, h), "line": 300 * d}
        for d, h in STANDS
    ]
    return {"marks": marks, "sigma_px": 0.5, "u_distance_m": 0.005, "revision": revision}


def expected_m(inset_m: float) -> float:
    """The ray from the camera to the target, carried on to the inset behind the contact."""
    return CAMERA_M + SLOPE * (DISTANCE_M + inset_m)


def click(client: Client, vehicle_id: int, revision: int = 0, **changed: Any) -> dict[str, Any]:
    """A roof 1.45 m above the road where it lies 0.3 m behind its contact."""
    contact = {"contact_line": 1400.0, "contact_row_px": row_of(DISTANCE_M, 0.0)}
    point = {"target_line": 1600.0, "target_row_px": row_of(DISTANCE_M + USUAL, 1.45)}
    body = {"target": "roof", "revision": revision, **contact, **point, **changed}
    made: dict[str, Any] = client.made(f"/scan-vehicles/{vehicle_id}/heights", body)
    return made


def now(client: Client, one: dict[str, Any]) -> dict[str, Any]:
    """The newest revision of the same vehicle and target."""
    history = client.seen(f"/scan-vehicles/{one['vehicle_id']}/heights")
    found: dict[str, Any] = [other for other in history if other["target"] == one["target"]][-1]
    return found


def judge(client: Client, one: dict[str, Any], verdict: str, **more: Any) -> None:
    body = {"revision": one["revision"], "verdict": verdict, **more}
    client.made(f"/measurements/{one['id']}/reviews", body)


def say_inset(client: Client, survey_id: int, inset_m: float, name: str = "roof_unknown") -> None:
    survey = client.seen(f"/surveys/{survey_id}")
    words = {word: survey[word] for word in ("name", "site", "description", "version")}
    insets = {name: {"inset_m": inset_m, "u_inset_m": 0.1, "note": "told in a test"}}
    answer = client.put(f"/surveys/{survey_id}", json={**words, "insets": insets})
    assert answer.status_code == 200, answer.text


def stale_of(client: Client, survey_id: int) -> dict[str, Any]:
    found: dict[str, Any] = client.seen(f"/surveys/{survey_id}/computings")["out_of_date"]
    return found


def done(work: Work) -> Any:
    (job,) = work()
    assert job.state == "done", job.error
    return job.result


def again(client: Client, survey_id: int, work: Work) -> Any:
    client.made(f"/surveys/{survey_id}/computings")
    return done(work)


def undo(client: Client, computing_id: int, work: Work) -> Any:
    client.made(f"/computings/{computing_id}/undo")
    return done(work)


def in_survey(survey_id: int) -> Sample:
    """What a sample of scans needs to know of where it goes."""
    first = SimpleNamespace(id=1)
    return cast(Sample, SimpleNamespace(survey=SimpleNamespace(id=survey_id), olga=first))


@pytest.fixture
def vehicle(services: Services, operator: Client) -> ScanMeasurement:
    """A measured vehicle of a line scan whose camera 1 is calibrated."""
    with services.writing() as session:
        made: ScanMeasurement = scans_samples.measured(session, samples.sample(session))
    operator.put(f"/scans/{made.scan_id}/line-pose", rod())
    return made


def test_another_inset_is_computed_as_new_revisions_old_beside_new(
    operator: Client, viewer: Client, vehicle: ScanMeasurement, work: Work
) -> None:
    usual = click(operator, vehicle.vehicle_id)
    own = click(operator, vehicle.vehicle_id, target="other", inset_m=0.2, u_inset_m=0.1)
    assert (usual["inset_from"], own["inset_from"]) == ("usual", "own")
    assert again(operator, vehicle.survey_id, work) == {"computing_id": None, "heights": 0}
    say_inset(operator, vehicle.survey_id, LARGE)
    assert now(operator, usual)["revision"] == 1  # never silently
    stale = stale_of(viewer, vehicle.survey_id)
    assert (stale["heights"], stale["in_line_scans"], stale["causes"]) == (1, 1, {"inset": 1})
    listed = viewer.seen(f"/scans/{vehicle.scan_id}/heights")
    assert {one["target"]: one["older"] for one in listed} == {"roof": True, "other": False}
    result = again(operator, vehicle.survey_id, work)
    assert (result["heights"], result["to_review"]) == (1, 1)
    after = now(operator, usual)
    assert (after["revision"], after["inset_m"], after["inset_from"]) == (2, LARGE, "usual")
    assert not after["older"]
    assert after["height_m"] == pytest.approx(expected_m(LARGE), abs=1e-6)
    assert after["computing_id"] == result["computing_id"] and now(operator, own)["revision"] == 1
    (row,) = viewer.seen(f"/computings/{result['computing_id']}")["listed"]
    assert (row["scan_id"], row["measurement_id"]) == (vehicle.scan_id, after["id"])
    assert (row["height_before_m"], row["height_m"]) == (usual["height_m"], after["height_m"])
    assert row["moved_by_u"] == pytest.approx(abs(row["change_m"]) / usual["u_height_m"])
    assert row["distance_m"] == pytest.approx(DISTANCE_M, abs=1e-6) and row["y_m"] is None
    assert stale_of(viewer, vehicle.survey_id)["heights"] == 0


def test_another_calibration_moves_every_height_of_its_scan_alone(
    operator: Client, services: Services, vehicle: ScanMeasurement, work: Work
) -> None:
    """Every length of the rod 2 % longer: so is every height, but for the inset, which stays."""
    one = click(operator, vehicle.vehicle_id, inset_m=0.0, u_inset_m=0.1)
    with services.writing() as session:
        other = scans_samples.measured(session, in_survey(vehicle.survey_id))
    operator.put(f"/scans/{other.scan_id}/line-pose", rod())
    apart = click(operator, other.vehicle_id)
    operator.put(f"/scans/{vehicle.scan_id}/line-pose", rod(1, scale=1.02))
    stale = stale_of(operator, vehicle.survey_id)
    assert (stale["heights"], stale["causes"]) == (1, {"pose": 1})
    again(operator, vehicle.survey_id, work)
    after = now(operator, one)
    assert after["height_m"] == pytest.approx(1.02 * one["height_m"], abs=1e-5) and not after["older"]
    assert now(operator, apart)["revision"] == 1


def test_an_eye_follows_the_inset_of_the_side_that_was_said(
    operator: Client, vehicle: ScanMeasurement, work: Work
) -> None:
    refused = operator.post(
        f"/scan-vehicles/{vehicle.vehicle_id}/heights",
        {
            **{"target": "driver_eye", "contact_line": 1400.0, "contact_row_px": row_of(3.0, 0.0)},
            **{"target_line": 1600.0, "target_row_px": row_of(3.3, 1.2), "revision": 0},
        },
    )
    assert refused.status_code == 422
    eye = click(operator, vehicle.vehicle_id, target="driver_eye", side="far")
    assert (eye["inset_m"], eye["inset_from"], eye["side"]) == (1.15, "usual", "far")
    say_inset(operator, vehicle.survey_id, 0.5, "driver_eye_near")
    assert stale_of(operator, vehicle.survey_id)["heights"] == 0
    say_inset(operator, vehicle.survey_id, 1.25, "driver_eye_far")
    again(operator, vehicle.survey_id, work)
    after = now(operator, eye)
    assert (after["inset_m"], after["side"]) == (1.25, "far")
    assert after["height_m"] == pytest.approx(expected_m(1.25), abs=1e-6)


def test_only_what_moved_by_more_than_its_u_loses_its_verdict(
    operator: Client, reviewer: Client, vehicle: ScanMeasurement, services: Services, work: Work
) -> None:
    accepted = click(operator, vehicle.vehicle_id)
    rejected = click(operator, vehicle.vehicle_id, target="taillight")
    judge(reviewer, accepted, "accepted")
    judge(reviewer, rejected, "rejected", reason="the mirror")
    say_inset(operator, vehicle.survey_id, SMALL)
    say_inset(operator, vehicle.survey_id, 0.055, "taillight")
    assert again(operator, vehicle.survey_id, work)["to_review"] == 0
    verdicts = [now(operator, one)["review"]["verdict"] for one in (accepted, rejected)]
    assert verdicts == ["accepted", "rejected"]
    assert now(operator, accepted)["review"]["reviewer"]["name"] == "Reviewer"
    assert now(operator, accepted)["created_by"]["name"] == "Operator"
    # statistics and the queue read verdicts by ways of their own
    counted = {one["target"]: one for one in operator.seen(statistics_of(vehicle))["heights"]}
    assert (counted["roof"]["n"], counted["taillight"]["rejected"]) == (1, 1)
    queue = f"/surveys/{vehicle.survey_id}/review-queue"
    assert operator.seen(queue) == []
    say_inset(operator, vehicle.survey_id, LARGE)
    assert again(operator, vehicle.survey_id, work)["to_review"] == 1
    (waiting,) = operator.seen(queue)
    assert (waiting["measurement"]["id"], waiting["mine"]) == (now(operator, accepted)["id"], True)
    judge(reviewer, now(operator, accepted), "accepted")
    assert now(operator, accepted)["review"]["verdict"] == "accepted"
    with services.reading() as session:
        assert verify_records(session).ok


def statistics_of(vehicle: ScanMeasurement) -> str:
    return f"/surveys/{vehicle.survey_id}/scan-statistics"


def test_whoever_computes_again_may_review_what_others_clicked(
    operator: Client, reviewer: Client, vehicle: ScanMeasurement, work: Work
) -> None:
    theirs = click(operator, vehicle.vehicle_id)
    mine = click(reviewer, vehicle.vehicle_id, target="taillight")
    operator.put(f"/scans/{vehicle.scan_id}/line-pose", rod(1, scale=1.05))
    again(reviewer, vehicle.survey_id, work)
    verdict = {"revision": now(reviewer, mine)["revision"], "verdict": "accepted"}
    own = reviewer.post(f"/measurements/{mine['id']}/reviews", verdict)
    assert own.status_code == 403
    judge(reviewer, now(reviewer, theirs), "accepted")


def test_frames_and_lines_are_one_computing_undone_as_a_whole_but_for_what_was_changed_since(
    operator: Client, services: Services, survey_id: int, recording_id: int, work: Work
) -> None:
    ground = lay_ground(services, survey_id, recording_id)
    with services.writing() as session:
        scanned = scans_samples.measured(session, in_survey(survey_id))
    operator.put(f"/scans/{scanned.scan_id}/line-pose", rod())
    roof = {"target": "roof", "inset_m": None, "u_inset_m": None}
    filmed = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **roof)
    same = click(operator, scanned.vehicle_id)
    changed = click(operator, scanned.vehicle_id, target="taillight")
    gone = click(operator, scanned.vehicle_id, target="headlight")
    for name in ("roof_unknown", "taillight", "headlight"):
        say_inset(operator, survey_id, LARGE, name)
    stale = stale_of(operator, survey_id)
    assert (stale["heights"], stale["in_line_scans"], stale["causes"]) == (4, 3, {"inset": 4})
    made = again(operator, survey_id, work)
    assert made["heights"] == 4
    listed = operator.seen(f"/computings/{made['computing_id']}")["listed"]
    assert sorted(one["scan_id"] is None for one in listed) == [False, False, False, True]
    click(operator, scanned.vehicle_id, 2, target="taillight", inset_m=0.1, u_inset_m=0.05)
    heights = f"/scan-vehicles/{scanned.vehicle_id}/heights"
    operator.delete(heights, params={"target": "headlight", "revision": 2})
    result = undo(operator, made["computing_id"], work)
    assert (result["heights"], result["kept"]) == (2, 1)
    assert now(operator, same)["height_m"] == same["height_m"]
    assert operator.seen(f"/measurements/{filmed['id']}")["height_m"] == filmed["height_m"]
    assert now(operator, changed)["inset_m"] == 0.1 and now(operator, gone)["withdrawn"]
    again_undone = operator.post(f"/computings/{made['computing_id']}/undo")
    assert again_undone.status_code == 409 and "already undone" in error_of(again_undone)


def test_what_changes_while_the_job_computes_is_computed_with_what_holds_at_the_end(
    operator: Client, services: Services, vehicle: ScanMeasurement
) -> None:
    one = click(operator, vehicle.vehicle_id)
    answers = AllAnswers()
    say_inset(operator, vehicle.survey_id, LARGE)
    told: list[float] = []
    with services.reading() as session:
        found = changes_to_come(session, vehicle.survey_id, answers, tell=told.append)
    assert len(found) == 1 and told == sorted(told) and told[-1] >= 0.5
    say_inset(operator, vehicle.survey_id, 0.6)
    with services.writing() as session:
        compute_again(session, vehicle.survey_id, answers=answers, actor=None)
    assert now(operator, one)["height_m"] == pytest.approx(expected_m(0.6), abs=1e-6)


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the package is that the first test made."""
    return tmp_path_factory.mktemp("computed") / "export"


@pytest.fixture
def computed(
    operator: Client,
    reviewer: Client,
    vehicle: ScanMeasurement,
    services: Services,
    work: Work,
    kept: Path,
    tmp_path: Path,
) -> Path:
    """The package of a survey with an accepted height that hardly moved, then did, and an undo."""
    if kept.exists():
        return shutil.copytree(kept, tmp_path / "export")
    one = click(operator, vehicle.vehicle_id)
    judge(reviewer, one, "accepted")
    say_inset(operator, vehicle.survey_id, SMALL)
    again(operator, vehicle.survey_id, work)
    say_inset(operator, vehicle.survey_id, LARGE)
    undo(operator, again(operator, vehicle.survey_id, work)["computing_id"], work)
    with services.reading() as session:
        verified = verify_records(session)
    assert verified.ok, verified.problem
    return shutil.copytree(written(services, vehicle.survey_id, kept), tmp_path / "export")


def test_the_package_tells_of_it_and_is_verified(computed: Path) -> None:
    found = verify_package(FolderFiles(computed))
    assert found.ok, found.problem
    told = rows(computed, "computings.csv")
    assert [(row["kind"], row["heights"], row["to_review"], row["undoes"]) for row in told] == [
        ("asked", "1", "0", ""),
        ("asked", "1", "1", ""),
        ("undo", "1", "0", "2"),
    ]
    mine = rows(computed, "line_heights.csv")
    assert [(row["computing_id"], row["verdict_of_id"], row["verdict"]) for row in mine] == [
        ("", "", "accepted"),
        ("1", "1", "accepted"),
        ("2", "", "to_review"),
        ("3", "1", "accepted"),
    ]
    assert [row["inset_from"] for row in mine] == ["usual"] * 4
    assert len({row["created_by_id"] for row in mine}) == 1


@pytest.mark.once
def test_the_package_marks_lines_heights_that_are_out_of_date_and_a_forged_mark_is_found(
    operator: Client, services: Services, vehicle: ScanMeasurement, work: Work, tmp_path: Path
) -> None:
    roof = click(operator, vehicle.vehicle_id)
    own = click(operator, vehicle.vehicle_id, target="taillight", inset_m=0.0, u_inset_m=0.1)

    def marked(name: str) -> dict[int, str]:
        place = written(services, vehicle.survey_id, tmp_path / name)
        found = verify_package(FolderFiles(place))
        assert found.ok, found.problem
        return {int(row["id"]): row["out_of_date"] for row in rows(place, "line_heights.csv")}

    assert marked("before") == {roof["revision_id"]: "", own["revision_id"]: ""}
    say_inset(operator, vehicle.survey_id, LARGE)
    assert marked("inset") == {roof["revision_id"]: "inset", own["revision_id"]: ""}
    operator.put(f"/scans/{vehicle.scan_id}/line-pose", rod(1, scale=1.02))
    assert marked("rod") == {roof["revision_id"]: "pose; inset", own["revision_id"]: "pose"}
    assert stale_of(operator, vehicle.survey_id)["in_line_scans"] == 2
    again(operator, vehicle.survey_id, work)
    assert set(marked("again").values()) == {""}
    place = tmp_path / "rod"
    edit(place, "line_heights.csv", lambda row: row["id"] == str(own["revision_id"]), out_of_date="")
    reseal(place)
    told = verify_package(FolderFiles(place))
    assert told.problem is not None
    assert told.problem.startswith(f"line_heights.csv: the out-of-date mark of {own['revision_id']}")


def _a_verdict_goes_over(place: Path) -> str:
    changed = {"verdict_of_id": "1", "verdict": "accepted"}
    given = rows(place, "line_heights.csv")[0]
    changed |= {name: given[name] for name in ("reviewer_id", "reviewed_at")}
    edit(place, "line_heights.csv", lambda row: row["id"] == "3", **changed)
    return "verdict_of_id of row 3"


def _another_computing(place: Path) -> str:
    edit(place, "line_heights.csv", lambda row: row["id"] == "3", computing_id="1")
    return "computing_id of row 3"


def _fewer_heights(place: Path) -> str:
    edit(place, "computings.csv", lambda row: row["id"] == "2", heights="0")
    return "differs from its audit event"


@pytest.mark.once
@pytest.mark.parametrize("forge", [_a_verdict_goes_over, _another_computing, _fewer_heights])
def test_what_is_forged_of_it_is_found(computed: Path, forge: Callable[[Path], str]) -> None:
    said = forge(computed)
    reseal(computed)
    found = verify_package(FolderFiles(computed))
    assert not found.ok and said in str(found.problem), found.problem


def _revision(number: int, height_m: str = "", **more: str) -> dict[str, str]:
    told = {"id": str(10 + number), "vehicle_id": "1", "target": "roof", "revision": str(number)}
    told |= {"height_m": height_m, "u_height_m": "0.02", "computing_id": "", "verdict_of_id": ""}
    told |= {"contact_line": "5", "contact_row_px": "900", "target_line": "9", "target_row_px": "400"}
    told |= {"sigma_px": "1", "pose_id": "1", "status": "ok"}
    return {**told, **more}


GONE_OVER: dict[str, tuple[dict[str, str], bool]] = {
    "hardly moved": ({"height_m": "1.51", "computing_id": "1"}, True),
    "moved": ({"height_m": "1.53", "computing_id": "1"}, False),
    "put back": ({"height_m": "1.53", "computing_id": "2"}, True),
    "clicked": ({"height_m": "1.51", "computing_id": ""}, False),
    "clicked beside": ({"height_m": "1.50", "computing_id": "", "target_row_px": "401"}, False),
    "clicked as it was": ({"height_m": "1.50", "computing_id": ""}, True),
    "of another target": ({"height_m": "1.51", "computing_id": "1", "verdict_of_id": "99"}, False),
}


@pytest.mark.once
@pytest.mark.parametrize("name", GONE_OVER)
def test_a_verdict_goes_over_only_to_a_height_that_hardly_moved_or_was_put_back(name: str) -> None:
    more, holds = GONE_OVER[name]
    listed = {11: _revision(1, "1.50"), 12: _revision(2, **{"verdict_of_id": "11", **more})}
    reviews = {1: {"height_id": "11", "verdict": "accepted"}}
    kinds = {"1": "asked", "2": "undo"}

    def check(reviews: dict[int, dict[str, str]]) -> None:
        check_verdicts_gone_over(LINE_HEIGHTS, listed, "height_id", reviews, kinds, line_height_put_back)

    if holds:
        check(reviews)
        return
    with pytest.raises(Damaged, match="another measurement"):
        check(reviews)
    if name == "moved":  # a rejection holds however far the height moves: the clicks are the same
        check({1: {"height_id": "11", "verdict": "rejected"}})
