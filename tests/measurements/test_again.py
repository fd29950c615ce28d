"""Heights computed again: new revisions, old beside new, verdicts kept where little moved, undone whole."""

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.errors import Stopped
from sightline.export.verify.package import verify_package
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import JobContext
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.scans.again import again_job, service
from tests.support.app import Client, error_of
from tests.support.ground import (
    CENTRE_M,
    Ground,
    add_pose,
    add_vehicle,
    flat_camera,
    measure,
)
from tests.support.packages import edit, reseal, rows, written

pytestmark = pytest.mark.dialect
Work = Callable[[], list[Job]]
DISTANCE_M = -CENTRE_M[1]
LARGE, SMALL = 0.5, 0.121
#: A roof that is given the survey's usual inset (0.12 m, u 0.05 m).
ROOF = {"target": "roof", "inset_m": None, "u_inset_m": None}


def say_inset(client: Client, survey_id: int, inset_m: float, target: str = "roof_unknown") -> None:
    survey = client.seen(f"/surveys/{survey_id}")
    words = {name: survey[name] for name in ("name", "site", "description", "version")}
    insets = {target: {"inset_m": inset_m, "u_inset_m": 0.05, "note": "told in a test"}}
    answer = client.put(f"/surveys/{survey_id}", json={**words, "insets": insets})
    assert answer.status_code == 200, answer.text


def judge(client: Client, one: dict[str, Any], verdict: str, **more: Any) -> None:
    client.made(
        f"/measurements/{one['id']}/reviews", {"revision": one["revision"], "verdict": verdict, **more}
    )


def again(client: Client, ground: Ground, work: Work) -> Any:
    """What the job answers."""
    client.made(f"/surveys/{ground.survey_id}/computings")
    (job,) = work()
    assert job.state == "done", job.error
    return job.result


def undo(client: Client, computing_id: int, work: Work) -> Any:
    client.made(f"/computings/{computing_id}/undo")
    (job,) = work()
    assert job.state == "done", job.error
    return job.result


def now(client: Client, one: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = client.seen(f"/measurements/{one['id']}")
    return found


def expected_m(one: dict[str, Any], inset_m: float) -> float:
    """By similar triangles: the ray from the camera through the side plane, carried on by the inset."""
    uncorrected: float = one["uncorrected_height_m"]
    distance_m = DISTANCE_M + one["y_m"]
    return CENTRE_M[2] + (uncorrected - CENTRE_M[2]) * (distance_m + inset_m) / distance_m


def test_another_inset_is_computed_as_new_revisions_old_beside_new(
    operator: Client, viewer: Client, ground: Ground, work: Work
) -> None:
    usual = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    own = measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    lamp = measure(
        operator, add_vehicle(operator, ground.recording_id)["id"], **{**ROOF, "target": "taillight"}
    )
    path = f"/surveys/{ground.survey_id}/computings"
    assert viewer.seen(path)["out_of_date"]["heights"] == 0
    assert again(operator, ground, work) == {"computing_id": None, "heights": 0}
    assert viewer.seen(path)["computings"] == []
    say_inset(operator, ground.survey_id, LARGE)
    assert now(operator, usual)["revision"] == 1  # never silently
    stale = viewer.seen(path)["out_of_date"]
    assert (stale["heights"], stale["causes"], stale["waiting"]) == (1, {"inset": 1}, 0)
    assert viewer.post(path).status_code == 403
    result = again(operator, ground, work)
    after = now(operator, usual)
    assert (after["revision"], after["inset_m"], after["inset_from"]) == (2, LARGE, "usual")
    assert after["height_m"] == pytest.approx(expected_m(usual, LARGE), abs=1e-9)
    assert after["computing_id"] == result["computing_id"]
    assert [now(operator, one)["revision"] for one in (own, lamp)] == [1, 1]
    shown = viewer.seen(f"/computings/{result['computing_id']}")
    (row,) = shown["listed"]
    assert (row["measurement_id"], row["revision"]) == (usual["id"], 2)
    assert (row["height_before_m"], row["height_m"]) == (usual["height_m"], after["height_m"])
    assert row["change_m"] == pytest.approx(after["height_m"] - usual["height_m"])
    assert row["moved_by_u"] == pytest.approx(abs(row["change_m"]) / usual["u_height_m"])
    assert shown["computing"]["causes"] == {"inset": 1} and shown["undoable"] is None
    assert viewer.seen(path)["out_of_date"]["heights"] == 0


def test_each_height_out_of_date_is_named_with_its_causes_until_it_is_computed_again(
    operator: Client, viewer: Client, ground: Ground, work: Work
) -> None:
    survey = operator.seen(f"/surveys/{ground.survey_id}")
    words = {name: survey[name] for name in ("name", "site", "description")}
    path = f"/surveys/{ground.survey_id}"

    def drive(steering: str) -> None:
        traffic = {"traffic_side": "right", "steering_side": steering, "camera_place": "verge"}
        version = operator.seen(path)["version"]
        answer = operator.put(path, json={**words, "version": version, "traffic": traffic})
        assert answer.status_code == 200, answer.text

    drive("left")
    both = [add_vehicle(operator, ground.recording_id, direction="right")["id"] for _ in range(2)]
    eyes = [measure(operator, one, **{**ROOF, "target": "driver_eye"}) for one in both]
    roof = measure(operator, both[0], **ROOF)
    assert viewer.seen(f"{path}/computings")["out_of_date"]["measurements"] == {}
    drive("right")
    stale = viewer.seen(f"{path}/computings")["out_of_date"]
    assert stale["heights"] == 2
    assert stale["measurements"] == {str(one["id"]): ["side"] for one in eyes}
    say_inset(operator, ground.survey_id, LARGE)
    stale = viewer.seen(f"{path}/computings")["out_of_date"]
    assert stale["measurements"][str(roof["id"])] == ["inset"] and stale["heights"] == 3
    again(operator, ground, work)
    stale = viewer.seen(f"{path}/computings")["out_of_date"]
    assert (stale["heights"], stale["measurements"]) == (0, {})


def test_only_what_moved_by_more_than_its_u_loses_its_verdict(
    operator: Client, reviewer: Client, ground: Ground, work: Work
) -> None:
    made = [measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF) for _ in range(3)]
    accepted, rejected, waiting = made
    judge(reviewer, accepted, "accepted")
    judge(reviewer, rejected, "rejected", reason="the mirror")
    say_inset(operator, ground.survey_id, SMALL)
    assert again(operator, ground, work)["to_review"] == 0
    verdicts = [now(operator, one)["review"]["verdict"] for one in made]
    assert verdicts == ["accepted", "rejected", "to_review"]
    assert now(operator, accepted)["review"]["reviewer"]["name"] == "Reviewer"
    # statistics and the queue read verdicts by ways of their own
    counted = operator.seen(f"/statistics?survey={ground.survey_id}&state=accepted")["counted"]
    assert (counted["measurements"], counted["left_out"]["rejected"]) == (1, 1)
    queue = operator.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert [item["measurement"]["id"] for item in queue] == [waiting["id"]]
    say_inset(operator, ground.survey_id, LARGE)
    # rejected clicks are the same clicks: they stay rejected however far their height moves
    assert again(operator, ground, work)["to_review"] == 2
    verdicts = [now(operator, one)["review"]["verdict"] for one in made]
    assert verdicts == ["to_review", "rejected", "to_review"]
    judge(reviewer, now(operator, accepted), "accepted")
    assert now(operator, accepted)["review"]["verdict"] == "accepted"


def test_nobody_reviews_their_own_clicks_and_whoever_computes_may_review_those_of_others(
    operator: Client, reviewer: Client, ground: Ground, work: Work
) -> None:
    mine = measure(reviewer, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    theirs = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    say_inset(operator, ground.survey_id, LARGE)
    again(reviewer, ground, work)
    assert now(operator, mine)["created_by"]["name"] == "Reviewer"
    assert now(operator, theirs)["created_by"]["name"] == "Operator"
    body = {"revision": 2, "verdict": "accepted"}
    assert reviewer.post(f"/measurements/{mine['id']}/reviews", body).status_code == 403
    assert reviewer.post(f"/measurements/{theirs['id']}/reviews", body).status_code == 201


def test_another_pose_moves_repeats_along_and_a_side_that_is_told_computes_eyes(
    operator: Client, reviewer: Client, ground: Ground, services: Services, work: Work
) -> None:
    vehicle = add_vehicle(operator, ground.recording_id, direction="right")["id"]
    roof = measure(operator, vehicle, **ROOF)
    repeat = measure(reviewer, vehicle, **ROOF, repeat_of=roof["id"])
    eye = measure(operator, vehicle, **{**ROOF, "target": "driver_eye"})
    assert eye["status"] == "not_measurable"
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    higher = -rotation @ np.array([CENTRE_M[0], CENTRE_M[1], CENTRE_M[2] + 0.1])
    pose_id = add_pose(
        services, ground.recording_id, ground.calibration_id, flat_camera(), translation_m=higher
    )
    stale = operator.seen(f"/surveys/{ground.survey_id}/computings")["out_of_date"]
    assert (stale["heights"], stale["causes"]["pose"]) == (3, 3)
    again(operator, ground, work)
    for one in (roof, repeat):
        after = now(operator, one)
        assert after["pose_id"] == pose_id
        # the whole scene is that much larger (1.6 m above the road instead of 1.5 m)
        ratio = (CENTRE_M[2] + 0.1) / CENTRE_M[2]
        assert after["uncorrected_height_m"] == pytest.approx(ratio * one["uncorrected_height_m"], abs=1e-9)
    assert now(operator, eye)["status"] == "not_measurable"
    survey = operator.seen(f"/surveys/{ground.survey_id}")
    words = {name: survey[name] for name in ("name", "site", "description", "version")}
    traffic = {"traffic_side": "right", "steering_side": "left", "camera_place": "verge"}
    operator.put(f"/surveys/{ground.survey_id}", json={**words, "traffic": traffic})
    (job,) = work()
    assert job.result and job.result["heights"] == 1
    assert now(operator, eye)["inset_m"] == 1.15
    newest = operator.seen(f"/surveys/{ground.survey_id}/computings")["computings"][0]
    assert (newest["kind"], newest["causes"]) == ("sides", {"side": 1})


def test_it_is_undone_as_a_whole_but_for_what_was_changed_since(
    operator: Client, reviewer: Client, ground: Ground, work: Work
) -> None:
    made = [measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF) for _ in range(4)]
    same, changed, judged, gone = made
    for one in (same, judged):
        judge(reviewer, one, "accepted")
    say_inset(operator, ground.survey_id, LARGE)
    first = again(operator, ground, work)["computing_id"]
    say_inset(operator, ground.survey_id, 0.6)
    second = again(operator, ground, work)["computing_id"]
    refused = operator.post(f"/computings/{first}/undo")
    assert refused.status_code == 409 and "undo that first" in error_of(refused)
    assert undo(operator, second, work)["kept"] == 0
    assert [now(operator, one)["inset_m"] for one in made] == [LARGE] * 4
    body = {name: changed[name] for name in ("frame", "target_point")}
    contact = [changed["contact"][0], changed["contact"][1] + 2]
    operator.put(f"/measurements/{changed['id']}", json={**body, "contact": contact, "revision": 4})
    judge(reviewer, now(operator, judged), "rejected", reason="the aerial")
    operator.delete(f"/measurements/{gone['id']}?revision=4")
    result = undo(operator, first, work)
    assert (result["heights"], result["kept"]) == (2, 1)
    assert [now(operator, one)["height_m"] for one in (same, judged)] == [
        same["height_m"],
        judged["height_m"],
    ]
    assert now(operator, same)["review"]["verdict"] == "accepted"
    assert now(operator, judged)["review"]["verdict"] == "rejected"
    assert now(operator, changed)["contact"] == contact and now(operator, gone)["withdrawn"]
    again_undone = operator.post(f"/computings/{first}/undo")
    assert again_undone.status_code == 409 and "already undone" in error_of(again_undone)
    assert operator.post(f"/computings/{first + 2}/undo").status_code == 409  # the undo itself
    assert operator.seen(f"/surveys/{ground.survey_id}/computings")["out_of_date"]["heights"] == 2


def test_what_changes_while_the_job_computes_is_computed_with_what_holds_at_the_end(
    operator: Client, ground: Ground, services: Services
) -> None:
    one = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    answers = service.AllAnswers()
    say_inset(operator, ground.survey_id, LARGE)
    with services.reading() as session:
        assert len(service.changes_to_come(session, ground.survey_id, answers)) == 1
    say_inset(operator, ground.survey_id, 0.6)
    with services.writing() as session:
        service.compute_again(session, ground.survey_id, answers=answers, actor=None)
    assert now(operator, one)["height_m"] == pytest.approx(expected_m(one, 0.6), abs=1e-9)


def test_a_job_that_is_stopped_leaves_nothing(
    operator: Client, ground: Ground, services: Services, work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    say_inset(operator, ground.survey_id, LARGE)
    told: list[float] = []

    def stopped(context: JobContext, fraction: float, message: Said | None = None) -> None:
        told.append(fraction)
        if str(message or "").startswith("Saving"):
            raise Stopped("said", sentence="Stopped.")

    monkeypatch.setattr(again_job.JobContext, "progress", stopped)
    operator.made(f"/surveys/{ground.survey_id}/computings")
    (job,) = work()
    assert job.state == "cancelled" and told[0] == 0.0 and told[-1] == pytest.approx(0.9)
    assert now(operator, one)["revision"] == 1
    assert operator.seen(f"/surveys/{ground.survey_id}/computings")["computings"] == []


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the package is that the first test made."""
    return tmp_path_factory.mktemp("computed") / "export"


@pytest.fixture
def computed(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    work: Work,
    kept: Path,
    tmp_path: Path,
) -> Path:
    """The package of a survey with an accepted height that hardly moved, then one that did, and an undo."""
    if kept.exists():
        return shutil.copytree(kept, tmp_path / "export")
    one = measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    measure(operator, add_vehicle(operator, ground.recording_id)["id"], **ROOF)
    judge(reviewer, one, "accepted")
    say_inset(operator, ground.survey_id, SMALL)
    again(operator, ground, work)
    say_inset(operator, ground.survey_id, LARGE)
    undo(operator, again(operator, ground, work)["computing_id"], work)
    with services.reading() as session:
        verified = verify_records(session)
    assert verified.ok, verified.problem
    return shutil.copytree(written(services, ground.survey_id, kept), tmp_path / "export")


def test_the_package_tells_of_it_and_is_verified(computed: Path) -> None:
    found = verify_package(FolderFiles(computed))
    assert found.ok, found.problem
    told = rows(computed, "computings.csv")
    assert [(row["kind"], row["heights"], row["undoes"]) for row in told] == [
        ("asked", "2", ""),
        ("asked", "2", ""),
        ("undo", "2", "2"),
    ]
    assert [row["to_review"] for row in told] == ["0", "2", "0"]
    mine = [row for row in rows(computed, "revisions.csv") if row["measurement_id"] == "1"]
    assert [(row["computing_id"], row["verdict_of_revision"]) for row in mine] == [
        ("", ""),
        ("1", "1"),
        ("2", ""),
        ("3", "1"),
    ]
    assert [row["verdict"] for row in rows(computed, "measurements.csv")] == ["accepted", "to_review"]
    assert mine[0]["created_by_id"] == mine[-1]["created_by_id"]


def _a_verdict_goes_over(place: Path) -> str:
    moved = {"measurement_id": "1", "revision": "3"}
    edit(place, "revisions.csv", lambda row: moved.items() <= row.items(), verdict_of_revision="1")
    return "differs from its audit event"


def _another_maker(place: Path) -> str:
    edit(place, "revisions.csv", lambda row: row["computing_id"] == "2", computing_id="1")
    return "differs from its audit event"


def _fewer_to_review(place: Path) -> str:
    edit(place, "computings.csv", lambda row: row["id"] == "2", to_review="0")
    return "differs from its audit event"


@pytest.mark.once
@pytest.mark.parametrize("forge", [_a_verdict_goes_over, _another_maker, _fewer_to_review])
def test_what_is_forged_of_it_is_found(computed: Path, forge: Callable[[Path], str]) -> None:
    said = forge(computed)
    reseal(computed)
    found = verify_package(FolderFiles(computed))
    assert not found.ok and said in str(found.problem), found.problem


@pytest.mark.once
def test_the_package_marks_what_is_out_of_date_as_the_pages_do(
    operator: Client, viewer: Client, services: Services, ground: Ground, work: Work, tmp_path: Path
) -> None:
    path = f"/surveys/{ground.survey_id}"
    survey = operator.seen(path)
    words = {name: survey[name] for name in ("name", "site", "description")}

    def drive(steering: str) -> None:
        traffic = {"traffic_side": "right", "steering_side": steering, "camera_place": "verge"}
        version = operator.seen(path)["version"]
        assert operator.put(path, json={**words, "version": version, "traffic": traffic}).status_code == 200

    def marked(name: str) -> dict[int, str]:
        place = written(services, ground.survey_id, tmp_path / name)
        found = verify_package(FolderFiles(place))
        assert found.ok, found.problem
        assert list(rows(place, "measurements.csv")[0])[-3:] == ["out_of_date", "operator_id", "clicked_at"]
        marks = {int(row["id"]): row["out_of_date"] for row in rows(place, "measurements.csv")}
        again = {int(row["id"]): row["out_of_date"] for row in rows(place, "repeats.csv")}
        assert again == {repeat["id"]: marks[roof["id"]], withdrawn["id"]: ""}  # clicked alike, marked alike
        return marks

    drive("left")
    both = [add_vehicle(operator, ground.recording_id, direction="right")["id"] for _ in range(2)]
    eye, gone = (measure(operator, one, **{**ROOF, "target": "driver_eye"}) for one in both)
    roof = measure(operator, both[0], **ROOF)
    own = measure(operator, both[1])
    repeat, withdrawn = (measure(operator, both[0], **ROOF, repeat_of=roof["id"]) for _ in range(2))
    assert set(marked("before").values()) == {""}
    operator.delete(f"/measurements/{withdrawn['id']}?revision=1")
    operator.delete(f"/measurements/{gone['id']}?revision=1")
    drive("right")
    say_inset(operator, ground.survey_id, LARGE)
    assert marked("stale") == {eye["id"]: "side", gone["id"]: "", roof["id"]: "inset", own["id"]: ""}
    add_pose(services, ground.recording_id, ground.calibration_id, flat_camera())
    said = {eye["id"]: "pose; side", gone["id"]: "", roof["id"]: "pose; inset", own["id"]: "pose"}
    assert marked("posed") == said
    shown = viewer.seen(f"{path}/computings")["out_of_date"]["measurements"]
    assert {int(id_): "; ".join(causes) for id_, causes in shown.items()} == {
        id_: causes for id_, causes in (said | {repeat["id"]: said[roof["id"]]}).items() if causes
    }
    again(operator, ground, work)
    assert set(marked("again").values()) == {""}

    for path, id_, forged in (
        ("measurements.csv", roof["id"], ""),
        ("measurements.csv", own["id"], "inset"),
        ("measurements.csv", gone["id"], "side"),
        ("repeats.csv", repeat["id"], ""),
        ("repeats.csv", withdrawn["id"], "pose"),
    ):
        place = tmp_path / f"forged-{id_}"
        shutil.copytree(tmp_path / "posed", place)
        edit(place, path, lambda row: row["id"] == str(id_), out_of_date=forged)  # noqa: B023
        reseal(place)
        told = verify_package(FolderFiles(place))
        assert not told.ok and told.problem is not None
        assert told.problem.startswith(f"{path}: the out-of-date mark of {id_}")
