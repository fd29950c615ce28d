"""Bad input through the browser: one clear sentence each, no number, and nothing broken afterwards."""

import re
from contextlib import closing
from pathlib import Path
from typing import Any

import av
import cv2
import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect

from tests.media.clips import QVGA, Spec, write
from tests.support.boards import POSES, picture_bytes, view

from .picture import on_screen
from .server import Server
from .vehicles import OwnVehicle, click_at, own_vehicle, stored, until
from .waits import wait_until

HEADERS = {"X-Sightline": "1"}


def one_sentence(text: str) -> str:
    """The text, if it is one sentence for people: no traceback, no path, no code."""
    assert text.endswith(".") and "\n" not in text, text
    assert not re.search(r"Traceback|Errno|Exception|/tmp|None|NaN|undefined", text), text
    assert len(re.findall(r"[.!?](?:\s|$)", text)) == 1, text
    return text


def new_survey(page: Page, name: str) -> int:
    made = page.request.post(
        "/api/surveys", headers=HEADERS, data={"name": name, "site": "", "description": ""}
    )
    assert made.ok, made.text()
    return int(made.json()["id"])


def finished(page: Page, job: dict[str, Any]) -> dict[str, Any]:

    def over() -> dict[str, Any] | None:
        now: dict[str, Any] = page.request.get(f"/api/jobs/{job['id']}").json()
        return None if now["state"] in ("queued", "running") else now

    return wait_until(page, over, lambda: f"job {job['id']} does not end")


def sound_alone(path: Path) -> Path:
    with closing(av.open(str(path), "w")) as out:
        stream = out.add_stream("aac", rate=8000)
        for k in range(10):
            sound = av.AudioFrame.from_ndarray(np.zeros((1, 1024), np.float32), "fltp", "mono")
            sound.sample_rate, sound.pts = 8000, 1024 * k
            out.mux(stream.encode(sound))
        out.mux(stream.encode(None))
    return path


@pytest.fixture
def no_videos(tmp_path: Path) -> dict[str, Path]:
    """Files by the words in which they are refused."""
    text, empty, still = tmp_path / "letter.mp4", tmp_path / "empty.mp4", tmp_path / "still.mp4"
    text.write_text("Dear operator,\nplease find attached the video.\n")
    empty.write_bytes(b"")
    still.write_bytes(cv2.imencode(".png", np.full((48, 64, 3), 90, np.uint8))[1].tobytes())
    whole = write(tmp_path / "whole.mp4", Spec("whole.mp4", size=QVGA), 40).read_bytes()
    cut = tmp_path / "cut.mp4"
    cut.write_bytes(whole[: len(whole) // 2])
    return {
        "is a text file": text,
        "is empty": empty,
        "PNG image, not a video": still,
        "cut off before its index": cut,
        "no video": sound_alone(tmp_path / "sound.mp4"),
    }


def told(page: Page, name: str) -> Locator:
    rows = page.locator(".upload, article.recording").filter(has_text=name)
    return rows.locator(".notice--problem .notice__body")


def test_what_is_no_video_is_refused_in_one_sentence(
    page: Page, no_videos: dict[str, Path], tmp_path: Path
) -> None:
    survey = new_survey(page, "Bad videos")
    page.goto(f"/surveys/{survey}/recordings")
    good = write(tmp_path / "good.mp4", Spec("good.mp4", size=QVGA), 30)
    torn = tmp_path / "torn.mp4"
    front = Spec("whole.mp4", size=QVGA, muxer=(("movflags", "+faststart"),))
    whole = write(tmp_path / "index-in-front.mp4", front, 60).read_bytes()
    torn.write_bytes(whole[: int(len(whole) * 0.6)])
    files = [*no_videos.values(), good, torn]
    page.get_by_label("Choose videos to upload").set_input_files([str(path) for path in files])
    for words, path in no_videos.items():
        notice = told(page, path.name)
        expect(notice).to_have_count(1)
        expect(notice).to_contain_text(words)
        expect(notice).to_contain_text(path.name)
        one_sentence(notice.inner_text())
    # what is sound beside them is not held up, and half a film is half a film
    expect(page.locator("article").filter(has_text="good.mp4")).to_contain_text("30 frames")
    half = page.locator("article").filter(has_text="torn.mp4")
    expect(half).to_contain_text("The header states 60 frames")
    expect(half).to_contain_text("ready")
    states = {r["name"]: r["state"] for r in page.request.get(f"/api/surveys/{survey}/recordings").json()}
    assert states.pop("good.mp4") == states.pop("torn.mp4") == "ready"
    assert set(states.values()) == {"failed"}


@pytest.fixture
def camera(page: Page) -> tuple[int, int]:
    """(survey, camera): a fresh one, without images."""
    survey = new_survey(page, "Bad boards")
    made = page.request.post(
        f"/api/surveys/{survey}/cameras", headers=HEADERS, data={"name": "Bench", "notes": ""}
    )
    return survey, int(made.json()["id"])


def add_pictures(page: Page, *pictures: tuple[str, bytes]) -> None:
    files = [{"name": name, "mimeType": "image/png", "buffer": data} for name, data in pictures]
    page.get_by_label("Choose images of the checkerboard").set_input_files(files)  # type: ignore[arg-type]
    expect(page.get_by_text("to go")).to_have_count(0)


def reason_for(page: Page, name: str) -> str:
    shot = page.locator(".shot").filter(has_text=name)
    expect(shot).to_contain_text("excluded")
    return shot.locator("p.muted").inner_text()


def test_boards_that_cannot_be_used_are_named_and_left_out(page: Page, camera: tuple[int, int]) -> None:
    survey, camera_id = camera
    page.goto(f"/surveys/{survey}/camera")
    page.get_by_label("Columns").fill("9")
    page.get_by_label("Rows").fill("6")
    cut = view(((0.0, 0.0, 0.0), (0.14, 0.0, 0.4)))
    add_pictures(
        page,
        ("one.png", picture_bytes(view(POSES[0]))),
        ("two.png", picture_bytes(view(POSES[1]))),
        ("cut.png", picture_bytes(cut)),
        ("letter.png", b"Dear operator, this is no picture."),
    )
    assert "9x6" in one_sentence(reason_for(page, "cut.png"))
    refused = page.locator(".notice--problem .notice__body").filter(has_text="letter.png")
    assert "is not an image" in one_sentence(refused.inner_text())
    expect(page.get_by_text("The board was found in 2 of 3 images")).to_be_visible()
    expect(page.get_by_role("button", name="Calibrate", exact=True)).to_be_disabled()
    expect(page.get_by_text("Add at least three images")).to_be_visible()

    # the server says so too, to whoever asks it past the page
    job = page.request.post(
        f"/api/cameras/{camera_id}/calibrations",
        headers=HEADERS,
        data={"columns": 9, "rows": 6, "square_m": 0.025, "model": "brown"},
    ).json()
    over = finished(page, job)
    assert over["state"] == "failed" and "at least 3 are needed" in over["error"]["message"]
    assert page.request.get(f"/api/cameras/{camera_id}").json()["calibrations"] == []

    page.get_by_label("Columns").fill("11")
    page.get_by_label("Rows").fill("8")
    page.get_by_role("button", name="Search again").click()
    expect(page.get_by_text("The board was found in 0 of 3 images")).to_be_visible(timeout=30_000)
    assert "11x8" in one_sentence(reason_for(page, "one.png"))


def test_a_span_without_a_board_gives_a_reason_and_changes_nothing(page: Page, demonstration: Server) -> None:
    one = own_vehicle(page)
    recording = page.request.get(f"/api/recordings/{one.vehicle['recording_id']}").json()
    page.goto(f"/surveys/{one.survey}/pose?recording={recording['id']}")
    expect(page.get_by_test_id("pose-verdict")).to_be_visible()
    for mark, frame in (("Set first", 200), ("Set last", 202)):
        page.get_by_test_id("frame-box").fill(str(frame))
        page.get_by_test_id("frame-box").press("Enter")
        page.get_by_role("button", name=mark).click()
    expect(page.get_by_test_id("pose-span")).to_contain_text("200 to 202")
    page.get_by_label(re.compile("From the road up to the")).fill("1.0")
    page.get_by_test_id("pose-run").get_by_role("button").click()
    notice = page.locator(".pose-form__foot .notice--problem .notice__body")
    expect(notice).to_contain_text("board")
    one_sentence(notice.inner_text())
    after = page.request.get(f"/api/recordings/{recording['id']}").json()
    assert after["pose_id"] == recording["pose_id"]


@pytest.fixture
def opened(page: Page, demonstration: Server) -> OwnVehicle:
    one = own_vehicle(page)
    page.goto(one.address)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    on_screen(page, (0, 0))
    return one


def test_a_contact_above_the_horizon_gives_a_reason_and_no_number(page: Page, opened: OwnVehicle) -> None:
    page.get_by_test_id("target-roof").click()
    click_at(page, (320, 20))
    hint = page.locator("#measure-hint")
    expect(hint).to_contain_text("above the horizon")
    expect(page.get_by_test_id("axes")).to_have_count(0)
    click_at(page, (300, 15))
    expect(hint).to_contain_text("above the horizon")
    expect(page.locator(".live-height").filter(has_text="±")).to_have_count(0)
    assert stored(page, opened.vehicle["id"]) == {}


def test_a_target_below_the_road_is_stored_with_its_reason_and_no_number(
    page: Page, opened: OwnVehicle
) -> None:
    page.get_by_test_id("target-roof").click()
    x, y = opened.pixels["contact_rear"]
    click_at(page, (x, y))
    expect(page.get_by_test_id("axes")).to_be_visible()
    click_at(page, (x, y + 12))
    row = page.get_by_test_id("measurement-row-roof")
    expect(row).to_contain_text("not measurable")
    expect(row).not_to_contain_text("±")
    expect(page.get_by_text("were contact and target swapped?").first).to_be_visible()
    until(page, opened.vehicle["id"], lambda have: "roof" in have)  # a slow server stores it later
    have = stored(page, opened.vehicle["id"])["roof"]
    assert have["status"] == "not_measurable" and have["reason"]
    assert have["height_m"] is None and have["U95_height_m"] is None


@pytest.fixture
def folding_lens(kept: None, page: Page, demonstration: Server) -> OwnVehicle:
    """The low-light recording on a lens whose polynomial folds back inside the picture; undone afterwards."""
    one = own_vehicle(page)
    recording = page.request.get(f"/api/recordings/{one.vehicle['recording_id']}").json()
    pose = page.request.get(f"/api/poses/{recording['pose_id']}").json()
    lens = page.request.get(f"/api/calibrations/{pose['calibration_id']}").json()["document"]
    board = pose["document"]["board"]
    camera = page.request.post(
        f"/api/surveys/{one.survey}/cameras", headers=HEADERS, data={"name": "Folding lens", "notes": ""}
    ).json()
    made = page.request.post(
        f"/api/cameras/{camera['id']}/calibrations/import",
        headers=HEADERS,
        multipart={"file": {"name": "fold.yaml", "mimeType": "text/yaml", "buffer": opencv_yaml(lens)}},
    )
    assert made.ok, made.text()
    wish = {name: board[name] for name in ("columns", "rows", "square_m", "reference", "reference_height_m")}
    wish |= {"calibration_id": made.json()["id"], "first_frame": 30, "last_frame": 32}
    job = page.request.post(f"/api/recordings/{recording['id']}/poses", headers=HEADERS, data=wish)
    assert job.ok, job.text()
    over = finished(page, job.json())
    assert over["state"] == "done", over
    return one


def opencv_yaml(lens: dict[str, Any]) -> bytes:
    """The lens as OpenCV writes it, with only its first distortion term: one-to-one up to 0.68 f."""
    fx, fy, cx, cy = (float(lens[name]) for name in ("fx_px", "fy_px", "cx_px", "cy_px"))
    return (
        "%YAML:1.0\n---\n"
        f"image_width: {lens['width_px']}\nimage_height: {lens['height_px']}\n"
        "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        f"   data: [{fx}, 0., {cx}, 0., {fy}, {cy}, 0., 0., 1.]\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
        "   data: [-0.32, 0., 0., 0., 0.]\n"
    ).encode()


def test_a_click_outside_the_lens_models_valid_radius_gives_a_reason_and_no_number(
    page: Page, folding_lens: OwnVehicle
) -> None:
    one = folding_lens
    page.goto(one.address)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    on_screen(page, (0, 0))
    page.get_by_test_id("target-roof").click()
    click_at(page, (6, 474))
    expect(page.locator("#measure-hint")).to_contain_text("outside the lens model’s valid radius")
    expect(page.get_by_test_id("axes")).to_have_count(0)
    assert stored(page, one.vehicle["id"]) == {}
