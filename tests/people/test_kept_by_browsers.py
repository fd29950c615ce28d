"""What a browser may keep of a survey, and what it must ask for again."""

from collections.abc import Callable

import pytest

from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from tests.support.app import Client
from tests.support.packages import photograph
from tests.surveys.test_photographs import told_bytes

pytestmark = pytest.mark.once


def id_of(client: Client) -> int:
    return int(client.seen("/session")["person"]["id"])


@pytest.fixture
def closed(admin: Client, viewer: Client, survey_id: int) -> int:
    """The survey, of which the viewer is a member and others are not."""
    assert admin.put(f"/surveys/{survey_id}/members/{id_of(viewer)}", {"role": "viewer"}).status_code == 200
    assert admin.put(f"/surveys/{survey_id}/open-to-all", {"open_to_all": False}).status_code == 200
    return survey_id


def test_a_frame_is_asked_for_again_and_confirmed_without_decoding(
    viewer: Client,
    reviewer: Client,
    nobody: Client,
    admin: Client,
    recording_id: int,
    closed: int,
    services: Services,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    path = f"/recordings/{recording_id}/frames"
    pictures = (
        f"{path}/3.jpg",
        f"{path}/3/crop.png?x=0&y=0&w=8&h=8",
        f"/recordings/{recording_id}/thumbs/0.jpg",
    )
    kept = {one: viewer.get(one) for one in pictures}
    for answer in kept.values():
        assert answer.status_code == 200 and answer.headers["cache-control"] == "private, no-cache"

    def decoded(*_args: object, **_more: object) -> None:
        raise AssertionError("a picture that the browser has was made again")

    for name in ("still", "crop_png"):
        monkeypatch.setattr(services.frames, name, decoded)
    for one, answer in kept.items():
        held = {"If-None-Match": answer.headers["etag"]}
        again = viewer.get(one, headers=held)
        assert (again.status_code, again.content) == (304, b"")
        assert again.headers["cache-control"] == "private, no-cache"
        assert reviewer.get(one, headers=held).status_code == 404
        assert nobody.get(one, headers=held).status_code == 401
    # the membership of this moment counts, also for what was shown before
    assert admin.delete(f"/surveys/{closed}/members/{id_of(viewer)}").status_code == 200
    for one, answer in kept.items():
        assert viewer.get(one, headers={"If-None-Match": answer.headers["etag"]}).status_code == 404


def test_packages_photographs_and_videos_are_kept_by_no_browser(
    operator: Client,
    viewer: Client,
    reviewer: Client,
    admin: Client,
    recording_id: int,
    survey_id: int,
    work: Callable[[], list[Job]],
) -> None:
    picture = photograph(operator, survey_id, told_bytes(), "rig.jpg")
    viewer.made(f"/surveys/{survey_id}/exports", {"crops": False})
    assert [job.error for job in work()] == [None]
    package = viewer.seen(f"/surveys/{survey_id}/exports")[0]["url"]
    assert admin.put(f"/surveys/{survey_id}/members/{id_of(viewer)}", {"role": "viewer"}).status_code == 200
    assert admin.put(f"/surveys/{survey_id}/open-to-all", {"open_to_all": False}).status_code == 200
    for address in (package, picture["url"], f"/api/recordings/{recording_id}/video"):
        answer = viewer.http.get(address)
        assert (answer.status_code, answer.headers["cache-control"]) == (200, "no-store"), address
        held = {"If-None-Match": answer.headers.get("etag", "*")}
        assert viewer.http.get(address, headers=held).status_code == 200
        assert reviewer.http.get(address, headers=held).status_code == 404


def test_signing_out_clears_what_the_browser_kept(viewer: Client) -> None:
    answer = viewer.delete("/session")
    assert (answer.status_code, answer.headers["clear-site-data"]) == (204, '"cache"')
