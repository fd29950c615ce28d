"""What comes to a line-scan recording and is refused, cancelled or cut from a video: a sentence each."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from sightline.infra.audit.verification import verify_records
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.recovery import take_back
from sightline.infra.jobs.store import claim_job, queued_jobs
from sightline.infra.services import Services
from sightline.media.video.writer import write_mp4
from tests.media.clips import tagged
from tests.support.app import Client, error_of, upload
from tests.support.scanning_ground import RIG, pictures, tiff, upload_strip

Work = Callable[[], list[Job]]
Picture = NDArray[np.uint8]


def strip(client: Client, survey_id: int, folder: Path, lines: Any, name: str) -> int:
    return upload_strip(client, survey_id, tiff(folder / name, lines), name)


def test_strips_that_cannot_be_are_refused_in_words(
    operator: Client, survey_id: int, tmp_path: Path, work: Work, clip: Path, services: Services
) -> None:
    first, second, _ = pictures()
    one = strip(operator, survey_id, tmp_path, first[:2000], "one.tif")
    short = strip(operator, survey_id, tmp_path, second[:1500], "short.tif")
    twin = strip(operator, survey_id, tmp_path, first[:2000], "twin.tif")
    video = upload_strip(operator, survey_id, clip.read_bytes(), "road.mp4")
    address = f"/surveys/{survey_id}/scans"
    waiting = operator.seen(f"/surveys/{survey_id}/strip-uploads")
    assert [upload["id"] for upload in waiting] == [one, short, twin, video]

    def refused(body: dict[str, object]) -> str:
        return error_of(operator.post(address, {**RIG, **body}))

    assert "same upload" in refused({"first_upload": one, "second_upload": one})
    assert "are the same image" in refused({"first_upload": one, "second_upload": twin})
    assert "no upload 999" in refused({"first_upload": one, "second_upload": 999})
    assert "baseline_m" in refused({"first_upload": one, "second_upload": short, "baseline_m": 0})

    uneven = operator.made(address, {**RIG, "first_upload": one, "second_upload": short})
    no_strip = operator.made(address, {**RIG, "first_upload": twin, "second_upload": video})
    taken = refused({"first_upload": one, "second_upload": short})
    assert "belongs to a line-scan recording already" in taken
    assert [job.state for job in work()] == ["failed", "failed"]
    said = operator.seen(f"/scans/{uneven['id']}")
    assert said["state"] == "failed" and "2000 lines and short.tif 1500" in said["error"]["message"]
    assert "road.mp4" in operator.seen(f"/scans/{no_strip['id']}")["error"]["message"]
    assert "could not be imported" in error_of(operator.post(f"/scans/{uneven['id']}/find", {}))
    assert "could not be imported" in error_of(operator.get(f"/scans/{uneven['id']}/tiles/1/0/0"))
    for made in (uneven, no_strip):
        assert operator.delete(f"/scans/{made['id']}").status_code == 204
    assert [job.state for job in work()] == ["done", "done"]
    # the twin of what was read is gone with both, and so is everything else
    assert not [path for path in (services.settings.data_dir / "media").rglob("*") if path.is_file()]
    with services.reading() as session:
        assert verify_records(session).ok


def test_a_reading_is_cancelled_and_a_dead_worker_leaves_nothing(
    operator: Client, survey_id: int, tmp_path: Path, work: Work, services: Services
) -> None:
    first, second, _ = pictures()
    body = {
        **RIG,
        "first_upload": strip(operator, survey_id, tmp_path, first[:1200], "a.tif"),
        "second_upload": strip(operator, survey_id, tmp_path, second[:1200], "b.tif"),
        "find": None,
    }
    made = operator.made(f"/surveys/{survey_id}/scans", body)
    operator.made(f"/jobs/{made['job']['id']}/cancel")
    stopped = operator.seen(f"/scans/{made['id']}")
    assert stopped["state"] == "failed" and "was cancelled" in stopped["error"]["message"]
    operator.made(f"/scans/{made['id']}/read")
    _die_once(services)
    again = operator.seen(f"/scans/{made['id']}")
    assert (again["state"], again["lines"], again["job"]["state"]) == ("reading", None, "queued")
    assert [job.state for job in work()] == ["done"]
    assert operator.seen(f"/scans/{made['id']}")["state"] == "ready"


def _die_once(services: Services) -> None:
    """A worker takes the job and is never heard of again; its supervisor puts it back."""
    with services.writing() as session:
        (job_id,) = queued_jobs(session)
        assert claim_job(session, job_id, worker="gone") is not None
    assert take_back(services.sessions, worker="gone") == 1


def test_two_columns_or_rows_of_a_video_are_a_scan(
    operator: Client, survey_id: int, tmp_path: Path, work: Work
) -> None:
    path = tmp_path / "bar.mp4"
    write_mp4(path, (_bar(n) for n in range(60)), 25, crf=10, gop=12)
    recording = upload(operator, survey_id, path)
    work()
    body = {"recording_id": recording, "cut_1_px": 40, "cut_2_px": 100, "baseline_m": 1.5}
    address = f"/surveys/{survey_id}/scans/from-video"
    outside = operator.post(address, {**body, "cut_2_px": 999})
    assert "Columns 40 and 999 cannot be cut" in error_of(outside)
    made = operator.made(address, {**body, "find": None})
    assert made["rig"]["line_rate_hz"] == pytest.approx(25)
    assert [job.state for job in work()] == ["done"]
    read = operator.seen(f"/scans/{made['id']}")
    assert (read["state"], read["lines"], read["rows_px"]) == ("ready", 60, 120)
    assert read["cut_along"] == "columns"
    along = {**body, "cut_along": "rows_right_up"}
    assert "Rows 40 and 120 cannot be cut" in error_of(operator.post(address, {**along, "cut_2_px": 120}))
    turned = operator.made(address, {**along, "find": None})
    assert turned["name"].endswith("rows 40 and 100")
    assert [job.state for job in work()] == ["done"]
    read = operator.seen(f"/scans/{turned['id']}")
    assert (read["state"], read["cut_along"], read["rows_px"]) == ("ready", "rows_right_up", 160)


def test_slow_motion_is_no_line_scan(operator: Client, survey_id: int, tmp_path: Path, work: Work) -> None:
    """Filmed at 120, played at 30: a line scan of it would have a quarter of its line rate."""
    slow = tagged(tmp_path / "slow.mp4", {"com.android.capture.fps": "120.0"})
    recording = upload(operator, survey_id, slow)
    work()
    said = operator.seen(f"/recordings/{recording}")
    assert said["state"] == "ready"
    assert any("filmed at 120 frames per second; it plays 30" in note["message"] for note in said["notes"])
    body = {"recording_id": recording, "cut_1_px": 40, "cut_2_px": 100, "baseline_m": 1.5, "find": None}
    refused = operator.post(f"/surveys/{survey_id}/scans/from-video", body)
    assert refused.status_code == 422
    assert "time stamps of slow.mp4 are not the times of filming" in error_of(refused)
    assert operator.seen(f"/surveys/{survey_id}/scans") == []


def _bar(n: int) -> Picture:
    picture = np.full((120, 160, 3), 90, np.uint8)
    picture[30:90, max(0, 3 * n - 40) : max(0, 3 * n)] = 220
    return picture
