"""The driver's side against a road laid out with vectors, which shares nothing with the rule."""

from itertools import product
from typing import get_args

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.enums import CameraPlace, Category, Direction, DriverSide, Hand, InsetName, Target
from sightline.geometry.insets import USUAL_INSETS, inset_name, target_of
from sightline.geometry.sides import FoundSide, TrafficFacts, direction_beside_camera, driver_side

UP = np.array([0.0, 0.0, 1.0])
CAMERA = np.array([0.0, -5.0, 1.4])  # looks along +Y; X is to the right in its picture
hands, places = st.sampled_from(get_args(Hand)), st.sampled_from(get_args(CameraPlace))


def distance_to_driver(forward: np.ndarray, steering: Hand) -> float:
    """How far the camera is from a driver who sits half a metre beside the middle of a vehicle."""
    left = np.cross(UP, forward)
    seat = 0.5 * (left if steering == "left" else -left)
    return float(np.linalg.norm(CAMERA - seat))


@given(steering=hands, direction=st.sampled_from(get_args(Direction)), traffic=hands, place=places)
def test_near_is_the_side_that_is_nearer_to_the_camera(
    steering: Hand, direction: Direction, traffic: Hand, place: CameraPlace
) -> None:
    forward = np.array([1.0 if direction == "right" else -1.0, 0.0, 0.0])
    nearer = distance_to_driver(forward, steering) < np.linalg.norm(CAMERA)
    found = driver_side(None, direction, TrafficFacts(traffic, steering, place))
    assert found == FoundSide("near" if nearer else "far", "direction")


@given(traffic=hands, place=places)
def test_the_lane_beside_the_camera_goes_as_its_carriageway_does(traffic: Hand, place: CameraPlace) -> None:
    """Whoever keeps right has the verge on the right and the median on the left; the camera stands there."""
    ways = {}
    for direction, x in (("right", 1.0), ("left", -1.0)):
        left = np.cross(UP, np.array([x, 0.0, 0.0]))
        verge = -left if traffic == "right" else left
        ways[direction] = verge if place == "verge" else -verge
    beside = [name for name, towards in ways.items() if towards @ CAMERA > 0]
    assert [direction_beside_camera(TrafficFacts(traffic, None, place))] == beside


def test_what_was_said_of_the_vehicle_comes_first_and_without_facts_there_is_none() -> None:
    whole = TrafficFacts("right", "left", "verge")
    assert driver_side("near", "right", whole) == FoundSide("near", "said")
    assert driver_side(None, None, whole) is None  # it may be in the opposite lane
    assert driver_side(None, None, TrafficFacts("right", "left", "median")) == FoundSide("near", "place")
    assert driver_side(None, "left", TrafficFacts(None, "left", None)) == FoundSide("near", "direction")
    assert driver_side(None, None, TrafficFacts("right", "left", None)) is None
    assert driver_side(None, "right", TrafficFacts("right", None, "verge")) is None


def test_only_an_eye_needs_a_side_and_every_inset_has_its_target() -> None:
    assert inset_name("driver_eye", None, None) is None
    everything = product(get_args(Target), get_args(DriverSide), (None, *get_args(Category)))
    named = set[InsetName]()
    for target, side, category in everything:
        name = inset_name(target, side, category)
        assert name is not None and target_of(name) == (target, side if target == "driver_eye" else None)
        named.add(name)
    assert named == set(get_args(InsetName)) == set(USUAL_INSETS)
    near, far = USUAL_INSETS["driver_eye_near"], USUAL_INSETS["driver_eye_far"]
    assert near[:2] == pytest.approx((0.45, 0.10)) and far[:2] == pytest.approx((1.15, 0.15))


def test_a_box_has_its_roof_above_its_tyres_and_an_unknown_class_is_less_certain() -> None:
    assert inset_name("roof", None, "suv") == "roof" and inset_name("roof", None, "bus") == "roof_box"
    assert inset_name("roof", None, "van") == "roof_van"
    assert inset_name("roof", None, None) == inset_name("roof", None, "other") == "roof_unknown"
    car, box, unknown = (USUAL_INSETS[name] for name in ("roof", "roof_box", "roof_unknown"))
    assert box[0] < 0.05 and abs(car[0] - box[0]) < 2 * unknown[1] and unknown[1] > car[1]
