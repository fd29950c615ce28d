"""The demonstration's clicks: the same on every start, whichever rows were stored before them."""

from types import SimpleNamespace
from typing import Any

import pytest

from sightline.demo import clicks
from sightline.demo.made import truth

Made = dict[tuple[str, str], Any]


def made_from(first_id: int, monkeypatch: pytest.MonkeyPatch) -> Made:
    """What is clicked, by whom, where the ids of vehicles and measurements begin at `first_id`."""
    ids, found = iter(range(first_id, first_id + 1000)), Made()

    def store(_session: object, vehicle_id: int, _key: str, clicked: Any, *, actor: int) -> Any:
        found[(str(vehicle_id - first_id), clicked.target)] = clicked
        return SimpleNamespace(id=next(ids), revision=1, values=clicked)

    def review(_session: object, id_: int, *, verdict: str, **said: Any) -> None:
        if verdict == "fixed":
            found[(verdict, str(len(found)))] = (said["contact"], said["target_point"])

    monkeypatch.setattr(clicks, "store_measurement", store)
    monkeypatch.setattr(clicks, "review", review)
    monkeypatch.setattr(clicks, "add_review", lambda *_who, **_said: None)
    passes: list[clicks.Pass] = []
    for video, scene in enumerate(truth().scenes.values()):
        of_video = [
            clicks.Pass(SimpleNamespace(id=next(ids)), one, scene.fps, (video, number))  # type: ignore[arg-type]
            for number, one in enumerate(scene.passes)
        ]
        passes += clicks.with_fates(of_video, faults=video == 0)
    session: Any = None
    clicks.judge(session, passes, clicks.measure(session, passes, actor=1), actor=2)
    return found


def test_clicks_are_the_same_whatever_the_ids(monkeypatch: pytest.MonkeyPatch) -> None:
    found = made_from(1, monkeypatch)
    assert any(key == "fixed" for key, _ in found)
    assert any(one.more_frames for one in found.values() if not isinstance(one, tuple))
    assert made_from(651, monkeypatch) == found
