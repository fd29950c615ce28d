"""Heights in a line scan through the API: the rod's calibration, two clicks, revisions, withdrawal."""

from pathlib import Path
from typing import Any

import pytest
from httpx2 import Response

from sightline.infra.services import Services
from sightline.scans.records import ScanMeasurement
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from tests.measurements.test_second_frame import exported, rewritten
from tests.support import samples, scans_samples
from tests.support.app import Client, error_of
from tests.support.mutations import checked

FOCAL_PX, MIDDLE, CAMERA_M = 280.0, 120.0, 1.2
STANDS = [(distance, height) for distance in (2.6, 4.5) for height in (0.0, 0.5, 1.0, 1.5)]


def row_of(distance_m: float, height_m: float) -> float:
    """By similar triangles: a level camera 1.2 m above the road."""
    return MIDDLE - FOCAL_PX * (height_m - CAMERA_M) / distance_m


def rod(revision: int = 0, **changed: Any) -> dict[str, Any]:
    marks = [{"distance_m": d, "height_m": h, "row_px": row_of(d, h), "line": 300 * d} for d, h in STANDS]
    return {"marks": marks, "sigma_px": 0.5, "u_distance_m": 0.005, "revision": revision, **changed}


def clicks(distance_m: float = 3.0, height_m: float = 1.45, **changed: Any) -> dict[str, Any]:
    """A roof 0.3 m behind its contact."""
    contact = {"contact_line": 1400.0, "contact_row_px": row_of(distance_m, 0.0)}
    point = {"target_line": 1600.0, "target_row_px": row_of(distance_m + 0.3, height_m)}
    return {"target": "roof", **contact, **point, **changed}


def accept(client: Client, one: dict[str, Any]) -> Response:
    """The answer to accepting this revision."""
    seen = {"revision": one["revision"], "verdict": "accepted"}
    return client.post(f"/measurements/{one['id']}/reviews", seen)


@pytest.fixture
def vehicle(services: Services) -> ScanMeasurement:
    """A measured vehicle of a line scan of 256 rows that was read."""
    with services.writing() as session:
        made: ScanMeasurement = scans_samples.measured(session, samples.sample(session))
    return made


def test_from_the_rod_to_a_height_and_back(
    operator: Client, viewer: Client, vehicle: ScanMeasurement
) -> None:
    scan, heights = f"/scans/{vehicle.scan_id}", f"/scan-vehicles/{vehicle.vehicle_id}/heights"
    refused = operator.post(heights, {**clicks(), "revision": 0})
    assert refused.status_code == 422 and "Calibrate height" in error_of(refused)
    assert viewer.seen(f"{scan}/line-pose") == {"current": None, "history": []}
    given = rod()
    seen = viewer.made(f"{scan}/line-pose/preview", {k: v for k, v in given.items() if k != "revision"})
    assert seen["camera_height_m"] == pytest.approx(CAMERA_M, abs=1e-6) and len(seen["residuals_px"]) == 8
    few = viewer.made(f"{scan}/line-pose/preview", {"marks": given["marks"][:3]})
    assert few["status"] == "not_solvable" and "too few" in few["reason"]["message"]
    stored = operator.put(f"{scan}/line-pose", given).json()
    assert stored["revision"] == 1 and stored["solved"] == seen
    again = operator.put(f"{scan}/line-pose", given)
    assert again.status_code == 409 and "meanwhile" in error_of(again)

    contact = {name: value for name, value in clicks().items() if not name.startswith("target_")}
    alone = viewer.made(f"{scan}/line-height", contact)
    assert alone["status"] == "contact" and alone["distance_m"] == pytest.approx(3.0, abs=1e-6)
    assert alone["ladder"][1]["row_px"] == pytest.approx(row_of(3.3, 0.5), abs=1e-4)
    live = viewer.made(f"{scan}/line-height", clicks())
    made = operator.made(heights, {**clicks(), "revision": 0})
    assert made["height_m"] == pytest.approx(1.45, abs=1e-6) and made["inset_m"] == 0.3
    shared = ("height_m", "u_height_m", "U95_height_m", "distance_m", "U95_distance_m", "budget", "flags")
    assert {name: made[name] for name in shared} == {name: live[name] for name in shared}
    assert sum(one["u_m"] ** 2 for one in made["budget"]) == pytest.approx(made["u_height_m"] ** 2)

    # another rod: the height keeps the old one until it is stored again
    operator.put(f"{scan}/line-pose", rod(1, u_distance_m=0.02))
    assert viewer.seen(f"{scan}/heights")[0]["older"]
    second = operator.made(heights, {**clicks(), "revision": 1})
    assert not second["older"] and second["u_height_m"] > made["u_height_m"]
    taken = operator.delete(heights, params={"target": "roof", "revision": 2}).json()
    assert (taken["withdrawn"], taken["revision"], taken["height_m"]) == (True, 3, second["height_m"])
    assert operator.delete(heights, params={"target": "roof", "revision": 3}).status_code == 409
    assert [one["withdrawn"] for one in viewer.seen(heights)] == [False, False, True]
    beside = operator.made(heights, {**clicks(contact_line=3000.0), "revision": 3})
    assert beside["flags"][0]["code"] == "line-height-beside-vehicle"
    kept = operator.delete(scan)
    assert kept.status_code == 409 and "worked on" in error_of(kept)


def test_a_height_is_reviewed_by_somebody_else(
    operator: Client, reviewer: Client, viewer: Client, vehicle: ScanMeasurement
) -> None:
    """Append-only verdicts on what was seen; clicks stay those of who placed them, whoever computes again."""
    scan, heights = f"/scans/{vehicle.scan_id}", f"/scan-vehicles/{vehicle.vehicle_id}/heights"
    operator.put(f"{scan}/line-pose", rod())
    first = reviewer.made(heights, {**clicks(), "revision": 0})
    assert (first["review"]["verdict"], first["mine"]) == ("to_review", True)
    own = accept(reviewer, first)
    assert own.status_code == 403 and "your own measurement" in error_of(own)
    # computed again with another rod by the operator: the reviewer's clicks all the same
    operator.put(f"{scan}/line-pose", rod(1, u_distance_m=0.02))
    again = operator.made(heights, {**clicks(), "revision": 1})
    assert reviewer.seen(f"{scan}/heights")[0]["mine"]
    assert accept(reviewer, again).status_code == 403

    made = operator.made(heights, {**clicks(height_m=1.46, contact_line=1401.0), "revision": 2})
    verdict = f"/measurements/{made['id']}/reviews"
    seen = {"revision": made["revision"]}
    counts = viewer.seen(scan)["counts"]
    assert (counts["heights"], counts["heights_to_review"]) == (1, 1)
    stale = accept(reviewer, again)
    assert stale.status_code == 409 and "changed this measurement" in error_of(stale)
    why = reviewer.post(verdict, {**seen, "verdict": "rejected", "reason": " "})
    assert why.status_code == 422 and "needs a reason" in error_of(why)
    early = reviewer.post(verdict, {**seen, "verdict": "reopened"})
    assert early.status_code == 409 and "already waiting for a review" in error_of(early)
    rejected = reviewer.made(
        verdict, {**seen, "verdict": "rejected", "reason": "A rack.", "seen": "to_review"}
    )
    assert (rejected["review"]["verdict"], rejected["review"]["reason"]) == ("rejected", "A rack.")
    late = reviewer.post(verdict, {**seen, "verdict": "accepted", "seen": "to_review"})
    assert late.status_code == 409
    survey = f"/surveys/{vehicle.survey_id}"
    asked = f"{survey}/scan-statistics"
    (row,) = viewer.seen(asked)["heights"]
    assert (row["n"], row["to_review"], row["rejected"], row["mean_m"]) == (0, 0, 1, None)
    reviewer.made(verdict, {**seen, "verdict": "reopened"})
    (row,) = viewer.seen(asked)["heights"]
    assert (row["n"], row["to_review"]) == (0, 1)
    (row,) = viewer.seen(f"{asked}?accepted_only=false")["heights"]
    assert (row["n"], row["to_review"]) == (1, 1)
    progress = viewer.seen(survey)["scans"]
    assert "Review 1 of 1 height." in [one["message"] for one in progress["summary"]]
    assert progress["heights_to_review"] == 1
    reviewer.made(verdict, {**seen, "verdict": "accepted"})
    (row,) = viewer.seen(asked)["heights"]
    assert (row["n"], row["to_review"], row["mean_m"]) == (1, 0, made["height_m"])

    taken = operator.delete(heights, params={"target": "roof", "revision": 3}).json()
    gone = accept(reviewer, taken)
    assert gone.status_code == 409 and "nothing to review" in error_of(gone)
    assert viewer.seen(asked)["heights"] == [] and viewer.seen(scan)["counts"]["heights"] == 0


def test_where_the_driver_sits_is_not_for_who_said_it_to_review(
    operator: Client, reviewer: Client, admin: Client, vehicle: ScanMeasurement
) -> None:
    heights = f"/scan-vehicles/{vehicle.vehicle_id}/heights"
    operator.put(f"/scans/{vehicle.scan_id}/line-pose", rod())
    operator.made(heights, {**clicks(target="driver_eye", side="near"), "revision": 0})
    other = reviewer.made(heights, {**clicks(target="driver_eye", side="far"), "revision": 1})
    assert accept(reviewer, other).status_code == 403
    assert accept(admin, other).status_code == 201


@pytest.mark.parametrize("verdict", ["accepted", "rejected"])
def test_undo_brings_the_verdict_back_with_the_height(
    operator: Client,
    reviewer: Client,
    services: Services,
    vehicle: ScanMeasurement,
    verdict: str,
    tmp_path: Path,
) -> None:
    heights = f"/scan-vehicles/{vehicle.vehicle_id}/heights"
    operator.put(f"/scans/{vehicle.scan_id}/line-pose", rod())
    first = operator.made(heights, {**clicks(), "revision": 0})
    judged = reviewer.made(
        f"/measurements/{first['id']}/reviews",
        {"revision": 1, "verdict": verdict, "reason": "The tyre is hidden."},
    )
    moved = operator.made(heights, {**clicks(height_m=1.5), "revision": 1})
    assert moved["review"]["verdict"] == "to_review"
    back = operator.made(heights, {**clicks(), "revision": 2})
    assert (back["revision"], back["height_m"]) == (3, first["height_m"])
    assert back["review"] == judged["review"]
    nearly = operator.made(heights, {**clicks(height_m=1.4501), "revision": 3})
    assert nearly["review"]["verdict"] == "to_review"

    taken = operator.delete(heights, params={"target": "roof", "revision": 4}).json()
    assert taken["review"]["verdict"] == "to_review"
    assert operator.made(heights, {**clicks(), "revision": 5})["review"] == judged["review"]
    files = exported(services, vehicle.survey_id, tmp_path / "export")
    assert checked(files).ok, checked(files).problem
    forged = rewritten(files, "line_heights.csv", "verdict_of_id", str(moved["revision_id"]))
    assert not checked(forged).ok


@pytest.mark.parametrize("verdict", ["accepted", "rejected"])
def test_undo_brings_the_verdict_back_with_the_motion(
    viewer: Client, reviewer: Client, services: Services, tmp_path: Path, verdict: str
) -> None:
    with services.writing() as session:
        one = samples.sample(session)
        first = scans_samples.measured(session, one)
    address = f"/scan-vehicles/{first.vehicle_id}"

    def next_revision(**changed: Any) -> ScanMeasurement:
        with services.writing() as session:
            values = scans_samples.values(**changed)
            return append_scan_measurement(session, first.vehicle_id, values, actor=one.olga.id)

    told = {"verdict": verdict, "reason": "Two vehicles."}
    judged = reviewer.made(f"/scan-measurements/{first.id}/review", told)["measurement"]["review"]
    moved = next_revision(cause="boundaries", front_line_1=990.0, length_m=4.79)
    assert moved.review.verdict == "to_review" and moved.verdict_of_id is None
    back = next_revision(cause="back")
    assert (back.review.verdict, back.verdict_of_id, back.judged_id) == (verdict, first.id, first.id)
    assert viewer.seen(address)["vehicle"]["measurement"]["review"] == judged
    events = viewer.seen(f"/audit?survey_id={first.survey_id}&entity=scan_measurement")
    assert [one["after"]["verdict_of_id"] for one in events if one["entity_id"] == back.id] == [first.id]
    # figures that moved although the boundaries did not are not what was judged
    assert next_revision(cause="again", u_speed_mps=0.012).review.verdict == "to_review"
    # whoever judged and then places the wheels does not judge them by it
    own = next_revision(cause="wheels", placed_by=judged["reviewer"]["id"])
    assert own.review.verdict == "to_review"
    next_revision(cause="back")
    reviewer.made(f"/scan-measurements/{next_revision(cause='back').id}/review", {"verdict": "reopened"})
    assert next_revision(cause="back").review.verdict == "reopened"

    files = exported(services, first.survey_id, tmp_path / "export")
    assert checked(files).ok, checked(files).problem
    assert not checked(rewritten(files, "scan_measurements.csv", "verdict_of_id", str(moved.id))).ok


def test_what_cannot_be_is_said_in_words(operator: Client, viewer: Client, vehicle: ScanMeasurement) -> None:
    scan, heights = f"/scans/{vehicle.scan_id}", f"/scan-vehicles/{vehicle.vehicle_id}/heights"
    one_stand = rod(marks=rod()["marks"][:4])
    refused = operator.put(f"{scan}/line-pose", one_stand)
    assert refused.status_code == 422 and "one distance" in error_of(refused)
    outside = operator.put(f"{scan}/line-pose", rod(marks=[{**one, "row_px": 900} for one in rod()["marks"]]))
    assert outside.status_code == 422 and "outside the strip" in error_of(outside)
    operator.put(f"{scan}/line-pose", rod())
    skyward = operator.made(heights, {**clicks(contact_row_px=row_of(3.0, 1.3)), "revision": 0})
    assert (
        skyward["status"] == "not_measurable"
        and skyward["reason"]["code"] == "line-height-contact-above-horizon"
    )
    assert skyward["height_m"] is None and skyward["budget"] == []
    stale = operator.post(heights, {**clicks(), "revision": 0})
    assert stale.status_code == 409 and "meanwhile" in error_of(stale)
    off = operator.post(heights, {**clicks(contact_row_px=5000.0), "revision": 1})
    assert off.status_code == 422 and "outside the strip" in error_of(off)
    crooked = viewer.made(
        f"{scan}/line-pose/preview", {"marks": [{**rod()["marks"][0], "row_px": 300.0}, *rod()["marks"][1:]]}
    )
    assert "check the distances" in crooked["warnings"][0]["message"]
