"""A camera of another survey with its calibration: each survey has its own, and its chain vouches for it."""

import pytest

from sightline.infra.audit.verification import verify_records
from sightline.infra.services import Services
from tests.support.app import Client, error_of
from tests.support.boards import POSES, picture_bytes, view

from .test_cameras import BOARD, Work, camera_id, drop  # noqa: F401

pytestmark = pytest.mark.once


@pytest.fixture
def calibrated(operator: Client, camera_id: int, work: Work) -> int:  # noqa: F811
    for number, pose in enumerate(POSES):
        assert drop(operator, camera_id, picture_bytes(view(pose)), f"{number}.png").status_code == 201
    operator.made(f"/cameras/{camera_id}/calibrations", BOARD)
    assert [job.state for job in work()] == ["done"]
    return camera_id


def test_it_comes_with_its_calibration_and_pictures_and_is_a_camera_of_its_own(
    operator: Client, calibrated: int, services: Services
) -> None:
    there = operator.seen(f"/cameras/{calibrated}")
    other = operator.made("/surveys", {"name": "Hill", "site": "", "description": "", "open_to_all": True})[
        "id"
    ]
    taken = operator.made(f"/surveys/{other}/cameras/from/{calibrated}")
    here = operator.seen(f"/cameras/{taken['id']}")
    survey = operator.seen(f"/surveys/{there['survey_id']}")["name"]
    assert here["taken_from"] == f"{survey}: {there['name']}" and here["survey_id"] == other
    assert [one["name"] for one in here["images"]] == [one["name"] for one in there["images"]]
    mine, theirs = (operator.seen(f"/calibrations/{one['current_calibration_id']}") for one in (here, there))
    assert mine["document"] == theirs["document"] and mine["id"] != theirs["id"]
    assert [one["image_id"] for one in mine["views"]] == [one["id"] for one in here["images"]]
    picture = operator.http.get(here["images"][0]["url"])
    assert picture.content == operator.http.get(there["images"][0]["url"]).content
    # a picture that goes there stays here
    assert operator.http.delete(f"/api/calibration-images/{there['images'][0]['id']}").status_code == 204
    assert operator.http.get(here["images"][0]["url"]).status_code == 200
    with services.reading() as session:
        assert verify_records(session).ok


def test_what_cannot_be_taken_is_said(
    operator: Client, viewer: Client, calibrated: int, survey_id: int
) -> None:
    bare = operator.made(f"/surveys/{survey_id}/cameras", {"name": "Bare"})["id"]
    other = operator.made("/surveys", {"name": "Hill", "site": "", "description": "", "open_to_all": True})[
        "id"
    ]
    for survey, camera, status, words in (
        (other, bare, 422, "has no calibration to copy"),
        (survey_id, calibrated, 409, "belongs to this survey already"),
        (other, 999, 404, "camera 999"),
        (999, calibrated, 404, "survey 999"),
    ):
        answer = operator.post(f"/surveys/{survey}/cameras/from/{camera}")
        assert answer.status_code == status and words in error_of(answer), answer.text
    assert operator.seen(f"/surveys/{other}/cameras") == []
    assert viewer.post(f"/surveys/{other}/cameras/from/{calibrated}").status_code == 403
