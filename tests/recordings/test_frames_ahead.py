"""Frames made ready before they are asked for, and work given up when nobody waits for it."""

import asyncio

import pytest
from starlette.requests import Request

from sightline.infra.web.disconnect import CancelCheck, run_unless_cancelled
from sightline.vehicles.passes import prefetch
from tests.support.app import Client
from tests.support.waiting import NEVER_S, until

pytestmark = pytest.mark.once


def test_frames_around_passes_are_ready_before_they_are_asked_for(
    operator: Client, recording_id: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prefetch, "QUIET_S", 0.05)
    span = {"first_frame": 7, "last_frame": 11, "best_frame": 9}
    operator.made(f"/recordings/{recording_id}/vehicles", span)
    assert operator.seen(f"/recordings/{recording_id}/frames/ready") == {"runs": []}
    assert operator.get(f"/recordings/{recording_id}/frames/1.jpg").status_code == 200

    def ready() -> list[list[int]]:
        return list(operator.seen(f"/recordings/{recording_id}/frames/ready")["runs"])

    until(lambda: [7, 11] in ready(), ready)
    assert ready() == [[0, 1], [7, 11]], "what was decoded on the way to frame 1, and the pass"


def waiting_browser() -> Request:
    async def receive() -> dict[str, str]:
        await asyncio.sleep(NEVER_S)
        return {"type": "http.disconnect"}

    return Request({"type": "http", "headers": []}, receive)


def test_work_that_nobody_waits_for_is_told() -> None:
    def work(wanted: CancelCheck) -> str:
        until(lambda: not wanted(), lambda: "done for nobody")
        return "gave up"

    looks = iter([False, False, True])

    class Leaving(Request):
        async def is_disconnected(self) -> bool:
            return next(looks)

    leaving = Leaving({"type": "http", "headers": []})
    assert asyncio.run(run_unless_cancelled(leaving, work)) == "gave up"


def test_an_error_comes_through() -> None:
    def work(_wanted: object) -> None:
        raise ValueError("bad")

    with pytest.raises(ValueError, match="bad"):
        asyncio.run(run_unless_cancelled(waiting_browser(), work))
