"""Vehicle passes in a drawn street; the demonstration's videos are searched by bench_passes.py."""

from pathlib import Path

import numpy as np
import pytest

from sightline.detection.background import densest_level
from sightline.detection.classify import FoundPass
from sightline.detection.finder import PassFinder, downsample
from sightline.errors import Stopped
from sightline.media.video.passes import find_passes
from sightline.media.video.writer import write_mp4
from tests.media.street import HEIGHT, WIDTH, Mover, car, street, texture, walker

RATE_HZ = 30.0


def found(count: int, movers: list[Mover], **street_options: float) -> tuple[FoundPass, ...]:
    finder = PassFinder((WIDTH, HEIGHT), RATE_HZ)
    for n, gray in enumerate(street(count, movers, **street_options)):  # type: ignore[arg-type]
        finder.offer(downsample(n, gray))
    return finder.finish()


def assert_is(one: FoundPass, mover: Mover) -> None:
    """Its span, its direction, and a best frame on which all of it is in view."""
    there = [n for n in range(1000) if mover.in_view(n)]
    assert abs(one.first_frame - there[0]) <= 2 and abs(one.last_frame - there[-1]) <= 3, one
    assert one.direction == ("right" if mover.step_px > 0 else "left")
    assert one.whole and mover.whole(one.best_frame), one
    middle = mover.left(one.best_frame) + mover.width_px / 2
    assert abs(middle - WIDTH / 2) < 0.2 * WIDTH, one


def test_each_car_is_one_pass_with_its_span_direction_and_best_frame() -> None:
    cars = [car(30), car(80, right=False, near=False, grey=40), car(125, grey=60)]
    passes = found(190, cars)
    assert len(passes) == 3
    for one, mover in zip(passes, cars, strict=True):
        assert_is(one, mover)
        assert one.score > 0.9 and any(box[0] == one.best_frame for box in one.boxes)


def test_two_cars_that_meet_are_two_passes() -> None:
    cars = [car(60), car(62, right=False, near=False, grey=40)]
    passes = found(150, cars)
    assert sorted(one.direction or "" for one in passes) == ["left", "right"]


def test_light_that_flickers_a_board_and_somebody_on_foot_are_no_passes() -> None:
    movers = [walker(20), car(150)]
    passes = found(240, movers, flicker=0.08, board_until=60)
    assert len(passes) == 1
    assert_is(passes[0], movers[1])


def test_the_light_before_a_car_is_not_the_car() -> None:
    dark = car(60, grey=70, headlight=True)
    passes = found(150, [dark], level=0.3)
    assert len(passes) == 1
    assert_is(passes[0], dark)
    assert passes[0].luminance < 60


@pytest.mark.parametrize("quarters", [1, 2, 3])
def test_a_picture_on_its_side_has_the_same_passes(tmp_path: Path, quarters: int) -> None:
    cars = [car(15), car(55, right=False, near=False, grey=40)]
    path = tmp_path / "turned.mp4"
    frames = (np.ascontiguousarray(np.rot90(gray, quarters)) for gray in street(100, cars))
    write_mp4(path, (np.repeat(gray[..., None], 3, 2) for gray in frames), 30, crf=18)
    passes = find_passes(path).passes
    assert len(passes) == 2
    for one, mover in zip(passes, cars, strict=True):
        there = [n for n in range(1000) if mover.in_view(n)]
        assert abs(one.first_frame - there[0]) <= 3 and abs(one.last_frame - there[-1]) <= 4
        assert one.direction == {1: None, 2: "left" if mover.step_px > 0 else "right", 3: None}[quarters]


def test_a_train_is_one_vehicle_and_a_queue_is_several() -> None:
    train = texture(1400, 120, 2)
    finder = PassFinder((WIDTH, HEIGHT), RATE_HZ)
    for n, gray in enumerate(street(180, [])):
        at = 14 * (n - 30)  # its front; the whole of it takes 3.3 s
        shown = slice(max(0, at - 1400), min(WIDTH, max(0, at)))
        gray[80:200, shown] = train[:, [1400 - at + x for x in range(shown.start, shown.stop)]]
        finder.offer(downsample(n, gray))
    assert [(one.direction, one.whole) for one in finder.finish()] == [("right", False)]
    queue = [car(first, grey=grey) for first, grey in ((10, 210), (28, 60), (46, 190), (64, 40))]
    assert len(found(130, queue)) == 4


def test_an_empty_street_has_no_passes() -> None:
    assert found(90, []) == ()


def test_the_road_is_found_though_it_is_hidden_for_most_of_the_time() -> None:
    rng = np.random.default_rng(1)
    values = rng.uniform(0, 255, (90, 4, 5))
    values[::5] = values[1::5] = 100.0
    assert np.abs(densest_level(values.astype(np.uint8)) - 100).max() <= 3


def test_a_video_is_read_once_and_can_be_cancelled(tmp_path: Path) -> None:
    path = tmp_path / "street.mp4"
    mover = car(20)
    write_mp4(path, (np.repeat(g[..., None], 3, 2) for g in street(70, [mover])), 30, crf=18)
    told: list[float] = []
    search = find_passes(path, on_progress=told.append)
    passes, frames = search.passes, search.frames
    assert frames == 70 and len(passes) == 1 and told == sorted(told) and told[-1] == 1.0
    assert_is(passes[0], mover)
    with pytest.raises(Stopped, match="cancelled"):
        find_passes(path, is_cancelled=lambda: True)
