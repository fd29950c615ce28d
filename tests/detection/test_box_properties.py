"""Boxes: what two share lies in both, and what is around all holds each."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sightline.detection.blobs import Box, bounding_union, boxes_of, intersection_area


@st.composite
def boxes(draw: st.DrawFn) -> Box:
    x0, y0 = draw(st.integers(0, 100)), draw(st.integers(0, 80))
    width, height = draw(st.integers(1, 60)), draw(st.integers(1, 40))
    return Box(x0, y0, x0 + width, y0 + height, width * height)


@given(one=boxes(), other=boxes())
def test_the_shared_area_is_that_of_the_pixels_in_both(one: Box, other: Box) -> None:
    canvas = np.zeros((2, 200, 200), bool)
    for layer, box in enumerate((one, other)):
        canvas[layer, int(box.y0) : int(box.y1), int(box.x0) : int(box.x1)] = True
    assert intersection_area(one, other) == intersection_area(other, one) == (canvas[0] & canvas[1]).sum()


@given(several=st.lists(boxes(), min_size=1, max_size=6))
def test_the_box_around_all_is_the_smallest_that_holds_each(several: list[Box]) -> None:
    around = bounding_union(several)
    assert all(intersection_area(around, box) == (box.x1 - box.x0) * (box.y1 - box.y0) for box in several)
    assert around.x0 in {box.x0 for box in several} and around.y1 in {box.y1 for box in several}
    assert bounding_union([around, *several]).x1 == around.x1


@given(x=st.integers(2, 90), y=st.integers(2, 60), width=st.integers(20, 60), height=st.integers(20, 50))
def test_a_full_rectangle_is_found_where_it_is(x: int, y: int, width: int, height: int) -> None:
    mask = np.zeros((120, 160), np.uint8)
    mask[y : y + height, x : x + width] = 255
    (found,) = boxes_of(mask, mask)
    assert (found.x0, found.y0, found.x1, found.y1) == (x, y, x + width, y + height)
