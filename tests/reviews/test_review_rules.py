"""Reviews: never one's own, a rejection goes back with its reason, a fix is a new revision, counts follow."""

from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sightline.export.measured import measured_in, statistics_of
from sightline.export.report.package_facts import report_facts
from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.services import Services
from sightline.measurements import store as measurements_store
from sightline.quality.repeats.query import measurements_to_click_again
from sightline.results.measured_columns_query import load_measured_columns
from sightline.reviews import order_query
from sightline.reviews.lots.query import waiting_measurements
from sightline.reviews.lots.service import _groups
from sightline.reviews.order_query import standing_order
from tests.scans.test_scan_again import in_survey
from tests.support import scans_samples
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, clicks, lay_ground, measure, pixel
from tests.support.packages import edit, reseal, rows, written

pytestmark = pytest.mark.dialect


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def vehicle_id(operator: Client, ground: Ground) -> int:
    return int(add_vehicle(operator, ground.recording_id)["id"])


def judge(client: Client, measurement: dict[str, Any], verdict: str, **more: Any) -> Any:
    body = {"revision": measurement["revision"], "verdict": verdict, **more}
    return client.post(f"/measurements/{measurement['id']}/reviews", body)


def test_nobody_reviews_their_own(reviewer: Client, admin: Client, ground: Ground, vehicle_id: int) -> None:
    own = measure(reviewer, vehicle_id)
    refused = judge(reviewer, own, "accepted")
    assert refused.status_code == 403 and "own" in error_of(refused)
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert [item["mine"] for item in queue] == [True]
    assert judge(admin, own, "accepted").json()["review"]["verdict"] == "accepted"
    assert reviewer.seen(f"/surveys/{ground.survey_id}/review-queue") == []


def test_a_verdict_given_meanwhile_is_a_conflict_and_is_not_overwritten(
    operator: Client, reviewer: Client, admin: Client, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    assert judge(admin, made, "rejected", reason="mirror", seen="to_review").status_code == 201
    late = judge(reviewer, made, "accepted", seen="to_review")
    assert late.status_code == 409 and "“rejected” meanwhile" in error_of(late)
    history = reviewer.seen(f"/measurements/{made['id']}/history")
    assert [one["verdict"] for one in history["reviews"]] == ["rejected"]
    assert judge(reviewer, made, "accepted", seen="rejected").status_code == 201


def test_a_verdict_like_the_one_that_was_seen_is_another_where_somebody_gave_it_since(
    operator: Client, reviewer: Client, admin: Client, vehicle_id: int
) -> None:
    """What is taken back is the verdict that was seen, not another of the same word."""
    made = measure(operator, vehicle_id)
    first = judge(reviewer, made, "rejected", reason="mirror").json()["review"]
    for verdict, reason in (("reopened", None), ("rejected", "mirror")):
        assert judge(admin, made, verdict, reason=reason).status_code == 201
    late = judge(reviewer, made, "reopened", seen="rejected", seen_at=first["at"])
    assert late.status_code == 409 and "“rejected” meanwhile" in error_of(late)
    history = reviewer.seen(f"/measurements/{made['id']}/history")
    assert [one["verdict"] for one in history["reviews"]] == ["rejected", "reopened", "rejected"]
    stands = history["revisions"][-1]["review"]
    assert judge(reviewer, made, "reopened", seen="rejected", seen_at=stands["at"]).status_code == 201


def test_points_stay_ones_own_when_somebody_else_withdraws_and_restores_them(
    operator: Client, reviewer: Client, admin: Client, vehicle_id: int
) -> None:
    own = measure(reviewer, vehicle_id)
    path = f"/measurements/{own['id']}"
    assert operator.delete(f"{path}?revision=1").status_code == 200
    back = operator.post(f"{path}/restore", {"revision": 2}).json()
    assert back["created_by"]["name"] == "Operator"
    assert judge(reviewer, back, "accepted").status_code == 403
    assert judge(admin, back, "accepted").status_code == 201


def test_who_restored_clicked_nothing_and_may_review_and_who_clicked_may_not(
    operator: Client, reviewer: Client, vehicle_id: int, ground: Ground
) -> None:
    made = measure(operator, vehicle_id)
    path = f"/measurements/{made['id']}"
    assert reviewer.delete(f"{path}?revision=1").status_code == 200
    back = reviewer.post(f"{path}/restore", {"revision": 2}).json()
    (item,) = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert not item["mine"] and item["judged"]["operator"]["name"] == "Operator"
    assert judge(reviewer, back, "accepted").status_code == 201


@pytest.mark.parametrize("entered", ["further frame", "inset"])
def test_what_somebody_entered_beside_anothers_points_is_not_theirs_to_review(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, entered: str
) -> None:
    """Nor that of who clicked the points, also once it was withdrawn and restored."""
    vehicle = add_vehicle(operator, ground.recording_id)
    made = measure(operator, vehicle["id"])
    points = {name: value for name, value in clicks().items() if name != "target"}
    further = {"frame": 7, "contact": pixel(0.9, 0.0, 0.0), "target_point": pixel(1.3, 0.2, 1.3)}
    more = {"more_frames": [further]} if entered == "further frame" else {"inset_m": 0.3, "u_inset_m": 0.05}
    path = f"/measurements/{made['id']}"
    changed = reviewer.put(path, {"revision": 1, **points, **more})
    assert changed.status_code == 200, changed.text
    assert judge(reviewer, changed.json(), "accepted").status_code == 403
    assert admin.delete(f"{path}?revision=2").status_code == 200
    back = admin.post(f"{path}/restore", {"revision": 3}).json()
    (item,) = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert item["mine"] and item["judged"]["operator"]["name"] == "Operator"
    assert judge(reviewer, back, "accepted").status_code == 403
    assert judge(admin, back, "accepted").status_code == 201


def test_each_thing_that_was_entered_stays_its_makers_when_another_enters_more(
    operator: Client, reviewer: Client, admin: Client, ground: Ground
) -> None:
    """A second frame by one and then an inset by another: neither accepts what is partly theirs."""
    vehicle = add_vehicle(operator, ground.recording_id)
    path = f"/measurements/{measure(operator, vehicle['id'])['id']}"
    points = {name: value for name, value in clicks().items() if name != "target"}
    further = {"frame": 7, "contact": pixel(0.9, 0.0, 0.0), "target_point": pixel(1.3, 0.2, 1.3)}
    of_two = {**points, "more_frames": [further]}
    assert reviewer.put(path, {"revision": 1, **of_two}).status_code == 200
    other = {**of_two, "inset_m": 0.3, "u_inset_m": 0.05}
    changed = admin.put(path, {"revision": 2, **other})
    assert changed.status_code == 200, changed.text
    assert [judge(who, changed.json(), "accepted").status_code for who in (reviewer, admin)] == [403, 403]


@pytest.mark.parametrize("given", ["further frame", "contact", "target_point"])
def test_what_stands_of_ones_own_beside_anothers_of_the_same_kind_is_not_ones_own_to_review(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, given: str
) -> None:
    """A further frame by one and a second by another; or the points by one, of which another moved one."""
    vehicle = add_vehicle(operator, ground.recording_id)
    giver = operator if given == "further frame" else reviewer
    made = measure(giver, vehicle["id"], inset_m=None, u_inset_m=None)
    points = {name: made[name] for name in ("frame", "contact", "target_point")}
    further = [
        {"frame": n, "contact": pixel(x_m, 0.0, 0.0), "target_point": pixel(x_m + 0.4, 0.2, 1.3)}
        for n, x_m in ((6, 0.6), (7, 0.9))
    ]
    moved = {"contact": pixel(0.25, 0.0, 0.0), "target_point": pixel(0.6, 0.0, 1.25)}
    if given == "further frame":
        first = {"revision": 1, **points, "more_frames": further[:1]}
        made = reviewer.put(f"/measurements/{made['id']}", first).json()
        then = {**points, "more_frames": further}
    else:
        then = {**points, given: moved[given]}
    changed = admin.put(f"/measurements/{made['id']}", {"revision": made["revision"], **then})
    assert changed.status_code == 200, changed.text
    queue = f"/surveys/{ground.survey_id}/review-queue"
    assert [who.seen(queue)[0]["mine"] for who in (reviewer, admin)] == [True, True]
    assert [judge(who, changed.json(), "accepted").status_code for who in (reviewer, admin)] == [403, 403]


def test_further_frames_that_are_gone_are_nobodys_and_who_restored_them_gave_none(
    operator: Client, reviewer: Client, admin: Client, ground: Ground
) -> None:
    made = measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    points = {name: value for name, value in clicks().items() if name != "target"}
    further = {"frame": 7, "contact": pixel(0.9, 0.0, 0.0), "target_point": pixel(1.3, 0.2, 1.3)}
    path = f"/measurements/{made['id']}"
    assert reviewer.put(path, {"revision": 1, **points, "more_frames": [further]}).status_code == 200
    assert admin.delete(f"{path}?revision=2").status_code == 200
    assert admin.post(f"{path}/restore", {"revision": 3}).status_code == 200
    queue = f"/surveys/{ground.survey_id}/review-queue"
    assert [who.seen(queue)[0]["mine"] for who in (reviewer, admin)] == [True, False]
    gone = operator.put(path, {"revision": 4, **points})
    assert gone.status_code == 200, gone.text
    assert [who.seen(queue)[0]["mine"] for who in (reviewer, admin)] == [False, False]


@pytest.mark.parametrize("given", ["further frame", "inset", "sigma_px"])
def test_what_somebody_entered_stays_theirs_when_another_moves_the_points(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, given: str
) -> None:
    """The operator's points, the reviewer's second frame, then the admin's points with that frame."""
    made = measure(operator, add_vehicle(operator, ground.recording_id)["id"], inset_m=None, u_inset_m=None)
    points = {name: made[name] for name in ("frame", "contact", "target_point")}
    further = {"frame": 7, "contact": pixel(0.9, 0.0, 0.0), "target_point": pixel(1.3, 0.2, 1.3)}
    more: dict[str, Any] = {
        "further frame": {"more_frames": [further]},
        "inset": {"inset_m": 0.3, "u_inset_m": 0.05},
        "sigma_px": {"sigma_px": 0.3},
    }[given]
    path = f"/measurements/{made['id']}"
    assert reviewer.put(path, {"revision": 1, **points, **more}).status_code == 200
    moved = {**points, "contact": pixel(0.25, 0.0, 0.0), "target_point": pixel(0.6, 0.0, 1.25)}
    changed = admin.put(path, {"revision": 2, **moved, **more})
    assert changed.status_code == 200, changed.text
    queue = f"/surveys/{ground.survey_id}/review-queue"
    assert [who.seen(queue)[0]["mine"] for who in (operator, reviewer, admin)] == [False, True, True]
    assert [judge(who, changed.json(), "accepted").status_code for who in (reviewer, admin)] == [403, 403]


@pytest.mark.parametrize("given", [{"sigma_px": 0.3}, {"target": "headlight"}])
def test_another_click_sigma_or_target_is_not_for_who_gave_it_to_review(
    operator: Client, reviewer: Client, admin: Client, vehicle_id: int, given: dict[str, Any]
) -> None:
    made = measure(operator, vehicle_id)
    changed = reviewer.put(f"/measurements/{made['id']}", {"revision": 1, **clicks(), **given})
    assert changed.status_code == 200, changed.text
    assert judge(reviewer, changed.json(), "accepted").status_code == 403
    assert judge(admin, changed.json(), "accepted").status_code == 201


@pytest.mark.once
def test_what_was_withdrawn_or_deleted_is_restored_before_it_is_changed(
    operator: Client, reviewer: Client, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    points = {name: value for name, value in clicks().items() if name != "target"}
    assert operator.delete(f"/measurements/{made['id']}?revision=1").status_code == 200
    changed = operator.put(f"/measurements/{made['id']}", {"revision": 2, **points})
    assert changed.status_code == 409 and "withdrawn" in error_of(changed)
    assert operator.post(f"/measurements/{made['id']}/restore", {"revision": 2}).status_code == 200
    assert operator.delete(f"/vehicles/{vehicle_id}").status_code == 204
    for answer in (
        operator.put(f"/measurements/{made['id']}", {"revision": 3, **points}),
        judge(reviewer, {**made, "revision": 3}, "accepted"),
    ):
        assert answer.status_code == 409 and "deleted vehicle" in error_of(answer)


def test_a_fix_is_the_reviewers_revision_and_so_not_theirs_to_review(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id, inset_m=0.2, u_inset_m=0.1)
    points = {"contact": pixel(0.2, 0.0, 0.0), "target_point": pixel(0.6, 0.2, 1.25)}
    fixed = judge(reviewer, made, "fixed", **points).json()
    assert (fixed["revision"], fixed["inset_m"]) == (2, 0.2)
    assert fixed["height_m"] == pytest.approx(1.25, abs=1e-9)
    assert fixed["review"]["verdict"] == "fixed" and fixed["created_by"]["name"] == "Reviewer"
    assert judge(reviewer, fixed, "accepted").status_code == 403
    assert judge(reviewer, made, "accepted").status_code == 409
    assert judge(operator, fixed, "accepted").status_code == 403


def test_rejected_work_goes_back_until_there_is_a_new_revision(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    silent = judge(reviewer, made, "rejected", reason="  ")
    assert silent.status_code == 422 and "reason" in error_of(silent)
    assert judge(reviewer, made, "rejected", reason="The contact is on the kerb.").status_code == 201
    assert operator.seen(f"/vehicles/{vehicle_id}")["state"] == "rejected"
    counts = operator.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["rejected"], counts["to_review"]) == (1, 0)
    again = operator.put(f"/measurements/{made['id']}", {**clicks(1.25), "revision": 1}).json()
    assert again["review"]["verdict"] == "to_review"
    assert operator.seen(f"/vehicles/{vehicle_id}")["state"] == "partial"
    counts = operator.seen(f"/surveys/{ground.survey_id}")["counts"]
    assert (counts["rejected"], counts["to_review"]) == (0, 1)
    history = operator.seen(f"/measurements/{made['id']}/history")
    assert [(one["verdict"], one["revision"]) for one in history["reviews"]] == [("rejected", 1)]


@pytest.mark.once
def test_reopened_waits_for_a_reviewer_again(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    assert judge(reviewer, made, "reopened").status_code == 409
    assert judge(reviewer, made, "accepted").status_code == 201
    assert judge(reviewer, made, "reopened", reason="Looked again.").status_code == 201
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue?state=to_review")
    assert [item["measurement"]["id"] for item in queue] == [made["id"]]
    assert "measurements" not in queue[0]["vehicle"]


@pytest.mark.once
def test_a_fix_needs_points_and_only_a_fix_has_them(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    assert "points" in error_of(judge(reviewer, made, "fixed"))
    same = judge(reviewer, made, "fixed", contact=made["contact"], target_point=made["target_point"])
    assert same.status_code == 422 and "Nothing was changed" in error_of(same)
    with_points = judge(reviewer, made, "accepted", contact=[1.0, 2.0], target_point=[1.0, 2.0])
    assert with_points.status_code == 422 and "fix" in error_of(with_points)
    assert operator.seen(f"/measurements/{made['id']}")["revision"] == 1


def test_three_targets_make_a_vehicle_measured_and_their_reviews_accept_it(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    states = []
    made = []
    for target in ("roof", "driver_eye", "taillight"):
        made.append(measure(operator, vehicle_id, target=target))
        states.append(operator.seen(f"/vehicles/{vehicle_id}")["state"])
    assert states == ["partial", "partial", "measured"]
    for one in made:
        judge(reviewer, one, "accepted")
    assert operator.seen(f"/vehicles/{vehicle_id}")["state"] == "accepted"
    assert operator.seen(f"/surveys/{ground.survey_id}")["counts"]["vehicles_measured"] == 1


def test_the_queue_comes_in_pages_in_the_order_of_the_vehicles(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int
) -> None:
    other = int(add_vehicle(operator, ground.recording_id)["id"])
    made = [measure(operator, one, target=of) for of in ("roof", "taillight") for one in (other, vehicle_id)]
    order = [made[1], made[3], made[0], made[2]]
    path = f"/surveys/{ground.survey_id}/review-queue"

    def ids(query: str) -> list[int]:
        return [item["measurement"]["id"] for item in reviewer.seen(f"{path}?{query}")]

    assert ids("limit=3") == [one["id"] for one in order[:3]]
    assert ids(f"after={order[0]['id']}&limit=2") == [one["id"] for one in order[1:3]]
    # What left the queue meanwhile still marks the place.
    assert judge(reviewer, order[1], "accepted").status_code == 201
    assert ids(f"after={order[1]['id']}") == [one["id"] for one in order[2:]]
    assert ids(f"measurement={order[3]['id']}") == [order[3]["id"]]
    assert ids(f"measurement={order[1]['id']}") == []
    assert reviewer.get(f"{path}?after=99999").status_code == 404


def test_points_are_mine_whoever_restored_them(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, vehicle_id: int
) -> None:
    own = measure(reviewer, vehicle_id, inset_m=None, u_inset_m=None)
    assert operator.delete(f"/measurements/{own['id']}?revision=1").status_code == 200
    assert operator.post(f"/measurements/{own['id']}/restore", {"revision": 2}).status_code == 200
    path = f"/surveys/{ground.survey_id}/review-queue"
    mine = [item["mine"] for who in (reviewer, operator, admin) for item in who.seen(path)]
    assert mine == [True, False, False]
    others = {**clicks(1.25), "contact": pixel(0.25, 0.0, 0.0)}
    assert operator.put(f"/measurements/{own['id']}", {**others, "revision": 3}).status_code == 200
    assert [item["mine"] for item in reviewer.seen(path)] == [False]


def test_the_plan_of_the_survey_says_what_is_clicked_again_before_it_is_judged(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, vehicle_id: int
) -> None:
    made = measure(operator, vehicle_id)
    address = f"/surveys/{ground.survey_id}/review-plan"
    now = reviewer.seen(address)
    assert reviewer.put(address, {**now, "blind_one_in": 1}).status_code == 403
    assert admin.put(address, {**now, "blind_one_in": 1}).json()["blind_one_in"] == 1
    assert admin.put(address, {**now, "blind_one_in": 2}).status_code == 409

    def blind(client: Client) -> list[bool]:
        queue = client.seen(f"/surveys/{ground.survey_id}/review-queue")
        return [item["judged"]["blind"] for item in queue]

    assert (blind(reviewer), blind(operator)) == ([True], [False])
    refused = judge(reviewer, made, "accepted")
    assert refused.status_code == 422 and "blind repeat" in error_of(refused)
    measure(reviewer, vehicle_id, repeat_of=made["id"], inset_m=None, u_inset_m=None)
    assert (blind(reviewer), blind(admin)) == ([False], [True])
    assert judge(reviewer, made, "accepted").status_code == 201
    hidden = measure(operator, vehicle_id, target="taillight")
    assert judge(reviewer, hidden, "rejected", reason="It is hidden.").status_code == 201


def test_what_is_most_likely_wrong_comes_first_and_ones_own_last(
    operator: Client, reviewer: Client, ground: Ground
) -> None:
    known = {"manufacturer_height_m": 1.2, "u_manufacturer_height_m": 0.01}
    heights = (1.2, 1.2, 1.6, 1.2)
    made = []
    for n, height in enumerate(heights):
        vehicle = add_vehicle(operator, ground.recording_id, last_frame=8 + n % 2, **known)
        who = reviewer if n == 0 else operator
        made.append(measure(who, vehicle["id"], **clicks(height)))
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    ids = [item["measurement"]["id"] for item in queue]
    assert ids == [made[n]["id"] for n in (2, 1, 3, 0)]
    first = queue[0]["judged"]
    assert "far_from_maker" in first["signs"] and "new_operator" in first["signs"]
    assert first["error_m"] == pytest.approx(0.4, abs=1e-6) and first["U95_error_m"] > 0.0
    work = reviewer.seen(f"/surveys/{ground.survey_id}/review-work")
    assert work == {"to_review": 3, "own": 1, "in_lots": 0, "accepted": 0, "rejected": 0, "heights": 4}
    page = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue?limit=2&after={ids[0]}")
    assert [item["measurement"]["id"] for item in page] == ids[1:3]


@pytest.mark.once
def test_a_rejected_height_raises_no_doubt(operator: Client, reviewer: Client, vehicle_id: int) -> None:
    """It counts nowhere: neither is it doubted, nor is another one because of it."""
    measure(operator, vehicle_id, **clicks(1.3))
    eye = measure(operator, vehicle_id, **clicks(1.5, target="driver_eye"))
    doubts = operator.seen(f"/vehicles/{vehicle_id}")["doubts"]
    assert ("driver_eye", "above_roof") in {(one["target"], one["kind"]) for one in doubts}
    assert judge(reviewer, eye, "rejected", reason="Head rest.").status_code == 201
    assert operator.seen(f"/vehicles/{vehicle_id}")["doubts"] == []


def test_who_clicked_the_points_that_stand_is_their_operator_everywhere(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Not who restored them or changed another field; who fixed them. In statistics, queue, lots, repeats and
    package.
    """
    restored, fixed, kept = (
        measure(operator, add_vehicle(operator, ground.recording_id)["id"], **clicks(1.3 + n / 50))
        for n in range(3)
    )
    assert reviewer.delete(f"/measurements/{restored['id']}?revision=1").status_code == 200
    again = reviewer.post(f"/measurements/{restored['id']}/restore", {"revision": 2})
    assert again.status_code == 200, again.text
    olga, rene = kept["created_by"]["id"], again.json()["created_by"]["id"]
    points = {"contact": fixed["contact"], "target_point": clicks(1.3)["target_point"]}
    assert judge(reviewer, fixed, "fixed", **points, reason="Too high.").status_code == 201
    whose = {restored["id"]: olga, fixed["id"]: rene, kept["id"]: olga}

    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue?state=all")
    assert {one["measurement"]["id"]: one["judged"]["operator"]["id"] for one in queue} == whose

    asked: list[list[int]] = []
    real = order_query.review_order

    def noted(*given: Any) -> Any:
        asked.append(given[3].tolist())
        return real(*given)

    monkeypatch.setattr(order_query, "review_order", noted)
    with services.reading() as session:
        found = load_measured_columns(session, [ground.survey_id])
        standing_order(session, ground.survey_id, None)
        of_lots = {row.series_id: row.operator_id for row in waiting_measurements(session, ground.survey_id)}
        own = [
            sorted(measurements_to_click_again(session, ground.survey_id, person_id=one, only_own=True)[0])
            for one in (olga, rene)
        ]
    assert dict(zip(found.measurement_id.tolist(), found.operator_id.tolist(), strict=True)) == whose
    assert asked == [list(whose.values())]
    assert of_lots == {one: whose[one] for one in (restored["id"], kept["id"])}
    assert own == [[one for one in whose if whose[one] == person] for person in (olga, rene)]

    place = written(services, ground.survey_id, tmp_path / "package")
    assert {int(row["id"]): int(row["operator_id"]) for row in rows(place, "measurements.csv")} == whose
    checked = verify_package(FolderFiles(place))
    assert checked.ok, checked.problem
    assert measured_in(FolderFiles(place)).operator_id.tolist() == list(whose.values())
    edit(place, "measurements.csv", lambda row: row["id"] == str(restored["id"]), operator_id=str(rene))
    reseal(place)
    assert "the operator of" in str(verify_package(FolderFiles(place)).problem)


def test_a_height_is_of_the_day_when_its_points_were_clicked_everywhere(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Not of the day of restoring; a fix is of its own. In filter, queue, package and report."""
    days = [datetime(2025, 5, day, 12, tzinfo=UTC) for day in (1, 2)]

    def on(day: datetime) -> None:
        monkeypatch.setattr(measurements_store, "now", lambda: day)

    on(days[0])
    restored, fixed = (
        measure(operator, add_vehicle(operator, ground.recording_id)["id"], **clicks(1.3 + n / 50))
        for n in range(2)
    )
    assert judge(reviewer, restored, "accepted").status_code == 201
    on(days[1])
    path = f"/measurements/{restored['id']}"
    assert operator.delete(f"{path}?revision=1").status_code == 200
    assert operator.post(f"{path}/restore", {"revision": 2}).status_code == 200
    points = {"contact": fixed["contact"], "target_point": clicks(1.3)["target_point"]}
    assert judge(reviewer, fixed, "fixed", **points).status_code == 201

    def counted(day: str) -> int:
        asked = f"/statistics?survey={ground.survey_id}&first_day={day}&last_day={day}"
        return int(reviewer.seen(asked)["counted"]["measurements"])

    assert [counted("2025-05-01"), counted("2025-05-02")] == [1, 1]
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue?state=all")
    told = {one["measurement"]["id"]: one["judged"]["clicked_at"][:10] for one in queue}
    assert told == {restored["id"]: "2025-05-01", fixed["id"]: "2025-05-02"}

    place = written(services, ground.survey_id, tmp_path / "package")
    files = FolderFiles(place)
    in_package = {int(row["id"]): row["clicked_at"][:10] for row in rows(place, "measurements.csv")}
    assert in_package == told
    assert np.diff(measured_in(files).day).tolist() == [1]
    facts = report_facts(files, statistics_of(files), {})
    assert (facts.first_day, facts.last_day) == (days[0].date(), days[1].date())
    checked = verify_package(files)
    assert checked.ok, checked.problem
    moved = {"clicked_at": "2025-05-02T12:00:00.000000Z"}
    edit(place, "measurements.csv", lambda row: row["id"] == str(restored["id"]), **moved)
    reseal(place)
    assert "clicked_at of" in str(verify_package(FolderFiles(place)).problem)


def test_a_lot_by_day_takes_what_was_clicked_on_it(
    operator: Client,
    reviewer: Client,
    ground: Ground,
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clicked = datetime(2025, 5, 1, 12, tzinfo=UTC)
    monkeypatch.setattr(measurements_store, "now", lambda: clicked)
    made = measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    monkeypatch.setattr(measurements_store, "now", lambda: clicked + timedelta(days=1))
    assert operator.delete(f"/measurements/{made['id']}?revision=1").status_code == 200
    assert operator.post(f"/measurements/{made['id']}/restore", {"revision": 2}).status_code == 200
    with services.reading() as session:
        (group,) = _groups(session, ground.survey_id, ["day"])
    assert group[0] == {"day": "2025-05-01"}


def test_heights_of_line_scans_stand_in_the_reviewers_queue(
    services: Services, reviewer: Client, operator: Client, admin: Client, survey_id: int, ground: Ground
) -> None:
    """Those of frames and of line scans are one queue, with one way to judge them and one history."""
    with services.writing() as session:
        made = in_survey(survey_id)
        seen = scans_samples.measured(session, made)
        rod = scans_samples.rod(session, made, seen.scan_id)
        roof = scans_samples.tall(session, made, seen.vehicle_id, rod)
        scans_samples.tall(session, made, seen.vehicle_id, rod, target="other")
    filmed = measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    path, review = f"/surveys/{survey_id}/review-queue", f"/measurements/{roof.id}/reviews"
    found = reviewer.seen(path)
    assert {(one["measurement"]["target"], one["vehicle"]["scan_name"]) for one in found} == {
        (filmed["target"], None),
        ("roof", "Gate"),
        ("other", "Gate"),
    }
    (item,) = reviewer.seen(f"{path}?measurement={roof.id}")
    one = item["measurement"]
    assert (one["scan_id"], one["vehicle_id"]) == (seen.scan_id, seen.vehicle_id)
    assert one["height_m"] == pytest.approx(1.4) and one["U95_height_m"] > 0
    assert not one["mine"] and not item["mine"]
    assert reviewer.seen(f"/surveys/{survey_id}/review-work")["to_review"] == 3
    # what is clicked again, or corrected, is of frames alone
    plan = f"/surveys/{survey_id}/review-plan"
    admin.put(plan, {**admin.seen(plan), "blind_one_in": 1})
    drawn = {one["measurement"]["id"]: one["judged"]["blind"] for one in reviewer.seen(path)}
    assert [number for number, blind in drawn.items() if blind] == [filmed["id"]]
    points = {"contact": [1.0, 2.0], "target_point": [3.0, 4.0]}
    fixed = reviewer.post(review, {"revision": 1, "verdict": "fixed", **points})
    assert fixed.status_code == 422 and "measure it again under Line scans" in error_of(fixed)
    answered = reviewer.made(review, {"revision": 1, "verdict": "accepted", "seen": "to_review"})
    assert (answered["scan_id"], answered["review"]["verdict"]) == (seen.scan_id, "accepted")
    work = reviewer.seen(f"/surveys/{survey_id}/review-work")
    assert (work["to_review"], work["accepted"], work["rejected"], work["heights"]) == (2, 1, 0, 3)
    left = [one["measurement"]["id"] for one in reviewer.seen(path)]
    assert (
        len(left) == 2 and reviewer.seen(f"{path}?after={left[0]}&limit=1")[0]["measurement"]["id"] == left[1]
    )
    (accepted,) = reviewer.seen(f"{path}?state=accepted")
    assert accepted["measurement"]["id"] == roof.id
    reviewer.made(review, {"revision": 1, "verdict": "reopened"})
    assert len(reviewer.seen(path)) == 3
    history = reviewer.seen(f"/measurements/{roof.id}/history")
    assert [one["revision"] for one in history["revisions"]] == [1]
    assert [one["verdict"] for one in history["reviews"]] == ["accepted", "reopened"]
