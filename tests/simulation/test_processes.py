"""The demonstration's pictures are drawn by several processes: whole, in order, and the same as by one."""

import numpy as np
import pytest

from sightline.demo.rendering import chunks_of, rendered, scene_named
from sightline.simulation.render import render_frame


def test_the_work_is_shared_out_whole_and_in_order() -> None:
    for name in ("day", "low_light", "day:1"):
        scene = scene_named(name)
        chunks = chunks_of(scene)
        assert [n for chunk in chunks for n in chunk] == list(range(scene.frames))
        assert max(map(len, chunks)) < 150


def test_processes_give_the_frames_that_one_process_gives(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sightline.demo.rendering.AHEAD", 2)  # each would draw far more than is looked at
    scene = scene_named("day:1")
    frames = rendered("day:1", processes=2)
    shared = [next(frames) for _ in range(34)]
    frames.close()
    for n in (0, 31, 32, 33):
        assert np.array_equal(shared[n], render_frame(scene, n)), n
