"""The scenes' timetable, the catalogue and the truth document."""

import json
import pickle
from collections import Counter

import numpy as np
import pytest

from sightline.demo.made import SOURCE, catalogue
from tests.simulation import truth
from tests.simulation.models import MODELS
from tests.simulation.picture import frame_of, height_m
from tests.simulation.scene import Scene, day_scene, low_light_scene
from tests.simulation.truth import truth_document

SCENES = pytest.mark.parametrize("scene", [day_scene(), low_light_scene()], ids=lambda s: s.name)


def test_both_videos_hold_what_the_survey_promises() -> None:
    day, low = day_scene(), low_light_scene()
    assert (len(day.vehicles), len(low.vehicles)) == (24, 16)
    for scene in (day, low):
        shapes = Counter(v.model.category for v in scene.vehicles)
        assert set(shapes) == {"hatchback", "saloon", "estate", "suv", "van", "lorry"}
        assert {v.lane for v in scene.vehicles} == {"near", "far"}
        assert scene.board_frames / scene.fps == pytest.approx(4.0)
    assert day.frames + low.frames < 2600


@SCENES
def test_passes_come_one_after_another(scene: Scene) -> None:
    for before, after in zip(scene.vehicles, scene.vehicles[1:], strict=False):
        assert before.last_frame < after.first_frame
    assert scene.vehicles[0].first_frame > scene.board_frames
    assert scene.vehicles[-1].last_frame < scene.frames


@SCENES
def test_every_vehicle_can_be_measured(scene: Scene) -> None:
    for one in truth(scene):
        assert set(one.best_frames) == {"roof", "driver_eye", "taillight"}
        for name, number in one.best_frames.items():
            frame = frame_of(one, number)
            assert frame.shows(name)
            assert frame.contact is not None
        assert one.first_whole_frame is not None
        assert one.last_whole_frame is not None
        assert one.last_whole_frame - one.first_whole_frame >= 3


@SCENES
def test_two_exact_clicks_with_the_true_inset_give_the_true_height(scene: Scene) -> None:
    for one in truth(scene):
        for name, number in one.best_frames.items():
            frame, spot = frame_of(one, number), one.spot(name)
            assert frame.contact is not None
            got = height_m(scene.camera, frame.pixels[frame.contact], frame.pixels[name], spot.inset_m)
            assert got == pytest.approx(spot.height_m, abs=1e-9)


@SCENES
def test_true_roof_is_near_the_makers_height_but_not_equal(scene: Scene) -> None:
    gaps = [one.spot("roof").height_m - one.vehicle.model.height_m for one in truth(scene)]
    assert max(abs(g) for g in gaps) <= 0.021
    assert 0.003 < np.std(gaps) < 0.015


def test_the_far_lane_drivers_sit_on_the_cameras_side() -> None:
    for one in truth(day_scene()):
        inset = one.spot("driver_eye").inset_m
        assert (inset < 0.6) == (one.vehicle.lane == "far") == (one.vehicle.driver_side == "near")


@SCENES
def test_roofs_stand_above_the_camera_so_that_the_near_edge_is_the_silhouette(scene: Scene) -> None:
    assert all(one.spot("roof").height_m > scene.camera.centre_m[2] + 0.03 for one in truth(scene))


def test_documents_are_plain_json_and_scenes_travel_to_processes() -> None:
    document = json.loads(json.dumps(truth_document(day_scene()), allow_nan=False))
    assert len(document["passes"]) == 24
    assert document["board"]["columns"] % 2 != document["board"]["rows"] % 2
    assert pickle.loads(pickle.dumps(day_scene())) == day_scene()


def test_catalogue_rows_are_invented_and_say_so() -> None:
    rows = catalogue()
    assert len(rows) == len(MODELS) and all(row.source == SOURCE for row in rows)
    assert len({(row.make, row.model) for row in rows}) == len(rows)
    assert all((row.wheelbase_m or 9.0) < (row.length_m or 0.0) for row in rows)
