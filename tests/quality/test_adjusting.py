"""A pose adjusted by the survey's own traffic: seen, put in force by a person, taken back as a whole.

The vehicles are drawn with the true camera of `tests.support.ground`; the pose in force is told another
height of it, as a tape read wrongly gives it.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sightline.adjustment.observed import Known
from sightline.export.verify.package import verify_package
from sightline.geometry.documents import pose_to_dict
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.measurements.again.store import add_computing
from sightline.poses import store
from sightline.quality.adjusting.observations import observations_of
from sightline.vehicles.catalogue.records import CatalogueRow
from sightline.vehicles.catalogue.store import add_catalogue_row
from tests.support.app import Client, error_of
from tests.support.ground import (
    CENTRE_M,
    Ground,
    add_vehicle,
    lay_ground,
    measure,
    pixel,
    pose_above_road,
)
from tests.support.packages import rows, written

Work = Callable[[], list[Job]]
WRONG_M, U_TAPE_M, ROOF_M, INSET_M = 0.03, 0.02, 1.45, 0.3
WHEELBASES = {"Lindo": 2.53, "Monte": 2.63, "Taiga": 2.76}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    """A pose in force that takes the camera 30 mm too high, by a tape of u = 20 mm."""
    laid = lay_ground(services, survey_id, recording_id)
    pose = pose_above_road()
    assert pose.board is not None
    raised = np.array(CENTRE_M) + np.array([0.0, 0.0, WRONG_M])
    board = replace(pose.board, u_reference_height_m=U_TAPE_M, u_lean_rad=0.001)
    told = replace(
        pose,
        translation_m=-pose.rotation @ raised,
        board=board,
        covariance=np.diag(np.concatenate([np.full(9, 1e-12), np.full(6, 1e-8)])),
    )
    with services.writing() as session:
        made = store.add_pose(
            session,
            recording_id,
            calibration_id=laid.calibration_id,
            first_frame=0,
            last_frame=3,
            rms_px=0.1,
            distance_m=3.0,
            summary=[],
            document=pose_to_dict(told),
            warnings=[],
            expected=[],
            overlay={"grid": [], "iso_heights": [], "axes": None, "corners_px": []},
            actor=None,
        )
        for model, wheelbase_m in WHEELBASES.items():
            row = CatalogueRow(make="Corvane", model=model, wheelbase_m=wheelbase_m, u_wheelbase_m=0.005)
            add_catalogue_row(session, row, actor=None)
    return replace(laid, pose_id=made.id)


def fleet(client: Client, ground: Ground, wrong: int | None = None, **known: float) -> list[dict[str, Any]]:
    """Nine vehicles with both tyres, every third with its roof; `wrong`: under another model's name."""
    made = []
    for n in range(9):
        model, wheelbase_m = list(WHEELBASES.items())[n % 3]
        named = {"make": "Corvane", "model": "Taiga" if n == wrong else model}
        vehicle = add_vehicle(client, ground.recording_id, **named, manufacturer_height_m=ROOF_M, **known)
        across = 0.1 * (n - 4)
        ends = {
            "first": pixel(-wheelbase_m / 2, across, 0.0),
            "second": pixel(wheelbase_m / 2, across, 0.0),
        }
        client.made(f"/vehicles/{vehicle['id']}/wheel-pair", {"frame": 2, **ends})
        if n % 3 == 0:
            contact, target = pixel(0.2, across, 0.0), pixel(0.4, across + INSET_M, ROOF_M)
            points = {"contact": contact, "target_point": target}
            measure(client, vehicle["id"], **points, inset_m=INSET_M, u_inset_m=0.005)
        made.append(vehicle)
    return made


def asked(client: Client, ground: Ground) -> dict[str, Any]:
    (found,) = client.seen(f"/surveys/{ground.survey_id}/checks/adjustment")
    return dict(found)


def moved(found: dict[str, Any], name: str) -> dict[str, Any]:
    return next(dict(one) for one in found["moved"] if one["name"] == name)


def test_the_traffic_finds_the_camera_and_says_what_every_height_would_become(
    operator: Client, viewer: Client, ground: Ground
) -> None:
    fleet(operator, ground)
    found = asked(viewer, ground)
    assert (found["tyres"], found["roofs"], found["used"], found["left_out"]) == (9, 3, 12, [])
    height = moved(found, "camera_height_m")
    assert height["value"] == pytest.approx(-WRONG_M, abs=3 * height["u_after"])
    assert height["u_after"] < 0.5 * height["u_before"]
    assert found["chi2"] < found["chi2_limit"]
    assert {one["model"] for one in found["without_model"]} == {f"Corvane {name}" for name in WHEELBASES}
    assert len(found["heights"]) == 3
    for one in found["heights"]:
        assert one["change_m"] == pytest.approx(one["adjusted_m"] - one["height_m"])
        assert one["adjusted_m"] == pytest.approx(ROOF_M, abs=one["U95_adjusted_m"])
        assert abs(one["adjusted_m"] - ROOF_M) < abs(one["height_m"] - ROOF_M)
        assert one["U95_adjusted_m"] < one["U95_height_m"]


def test_a_height_of_another_pose_is_shown_as_it_is_stored(operator: Client, ground: Ground) -> None:
    made = fleet(operator, ground)
    path = f"/recordings/{ground.recording_id}"
    (other,) = {one["id"] for one in operator.seen(f"/surveys/{ground.survey_id}/poses")} - {ground.pose_id}
    operator.put(path, {"pose_id": other})
    stored = measure(operator, made[1]["id"], target="taillight")
    operator.put(path, {"pose_id": ground.pose_id})
    (shown,) = (one for one in asked(operator, ground)["heights"] if one["measurement_id"] == stored["id"])
    assert (shown["height_m"], shown["U95_height_m"]) == (stored["height_m"], stored["U95_height_m"])
    assert shown["change_m"] == shown["adjusted_m"] - shown["height_m"]


def test_it_is_put_in_force_by_a_person_computes_again_and_is_taken_back(
    operator: Client, viewer: Client, ground: Ground, services: Services, work: Work, tmp_path: Any
) -> None:
    fleet(operator, ground)
    found = asked(operator, ground)
    body = {"camera_height_change_m": moved(found, "camera_height_m")["value"]}
    path = f"/poses/{ground.pose_id}/adjustment"
    assert viewer.post(path, body).status_code == 403
    stale = operator.post(path, {"camera_height_change_m": 0.5})
    assert stale.status_code == 409 and "check it again" in error_of(stale)
    assert operator.post(f"{path}/undo").status_code == 409
    made = operator.made(path, body)
    drift, job = work()
    assert (drift.kind, drift.payload["pose_id"]) == ("drift", made["pose_id"])
    assert job.state == "done" and job.result and job.result["heights"] == 3
    recording = operator.seen(f"/recordings/{ground.recording_id}")
    assert recording["pose_id"] == made["pose_id"]
    computed = operator.seen(f"/surveys/{ground.survey_id}/computings")
    assert computed["computings"][0]["kind"] == "adjustment"
    assert computed["out_of_date"]["heights"] == 0
    now = {one["id"]: one for one in _measured(operator, ground)}
    for one in found["heights"]:
        assert now[one["measurement_id"]]["height_m"] == pytest.approx(one["adjusted_m"], abs=1e-7)
    # what the traffic said counts once: the adjusted pose is not adjusted again by the same vehicles
    assert asked(operator, ground)["used"] == 0 and asked(operator, ground)["adjusted_from"] == ground.pose_id
    package = written(services, ground.survey_id, tmp_path / "export")
    checked = verify_package(FolderFiles(package))
    assert checked.ok, checked.problem
    assert [row["adjusted_from"] for row in rows(package, "poses.csv")] == ["", "", str(ground.pose_id)]
    operator.made(f"/poses/{made['pose_id']}/adjustment/undo")
    (job,) = work()
    assert job.state == "done"
    assert operator.seen(f"/recordings/{ground.recording_id}")["pose_id"] == ground.pose_id
    back = {one["id"]: one for one in _measured(operator, ground)}
    for one in found["heights"]:
        assert back[one["measurement_id"]]["height_m"] == pytest.approx(one["height_m"], abs=1e-12)
    assert operator.seen(f"/surveys/{ground.survey_id}/computings")["out_of_date"]["heights"] == 0
    with services.reading() as session:
        verified = verify_records(session)
    assert verified.ok, verified.problem


def test_taking_it_back_undoes_no_computing_of_another_pose(
    operator: Client, ground: Ground, services: Services, work: Work
) -> None:
    """Only the last computing of a survey can be undone; where that is of another recording's pose, its
    heights stay, and those of the pose that is taken back are out of date and say so.
    """
    fleet(operator, ground)
    body = {"camera_height_change_m": moved(asked(operator, ground), "camera_height_m")["value"]}
    made = operator.made(f"/poses/{ground.pose_id}/adjustment", body)
    work()
    with services.writing() as session:
        other = add_computing(session, ground.survey_id, [], kind="adjustment", actor=None)
    assert operator.made(f"/poses/{made['pose_id']}/adjustment/undo")["job"] is None
    assert work() == []
    told = operator.seen(f"/surveys/{ground.survey_id}/computings")
    assert told["computings"][0]["id"] == other.id and told["computings"][0]["undone_by"] is None
    assert told["out_of_date"]["heights"] == 3


def _measured(client: Client, ground: Ground) -> list[dict[str, Any]]:
    vehicles = client.seen(f"/surveys/{ground.survey_id}/vehicles")
    return [one for vehicle in vehicles for one in vehicle["measurements"]]


def test_a_vehicle_said_to_be_another_model_is_named_and_what_lacks_is_said(
    operator: Client, ground: Ground
) -> None:
    vehicles = fleet(operator, ground, wrong=3)
    unnamed = add_vehicle(operator, ground.recording_id)
    tyres = {"first": pixel(-1.2, 0.0, 0.0), "second": pixel(1.2, 0.0, 0.0)}
    operator.made(f"/vehicles/{unnamed['id']}/wheel-pair", {"frame": 2, **tyres})
    found = asked(operator, ground)
    out = {one["vehicle_id"]: one["reason"]["message"] for one in found["left_out"]}
    assert "check the model." in out[vehicles[3]["id"]]
    assert "make and model are not filled in" in out[unnamed["id"]]
    assert found["used"] == 11


def test_a_retired_wheelbase_adjusts_nothing(operator: Client, ground: Ground) -> None:
    """A corrected model takes the place of a retired one; of one that is only retired nothing is known."""
    vehicles = fleet(operator, ground)
    for name in ("Lindo", "Monte"):
        (one,) = operator.seen(f"/catalogue/page?q={name}")["entries"]
        told = {"version": one["version"], "retired": True}
        assert operator.post(f"/catalogue/{one['id']}/retire", told).status_code == 200
    other = {"make": "Corvane", "model": "Lindo", "year_from": 1990, "source": "test"}
    operator.made("/catalogue", {**other, "wheelbase_m": WHEELBASES["Lindo"] + 0.02, "u_wheelbase_m": 0.005})
    found = asked(operator, ground)
    out = {one["vehicle_id"]: one["reason"]["code"] for one in found["left_out"] if one["what"] == "tyres"}
    assert [out.get(one["id"]) for one in vehicles[:2]] == [None, "adjustment-no-wheelbase"]


@pytest.mark.parametrize(("stated", "holds"), [(0.02, 0.02), (0.001, 0.005), (None, 0.01)])
def test_a_wheelbase_that_two_builds_share_is_as_sure_as_the_less_sure_of_them(
    services: Services, operator: Client, ground: Ground, stated: float | None, holds: float
) -> None:
    """Which of them passed is not known, nor may it hang on the order of the catalogue."""
    fleet(operator, ground)
    with services.writing() as session:
        later = CatalogueRow(make="Corvane", model="Lindo", year_from=2020, wheelbase_m=WHEELBASES["Lindo"])
        add_catalogue_row(session, replace(later, u_wheelbase_m=stated), actor=None)
    with services.reading() as session:
        found = observations_of(session, ground.survey_id, {ground.recording_id}, 0.01)
    known = [one.observed.wheelbase for one in found.seen if one.what == "tyres" and "Lindo" in one.model]
    assert known == 3 * [Known(WHEELBASES["Lindo"], holds)]


def test_a_roof_whose_height_is_exact_counts_as_exact(
    services: Services, operator: Client, ground: Ground
) -> None:
    fleet(operator, ground, u_manufacturer_height_m=0.0)
    with services.reading() as session:
        found = observations_of(session, ground.survey_id, {ground.recording_id}, 0.01)
    assert [one.observed.roof for one in found.seen if one.what == "roof"] == 3 * [Known(ROOF_M, 0.0)]


def test_where_nothing_is_known_nothing_is_claimed(operator: Client, ground: Ground) -> None:
    found = asked(operator, ground)
    assert found["reason"] and found["moved"] == []
    refused = operator.post(f"/poses/{ground.pose_id}/adjustment", {"camera_height_change_m": 0.0})
    assert refused.status_code in (400, 422) and "both tyres" in error_of(refused)
