"""A whole pass: asked for, stored once a person says so, exported, computed again and verified.

The clip of these tests shows no vehicle: what the follower would find in its pictures is put in its place
(tests/geometry/test_follow_pass.py follows drawn vehicles).
"""

import csv
import io
import json
from fractions import Fraction
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
import pytest

from sightline.geometry.follow_pass import FollowedPass, Lost
from sightline.geometry.followed_tracks import CONTACT, SECOND, TARGET, Following, Tracks
from sightline.infra.database.rows import change_row
from sightline.infra.services import Services
from sightline.measurements.followed_text import read_text, text_of
from sightline.measurements.following import service
from sightline.measurements.height_of_clicks import SIDE_FROM_PLACE, answer
from sightline.measurements.records import Clicks
from sightline.measurements.store import get_measurement
from sightline.messages.said import Said
from sightline.quality.repeats.clicks import height_of_first_frame
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_recording
from sightline.recordings.tables import recordings
from tests.measurements.test_second_frame import HEIGHT_M, INSET_M, exported, on_frame, rewritten
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, Client, error_of
from tests.support.ground import Ground, add_vehicle, pixel, pose_above_road
from tests.support.mutations import checked

pytestmark = pytest.mark.once

BASE_M, SPEED_MPS = 1.6, 9.0
LEFT = Said("followed-left-picture")
PLACES = {
    CONTACT: (-1.0, 0.0, 0.0),
    SECOND: (-1.0 + BASE_M, 0.0, 0.0),
    TARGET: (-0.6, INSET_M, HEIGHT_M),
}


@pytest.fixture
def followed(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    """A follower that finds a vehicle at 9 m/s exactly; what it was asked."""
    asked: list[dict[str, Any]] = []

    def found(pose, frames, begun_on, points_px, target, inset_m, confirmed_px):
        asked.append({"frames": [one.frame for one in frames], "points": points_px, "target": target})
        asked[-1]["tick_s"] = {one.tick_s for one in frames}
        start = next(one.time_s for one in frames if one.frame == begun_on)
        rows = [
            (one.frame, one.time_s, point, *pixel(x + SPEED_MPS * (one.time_s - start), y, z))
            for one in frames
            for point, (x, y, z) in PLACES.items()
            if point in points_px
        ]
        table = np.array(
            [row for row in rows if 0 < row[3] < FRAME_WIDTH - 1 and 0 < row[4] < FRAME_HEIGHT - 1]
        )
        tracks = Tracks(
            frame=table[:, 0].astype(np.int64),
            time_s=table[:, 1],
            point=table[:, 2].astype(np.int64),
            points_px=table[:, 3:5],
            sigma_px=np.full((len(table), 2), 0.1),
        )
        following = Following(confirmed_px=confirmed_px, begun_on=begun_on, u_depth_share=0.005, view_px=0.1)
        return FollowedPass(tracks, following, (Lost(11, "target", LEFT),))

    monkeypatch.setattr(service, "follow_pass", found)
    return asked


def clicks(**more: Any) -> dict[str, Any]:
    body = {"target": "driver_eye", **on_frame(2, 0.0), "inset_m": 0.45, "u_inset_m": 0.1}
    return {**body, **more}


def second() -> list[float]:
    return pixel(*PLACES[SECOND])


def store(operator: Client, vehicle_id: int, **more: Any) -> Any:
    body = {"client_key": str(uuid4()), **clicks(), "follow": {"second_contact": second()}, **more}
    return operator.made(f"/vehicles/{vehicle_id}/measurements", body)


def test_a_text_keeps_how_times_were_rounded_and_one_of_an_earlier_version_says_nothing_of_it() -> None:
    one = np.ones(1)
    tracks = Tracks(one.astype(np.int64), one, one.astype(np.int64), np.ones((1, 2)), np.ones((1, 2)))
    text = text_of(tracks, Following(begun_on=1, u_time_s=0.00029))
    assert read_text(text)[1].u_time_s == 0.00029
    earlier = {name: value for name, value in json.loads(text).items() if name != "u_time_s"}
    assert read_text(json.dumps(earlier))[1].u_time_s == 0.0


def test_asking_answers_points_reasons_and_the_height_and_stores_nothing(
    operator: Client,
    services: Services,
    ground: Ground,
    vehicle_id: int,
    followed: list[dict[str, Any]],
) -> None:
    said = operator.made(f"/vehicles/{vehicle_id}/follow", clicks(second_contact=second()))
    assert said["reason"] is None
    assert said["height"]["height_m"] == pytest.approx(HEIGHT_M, abs=1e-3)
    assert said["height"]["solved_inset_m"] == pytest.approx(INSET_M, abs=0.01)
    assert said["height"]["wheelbase_m"] == pytest.approx(BASE_M, abs=5e-3)
    assert said["height"]["speed_mps"] == pytest.approx(SPEED_MPS, abs=0.05)
    assert said["dropped"] == [{"frame": 11, "point": "target", "reason": LEFT.body}]
    assert {one["point"] for one in said["points"]} == {"contact", "second_contact", "target"}
    assert followed[0]["frames"] == list(range(12)) and followed[0]["target"] == "driver_eye"
    with services.reading() as session:
        base = get_recording(session, ground.recording_id).report["time_base"]
    assert followed[0]["tick_s"] == {float(Fraction(base))}
    assert operator.seen(f"/vehicles/{vehicle_id}")["measurements"] == []


def test_no_pass_is_followed_by_times_that_are_not_those_of_filming(
    operator: Client,
    services: Services,
    ground: Ground,
    vehicle_id: int,
    followed: list[dict[str, Any]],
) -> None:
    with services.writing() as session:
        report = {**get_recording(session, ground.recording_id).report, "clock_doubt": "slow_motion"}
        change_row(session, recordings, ground.recording_id, {"report": report})
    stills_of(services).forget(ground.recording_id)
    refused = operator.post(f"/vehicles/{vehicle_id}/follow", clicks(second_contact=second()))
    assert "are not the times of filming" in error_of(refused)
    body = {"client_key": str(uuid4()), **clicks()}
    of_pass = {**body, "follow": {"second_contact": None}}
    stored = operator.post(f"/vehicles/{vehicle_id}/measurements", of_pass)
    assert "are not the times of filming" in error_of(stored)
    assert followed == []
    of_one_frame = operator.made(f"/vehicles/{vehicle_id}/measurements", body)
    assert of_one_frame["followed"] is None and of_one_frame["height_m"] is not None


def test_a_second_tyre_is_not_for_who_clicked_it_to_review(
    operator: Client, reviewer: Client, admin: Client, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    path = f"/measurements/{store(operator, vehicle_id, follow={'second_contact': None})['id']}"
    body = {**clicks(), "follow": {"second_contact": second()}, "revision": 1}
    changed = reviewer.put(path, body)
    assert changed.status_code == 200, changed.text
    verdict = {"revision": 2, "verdict": "accepted"}
    assert [who.post(f"{path}/reviews", verdict).status_code for who in (reviewer, admin)] == [403, 201]


def test_what_is_stored_is_what_was_shown_with_all_its_points(
    operator: Client, ground: Ground, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    said = operator.made(f"/vehicles/{vehicle_id}/follow", clicks(second_contact=second()))
    stored = store(operator, vehicle_id)
    for name in ("height_m", "u_height_m", "solved_inset_m", "u_solved_inset_m", "budget", "flags"):
        assert stored[name] == said["height"][name], name
    assert (stored["x_m"], stored["y_m"]) == pytest.approx(PLACES[CONTACT][:2], abs=1e-3)
    by_place = Clicks(
        **on_frame(2, 0.0),
        target="driver_eye",
        followed=stored["followed"],
        sigma_px=1.0,
        inset_m=0.45,
        u_inset_m=0.1,
        inset_from="usual",
        side="near",
        side_from="place",
    )
    assert SIDE_FROM_PLACE in answer(pose_above_road(), by_place).flags
    kept = json.loads(stored["followed"])
    assert kept["begun_on"] == 2 and len(kept["points"]) == len(said["points"])
    assert kept["points"][0][3:5] == pytest.approx(said["points"][0]["at"], abs=1e-4)


def test_the_inset_of_a_survey_rests_on_what_was_seen_and_not_on_the_inset_assumed(
    operator: Client, ground: Ground, followed: list[dict[str, Any]]
) -> None:
    """One that was assumed would count once for every vehicle."""
    assumed_m = INSET_M + 0.2
    for _ in range(3):
        vehicle = add_vehicle(operator, ground.recording_id, last_frame=11)
        stored = store(operator, vehicle["id"], inset_m=assumed_m, u_inset_m=0.02, target="taillight")
        assert stored["solved_inset_m"] > INSET_M + 0.05
    check = operator.seen(f"/surveys/{ground.survey_id}/checks/insets")
    (lamp,) = (one for one in check["targets"] if one["name"] == "taillight")
    (found,) = (one for one in lamp["estimates"] if one["method"] == "two_frames")
    assert found["vehicles"] == 3
    assert found["inset_m"] == pytest.approx(INSET_M, abs=0.01)


def test_the_same_key_again_follows_nothing_and_gives_the_same_back(
    operator: Client, ground: Ground, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    key = str(uuid4())
    first = store(operator, vehicle_id, client_key=key)
    assert store(operator, vehicle_id, client_key=key)["revision_id"] == first["revision_id"]
    assert len(followed) == 1


def test_a_revision_without_following_stands_on_its_clicks_alone(
    operator: Client, ground: Ground, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    stored = store(operator, vehicle_id)
    path = f"/measurements/{stored['id']}"
    one = operator.put(path, {**clicks(), "revision": 1}).json()
    assert one["followed"] is None and one["solved_inset_m"] is None
    back = operator.put(path, {**clicks(), "revision": 2, "follow": {}}).json()
    assert back["followed"] is not None and "second_contact" not in back["followed"]


def test_a_fix_of_a_point_takes_what_was_followed_from_it_away(
    operator: Client, reviewer: Client, ground: Ground, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    stored = store(operator, vehicle_id)
    x, y = stored["target_point"]
    fix = {"verdict": "fixed", "reason": "beside", "contact": stored["contact"], "target_point": [x, y + 0.5]}
    fixed = reviewer.made(f"/measurements/{stored['id']}/reviews", {"revision": 1, **fix})
    assert fixed["followed"] is None


def test_what_cannot_be_followed_is_refused_and_nothing_stored(
    operator: Client, ground: Ground, vehicle_id: int
) -> None:
    said = operator.made(f"/vehicles/{vehicle_id}/follow", clicks())
    assert (
        said["points"] == [] and said["height"] is None and "cannot be followed" in said["reason"]["message"]
    )
    new = {"client_key": str(uuid4()), **clicks(), "follow": {}}
    refused = operator.post(f"/vehicles/{vehicle_id}/measurements", new)
    assert refused.status_code == 422 and "cannot be followed" in error_of(refused)
    both = {**new, "more_frames": [on_frame(7, 1.8)]}
    refused = operator.post(f"/vehicles/{vehicle_id}/measurements", both)
    assert refused.status_code == 422 and "other frames" in error_of(refused)
    assert operator.seen(f"/vehicles/{vehicle_id}")["measurements"] == []


def test_a_repeat_is_held_against_the_first_frame_alone(
    operator: Client, services: Services, ground: Ground, vehicle_id: int, followed: list[dict[str, Any]]
) -> None:
    stored = store(operator, vehicle_id)
    single = operator.made(f"/recordings/{ground.recording_id}/geometry/height", clicks())
    with services.reading() as session:
        height_m, _ = height_of_first_frame(session, get_measurement(session, stored["id"]))
    assert height_m == pytest.approx(single["height_m"], abs=1e-9) and height_m != stored["height_m"]


def test_an_export_holds_the_pass_and_a_changed_point_is_found(
    operator: Client,
    services: Services,
    ground: Ground,
    vehicle_id: int,
    followed: list[dict[str, Any]],
    tmp_path: Path,
) -> None:
    stored = store(operator, vehicle_id)
    files = exported(services, ground.survey_id, tmp_path / "export")
    assert checked(files).ok, checked(files).problem
    (row,) = csv.DictReader(io.StringIO(files["tables/measurements.csv"].decode()))
    assert row["followed"] == stored["followed"] and int(row["frames"]) > 3
    kept = json.loads(row["followed"])
    kept["points"][0][4] += 3.0
    for path, column, text in (
        ("measurements.csv", "followed", json.dumps(kept)),
        ("revisions.csv", "followed", json.dumps(kept)),
        ("revisions.csv", "followed", "[]"),
        ("revisions.csv", "height_m", "1.3"),
    ):
        forged = checked(rewritten(files, path, column, text))
        assert not forged.ok, (path, column)
    moved = rewritten(
        rewritten(files, "measurements.csv", "followed", json.dumps(kept)),
        "revisions.csv",
        "followed",
        json.dumps(kept),
    )
    assert "its clicks give" in str(checked(moved).problem)
