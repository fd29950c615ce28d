"""The same two points on further frames: stored, revised, proposed, exported, and checked again."""

import csv
import io
import json
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest

from sightline.commands.clicks import heights_csv
from sightline.enums import Target
from sightline.export.build import build
from sightline.geometry.documents import pose_from_dict
from sightline.infra.csv_package.files import Staging, place_of
from sightline.infra.services import Services
from sightline.measurements.second_frame import Candidate, Spot, chosen_frames
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, FRAMES, Client, error_of
from tests.support.ground import Ground, add_vehicle, pixel
from tests.support.mutations import MemoryFiles, Package, checked, load, with_sums

pytestmark = pytest.mark.once

HEIGHT_M, INSET_M = 1.16, 0.42


def on_frame(frame: int, travel_m: float) -> dict[str, Any]:
    """Both points of a vehicle that has come `travel_m`, as they are seen."""
    return {
        "frame": frame,
        "contact": pixel(-1.0 + travel_m, 0.0, 0.0),
        "target_point": pixel(-0.6 + travel_m, INSET_M, HEIGHT_M),
    }


def two_frames(**more: Any) -> dict[str, Any]:
    body = {"target": "driver_eye", **on_frame(2, 0.0), "more_frames": [on_frame(7, 1.8)]}
    return {**body, "inset_m": 0.9, "u_inset_m": 0.1, **more}


def stored_on_two(operator: Client, vehicle_id: int, **more: Any) -> Any:
    body = {"client_key": str(uuid4()), **two_frames(**more)}
    return operator.made(f"/vehicles/{vehicle_id}/measurements", body)


def test_two_frames_solve_the_inset_live_and_stored_alike(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    live = operator.made(f"/recordings/{ground.recording_id}/geometry/height", two_frames())
    assert live["height_m"] == pytest.approx(HEIGHT_M, abs=1e-6)
    assert live["solved_inset_m"] == pytest.approx(INSET_M, abs=1e-6)
    assert live["travel_m"] == pytest.approx(1.8, abs=1e-6) and live["frames"] == 2
    assert live["single"]["height_m"] == pytest.approx(
        1.5 + (HEIGHT_M - 1.5) * 3.9 / 3.42, abs=1e-6
    )  # as the wrong inset has it
    assert live["u_height_m"] < live["single"]["u_height_m"]
    stored = stored_on_two(operator, vehicle_id)
    for name in (
        "height_m",
        "u_height_m",
        "solved_inset_m",
        "u_solved_inset_m",
        "budget",
        "flags",
        "inset_m",
    ):
        assert stored[name] == live[name], name
    assert stored["uncorrected_height_m"] == pytest.approx(1.5 + (HEIGHT_M - 1.5) * 3 / 3.42, abs=1e-6)
    (further,) = stored["more_frames"]
    assert further["frame"] == 7 and further["frame_crc32"] > 0 and further["pts"] > stored["pts"]


def test_a_frame_is_taken_away_and_brought_back_by_revisions(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    stored = stored_on_two(operator, vehicle_id)
    path = f"/measurements/{stored['id']}"
    one = operator.put(path, {**two_frames(more_frames=[]), "revision": 1}).json()
    assert one["more_frames"] == [] and one["solved_inset_m"] is None
    three = [on_frame(7, 1.8), on_frame(5, 1.0)]
    back = operator.put(path, {**two_frames(more_frames=three), "revision": 2}).json()
    assert [f["frame"] for f in back["more_frames"]] == [7, 5]
    assert back["u_height_m"] < stored["u_height_m"]
    revisions = operator.seen(f"{path}/history")["revisions"]
    assert [len(one["more_frames"]) for one in revisions] == [1, 0, 2]


def test_no_height_from_two_frames_has_a_reason_and_no_other_number(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    near = stored_on_two(operator, vehicle_id, more_frames=[on_frame(3, 0.05)])
    assert (near["status"], near["height_m"], near["solved_inset_m"]) == ("not_measurable", None, None)
    assert "further apart" in near["reason"]["message"]
    twice = operator.post(
        f"/vehicles/{vehicle_id}/measurements",
        {"client_key": str(uuid4()), **two_frames(more_frames=[on_frame(2, 1.8)])},
    )
    assert twice.status_code == 422 and "Frame 2 is clicked twice" in error_of(twice)
    beyond = operator.post(
        f"/vehicles/{vehicle_id}/measurements",
        {"client_key": str(uuid4()), **two_frames(more_frames=[on_frame(999, 1.8)])},
    )
    assert beyond.status_code == 404


def test_a_fix_keeps_further_frames_unless_the_frame_is_another(
    operator: Client, reviewer: Client, admin: Client, ground: Ground, vehicle_id: int
) -> None:
    stored = stored_on_two(operator, vehicle_id)
    points = {
        "contact": stored["contact"],
        "target_point": [stored["target_point"][0], stored["target_point"][1] + 0.5],
    }
    fix = {"verdict": "fixed", "reason": "beside", **points}
    kept = reviewer.made(f"/measurements/{stored['id']}/reviews", {"revision": 1, **fix})
    assert [f["frame"] for f in kept["more_frames"]] == [7]
    other = admin.made(f"/measurements/{stored['id']}/reviews", {"revision": 2, "frame": 3, **fix})
    assert other["frame"] == 3 and other["more_frames"] == []


def test_a_speed_clicked_before_proposes_the_frame(operator: Client, ground: Ground, vehicle_id: int) -> None:
    """The clip shows no vehicle to follow: another measurement on two frames says how fast it goes."""
    path = f"/recordings/{ground.recording_id}/geometry/second-frame"
    wanted = {**two_frames(more_frames=[]), "vehicle_id": vehicle_id}
    assumed = operator.made(path, wanted)
    assert assumed["ok"] and assumed["source"] == "assumed" and "is assumed" in assumed["words"]["message"]
    assert {spot["assumed_kmh"] for spot in assumed["spots"]} == {50.0}  # either way, as none is known
    stored_on_two(operator, vehicle_id)
    found = operator.made(path, wanted)
    assert found["ok"] and found["source"] == "measured" and found["U95_then_m"] < found["U95_now_m"]
    spot = next(one for one in found["spots"] if one["frame"] == 7)
    assert spot["travel_m"] == pytest.approx(1.8, abs=0.05)
    assert spot["contact"] == pytest.approx(pixel(0.8, 0.0, 0.0), abs=3)
    third = operator.made(path, {**two_frames(), "vehicle_id": vehicle_id})
    assert third["frame"] not in (2, 7)
    helps = third["ok"] and third["u_then_m"] < third["u_now_m"]
    assert helps or third["reason"]["code"] == "second-frame-no-gain"


# A vehicle that goes to the right, 0.36 m a frame: metres ahead of its contact, behind its side plane, up.
POINTS = {
    "roof": (1.2, 0.3, 1.45),
    "driver_eye": (1.6, 0.45, 1.16),
    "taillight": (-0.6, 0.05, 0.8),
    "headlight": (3.0, 0.05, 0.7),
    "other": (-2.9, 0.05, 0.7),  # at the end of a trailer
}
STEP_M = 0.36
MARGIN_PX = 0.02 * FRAME_WIDTH


def seen_on(target: str, frame: int, start_m: float) -> tuple[list[float], list[float]]:
    """Contact and target point on a frame of a vehicle whose contact is at `start_m` on frame 2."""
    x = start_m + STEP_M * (frame - 2)
    ahead, behind, up = POINTS[target]
    return pixel(x, 0.0, 0.0), pixel(x + ahead, behind, up)


def frames_showing(target: str, start_m: float) -> set[int]:
    """The frames of the clip with both points in the picture, and not at its border."""
    size = (FRAME_WIDTH - 1, FRAME_HEIGHT - 1)
    return {
        frame
        for frame in range(FRAMES)
        if all(
            MARGIN_PX <= value <= most - MARGIN_PX
            for point in seen_on(target, frame, start_m)
            for value, most in zip(point, size, strict=True)
        )
    }


def frame_for(
    operator: Client, ground: Ground, start_m: float, *asked: str, u_inset_m: float = 0.1, **span: int
) -> Any:
    """What is answered of targets clicked on frame 2 of a vehicle whose speed is known from another."""
    vehicle = int(add_vehicle(operator, ground.recording_id, **{"last_frame": 11, **span})["id"])
    stored_on_two(operator, vehicle, target="other")
    contact = seen_on(asked[0], 2, start_m)[0]
    first, *others = (
        {
            "target": target,
            "target_point": seen_on(target, 2, start_m)[1],
            "inset_m": POINTS[target][1],
            "u_inset_m": u_inset_m,
        }
        for target in asked
    )
    body = {**first, "frame": 2, "contact": contact, "vehicle_id": vehicle, "others": others}
    return operator.made(f"/recordings/{ground.recording_id}/geometry/second-frame", body)


def test_one_frame_is_chosen_that_shows_all_that_was_measured(operator: Client, ground: Ground) -> None:
    """The taillight alone would be looked for where the driver's eye has left the picture."""
    start_m = -1.0
    alone = frame_for(operator, ground, start_m, "taillight")
    assert alone["ok"] and alone["others"] == []
    assert alone["frame"] in frames_showing("taillight", start_m) - frames_showing("driver_eye", start_m)
    order = ("taillight", "roof", "driver_eye")
    found = frame_for(operator, ground, start_m, *order)
    answers = [found, *found["others"]]
    assert [one["target"] for one in answers] == list(order) and all(one["ok"] for one in answers)
    shown = set.intersection(*(frames_showing(one, start_m) for one in order))
    assert {one["frame"] for one in answers} < shown and len({one["frame"] for one in answers}) == 1
    for one in answers:
        spot = next(spot for spot in one["spots"] if spot["frame"] == one["frame"])
        contact, point = seen_on(one["target"], one["frame"], start_m)
        assert spot["contact"] == pytest.approx(contact, abs=0.05)
        assert spot["target_point"] == pytest.approx(point, abs=0.05)
        assert one["u_then_m"] <= 0.95 * one["u_now_m"]
        assert {spot["frame"] for spot in one["spots"]} <= frames_showing(one["target"], start_m)


def test_each_has_its_own_frame_where_none_shows_all(operator: Client, ground: Ground) -> None:
    start_m = 0.0
    found = frame_for(operator, ground, start_m, "headlight", "other", u_inset_m=0.4)
    (other,) = found["others"]
    both = frames_showing("headlight", start_m) & frames_showing("other", start_m)
    assert both == {2}  # the one that was clicked
    assert found["ok"] and found["frame"] in frames_showing("headlight", start_m) - both
    assert other["ok"] and other["frame"] in frames_showing("other", start_m) - both


def test_a_target_that_no_frame_shows_is_said_and_the_others_are_asked_for(
    operator: Client, ground: Ground
) -> None:
    """After frame 2, where the pass begins, the headlight has left the picture."""
    start_m = 0.0
    assert not {frame for frame in frames_showing("headlight", start_m) if frame > 2}
    found = frame_for(operator, ground, start_m, "headlight", "taillight", "roof", first_frame=2)
    assert (found["ok"], found["frame"], found["spots"]) == (False, None, [])
    assert found["reason"]["code"] == "second-frame-not-shown"
    assert found["source"] == "measured"
    frames = {one["frame"] for one in found["others"]}
    assert len(frames) == 1 and frames < frames_showing("roof", start_m) & frames_showing(
        "taillight", start_m
    )


def spot(frame: int, u_m: float, travel_m: float = 1.0, kmh: float | None = None) -> Spot:
    return Spot(
        frame=frame,
        travel_m=travel_m,
        contact=(0.0, 0.0),
        target_point=(0.0, 0.0),
        u_height_m=u_m,
        U95_height_m=1.96 * u_m,
        u_solved_inset_m=0.1,
        assumed_kmh=kmh,
    )


def candidate(target: Target, *spots: Spot, sure: set[int] | None = None) -> Candidate:
    """Known to 40 mm so far."""
    frames = {one.frame for one in spots} if sure is None else sure
    return Candidate(target=target, u_now_m=0.040, spots=spots, sure=frozenset(frames))


def test_which_frame_is_chosen() -> None:
    roof = candidate("roof", spot(5, 0.030), spot(7, 0.018), spot(9, 0.010))
    light = candidate("taillight", spot(7, 0.020), spot(9, 0.030), spot(11, 0.005))
    # 7 leaves 0.45 and 0.50 of the two; 9 leaves 0.25 and 0.75, less than half of what 11 gains the light
    assert chosen_frames([roof]) == [9] and chosen_frames([light]) == [11]
    assert chosen_frames([roof, light]) == chosen_frames([light, roof]) == [7, 7]
    # a third that no frame helps has none, and the two keep theirs
    idle = candidate("driver_eye", spot(7, 0.039), spot(9, 0.041))
    assert chosen_frames([roof, idle, light]) == [7, None, 7]
    # where the frame for both would gain little, each has its own
    weak = candidate("taillight", spot(7, 0.036), spot(11, 0.005))
    assert chosen_frames([roof, weak]) == [9, 11]
    # where no frame serves all, those share one that can
    eye = candidate("driver_eye", spot(5, 0.012), spot(7, 0.020))
    assert chosen_frames([eye, weak, roof]) == [7, 11, 7]
    # of frames about as good the one with the shorter way
    alike = candidate("roof", spot(7, 0.0103, travel_m=-0.8), spot(9, 0.010, travel_m=1.6))
    assert chosen_frames([alike]) == [7]
    # an assumed speed: a frame that would not show it at another speed is not asked for
    assumed = candidate("roof", spot(7, 0.020, kmh=50.0), spot(7, 0.004, kmh=80.0), spot(9, 0.010, kmh=50.0))
    assert chosen_frames([assumed]) == [9]
    unsure = candidate("roof", *assumed.spots, sure={7})
    assert chosen_frames([unsure]) == [7]


def test_why_no_second_frame_would_help(operator: Client, ground: Ground, vehicle_id: int) -> None:
    path = f"/recordings/{ground.recording_id}/geometry/second-frame"
    short = int(add_vehicle(operator, ground.recording_id, first_frame=2, last_frame=2)["id"])
    alone = operator.made(path, {**two_frames(more_frames=[]), "vehicle_id": short})
    assert not alone["ok"] and "no other frame" in alone["reason"]["message"] and alone["frame"] is None
    sky = operator.made(path, {**two_frames(more_frames=[], contact=[160.0, 5.0]), "vehicle_id": vehicle_id})
    assert not sky["ok"] and sky["reason"]["code"] == "height-contact-above-horizon" and sky["spots"] == []


def exported(services: Services, survey_id: int, place: Path) -> Package:
    place.mkdir()
    with services.reading() as session:
        build(Staging(place), session, survey_id, services, crops=False)
    return load(place)


def rewritten(files: Package, path: str, column: str, text: str) -> Package:
    """The package with one cell of the first row changed and all sums made to fit, as a forger would."""
    path = place_of(MemoryFiles(files), path)
    rows = list(csv.DictReader(io.StringIO(files[path].decode())))
    rows[0][column] = text
    out = io.StringIO()
    writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return with_sums({**files, path: out.getvalue().encode()}, files, seal=True)


def test_an_export_holds_all_frames_and_a_changed_one_is_found(
    operator: Client, services: Services, ground: Ground, vehicle_id: int, tmp_path: Path
) -> None:
    stored = stored_on_two(operator, vehicle_id, more_frames=[on_frame(7, 1.8), on_frame(5, 1.0)])
    files = exported(services, ground.survey_id, tmp_path / "export")
    assert checked(files).ok, checked(files).problem
    (row,) = csv.DictReader(io.StringIO(files["tables/measurements.csv"].decode()))
    assert (row["frames"], row["frame2"], row["frame3"]) == ("3", "7", "5")
    assert float(row["solved_inset_m"]) == pytest.approx(INSET_M, abs=2e-6)
    frames = [one["frame"] for one in csv.DictReader(io.StringIO(files["tables/frames.csv"].decode()))]
    assert frames == ["2", "5", "7"]
    described = json.loads(files["datapackage.json"])
    for resource in (one for one in described["resources"] if "schema" in one):
        header = files[resource["path"]].decode().splitlines()[0].split(",")
        assert header == [one["name"] for one in resource["schema"]["fields"]], resource["name"]

    # the command line computes the same from clicks and pose
    name = f"clicks/pose-{ground.pose_id}.csv"
    clicks = tmp_path / "clicks.csv"
    clicks.write_bytes(files[name])
    text, _ = heights_csv(pose_from_dict(json.loads(files[f"poses/pose-{ground.pose_id}.json"]), "p"), clicks)
    (again,) = csv.DictReader(io.StringIO(text))
    assert float(again["height_m"]) == pytest.approx(stored["height_m"], abs=1e-6)
    assert float(again["solved_inset_m"]) == pytest.approx(stored["solved_inset_m"], abs=1e-6)

    for path, column, words in (
        ("clicks.csv", "contact2_x_px", "another contact2_x_px"),
        ("measurements.csv", "target3_y_px", "another target3_y_px"),
        ("measurements.csv", "solved_inset_m", "another solved_inset_m"),
        ("measurements.csv", "frame2", "another frame2"),
    ):
        forged = checked(rewritten(files, path, column, "4"))
        assert not forged.ok and words in str(forged.problem), (column, forged.problem)
    both = rewritten(
        rewritten(files, "clicks.csv", "contact2_x_px", "210"), "measurements.csv", "contact2_x_px", "210"
    )
    assert not checked(both).ok
