"""What is drawn lies where the truth says: lamps, tyres, roofs and eyes, found by looking at the picture."""

import numpy as np
import pytest

from tests.simulation import truth
from tests.simulation.compose import Place
from tests.simulation.glow import add_glow
from tests.simulation.picture import edge_along_column, frame_of
from tests.simulation.render import render_frame
from tests.simulation.scene import Scene, day_scene, low_light_scene
from tests.simulation.shape import shape_of
from tests.simulation.truth import PassTruth

DAY, LOW = day_scene(), low_light_scene()
CASES = [(DAY, k) for k in (0, 1, 2, 4, 6, 9, 11, 12, 15, 20)] + [(LOW, k) for k in (0, 1, 3, 5, 6, 9)]


@pytest.fixture(scope="module", params=CASES, ids=lambda c: f"{c[0].name}-{c[1] + 1}")
def seen(request: pytest.FixtureRequest) -> tuple[Scene, PassTruth, np.ndarray]:
    scene, index = request.param
    one = truth(scene)[index]
    return scene, one, render_frame(scene, one.best_frames["taillight"]).astype(float)


def _reach(one: PassTruth) -> int:
    return 6 if one.vehicle.lane == "near" else 4


def test_tail_lamps_lower_edge(seen: tuple[Scene, PassTruth, np.ndarray]) -> None:
    _, one, image = seen
    x, y = frame_of(one, one.best_frames["taillight"]).pixels["taillight"]
    red = image[..., 2] - image[..., :2].mean(-1)
    assert red[round(y) - 5 : round(y) - 1, round(x)].mean() > 55, "the lamp glows above its lower edge"
    assert edge_along_column(red, x, y, _reach(one)) == pytest.approx(y, abs=0.7)


def test_tyre_meets_the_road(seen: tuple[Scene, PassTruth, np.ndarray]) -> None:
    _, one, image = seen
    frame = frame_of(one, one.best_frames["taillight"])
    assert frame.contact is not None
    x, y = frame.pixels[frame.contact]
    grey = image.mean(-1)
    assert grey[round(y) - 3, round(x)] < 0.72 * grey[round(y) + 4, round(x)], "dark tyre above lit road"
    assert edge_along_column(grey, x, y, _reach(one)) == pytest.approx(y, abs=0.75)


def test_driver_has_an_eye_at_the_true_place() -> None:
    for scene, index in ((DAY, 0), (DAY, 2), (DAY, 7), (DAY, 8), (DAY, 13)):
        one = truth(scene)[index]
        number = one.best_frames["driver_eye"]
        x, y = frame_of(one, number).pixels["driver_eye"]
        grey = render_frame(scene, number).astype(float).mean(-1)
        r = 3
        patch = grey[round(y) - r : round(y) + r + 1, round(x) - r : round(x) + r + 1]
        dark = np.clip(np.median(patch) - 6 - patch, 0, None)
        row, column = np.unravel_index(dark.argmax(), dark.shape)
        assert abs(round(x) - r + column - x) <= 1.2
        assert abs(round(y) - r + row - y) <= 1.2


def test_roof_edge_is_where_the_picture_changes_from_the_empty_road() -> None:
    errors = []
    for scene, indices in ((DAY, (0, 4, 6, 10, 11, 12, 13, 17)), (LOW, (1, 7, 13))):
        empty = render_frame(scene, scene.vehicles[0].first_frame - 2).astype(float)
        for index in indices:
            one = truth(scene)[index]
            number = one.best_frames["roof"]
            x, y = frame_of(one, number).pixels["roof"]
            change = np.abs(render_frame(scene, number) - empty).sum(-1)
            contrast = change[round(y) + 4, round(x)] - change[round(y) - 4, round(x)]
            if contrast > 80:
                errors.append(edge_along_column(change, x, y, 5) - y)
    assert len(errors) >= 6
    assert abs(float(np.median(errors))) < 0.35
    assert float(np.quantile(np.abs(errors), 0.8)) < 0.8


def test_lamps_bloom_around_themselves() -> None:
    one = truth(LOW)[0]
    number = one.best_frames["taillight"]
    frame = np.zeros((480, 640, 3), np.float32)
    vehicle = one.vehicle
    place = Place(vehicle.rear_m(number), vehicle.direction, vehicle.side_plane_m)
    add_glow(frame, LOW.camera, shape_of(vehicle), place)
    x, y = (round(v) for v in frame_of(one, number).pixels["taillight"])
    near, far = frame[y - 12, x], frame[y + 24, x]
    assert near[2] > 25 and near[2] > 3 * near[0], "red"
    assert far[2] < 0.25 * near[2], "and soon gone"


def test_frames_are_pure_and_out_of_range_is_refused() -> None:
    first = render_frame(LOW, 170)
    render_frame(DAY, 170)
    np.testing.assert_array_equal(first, render_frame(LOW, 170))
    assert first.shape == (480, 640, 3) and first.dtype == np.uint8
    assert not np.array_equal(first, render_frame(LOW, 171)), "noise and motion differ from frame to frame"
    with pytest.raises(IndexError, match="frames 0 to"):
        render_frame(DAY, DAY.frames)
    with pytest.raises(IndexError):
        render_frame(DAY, -1)


def test_low_light_is_darker_and_noisier() -> None:
    def empty(scene: Scene) -> tuple[float, float]:
        a, b = (render_frame(scene, scene.vehicles[0].first_frame - k).astype(float) for k in (2, 3))
        return float(a.mean()), float((a - b)[200:300].std())

    (day_tone, day_noise), (low_tone, low_noise) = empty(DAY), empty(LOW)
    assert low_tone < 0.5 * day_tone
    assert low_noise > 1.5 * day_noise
