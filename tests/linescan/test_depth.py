"""The same pixels in 8 bits and in 16 are the same vehicles, whatever the camera's own depth is."""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from sightline.enums import ScanMethod
from sightline.linescan.by_hand import Read, passage_at
from sightline.linescan.finding import Finder
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Motion, Passage, Pixels
from tests.linescan.scenes import RIG, SITE, Strips, cars, found
from tests.simulation.scan_strips import strips

pytestmark = pytest.mark.once


@lru_cache(maxsize=1)
def plain() -> Strips:
    """Of another seed than `scenes.plain`: a vehicle is first found by means of cells, which 8 bits round to
    whole grey values; there a rear comes out a step later in 16 bits, here no front and no rear.
    """
    return strips(replace(SITE, seed=2), cars())


@lru_cache(maxsize=1)
def plain_found() -> tuple[list[Passage], Finder]:
    return found(plain())


def numbers(motion: Motion) -> tuple[float | None, ...]:
    assert motion.status == "ok"
    return motion.speed_mps, motion.u_speed_mps, motion.acceleration_mps2, motion.length_m, motion.u_length_m


@lru_cache(maxsize=2)
def in_8_bits(method: ScanMethod) -> list[tuple[float | None, ...]]:
    """What is measured of the three vehicles."""
    return [numbers(MEASURE[method](one, RIG)) for one in plain_found()[0]]


def in_16_bits(times: int) -> tuple[Pixels, Pixels]:
    first, second = (np.uint16(times) * strip.astype(np.uint16) for strip in plain())
    return first, second


def read_of(strip: Pixels) -> Read:
    return lambda start, stop: strip[max(start, 0) : stop]


# times 257 sums of grey values round otherwise, to which u of the fit answers most: by 1.1e-5 of itself
DEPTHS = {"as they are": (1, 1e-9), "12 bits": (16, 1e-9), "16 bits": (256, 1e-9), "widened": (257, 2e-5)}


@pytest.mark.parametrize(("times", "rel"), DEPTHS.values(), ids=DEPTHS)
@pytest.mark.parametrize("method", ["direct", "paper"])
def test_the_same_pixels_in_8_and_16_bit_give_the_same_speed(
    method: ScanMethod, times: int, rel: float
) -> None:
    eight, sixteen = in_8_bits(method), found(in_16_bits(times))[0]
    assert len(eight) == len(sixteen) == 3
    for one, other in zip(eight, sixteen, strict=True):
        assert numbers(MEASURE[method](other, RIG)) == pytest.approx(one, rel=rel)


def test_a_vehicle_that_is_marked_is_the_same_in_16_bits() -> None:
    crossings = plain_found()[0][0].crossings

    def marked(strips: tuple[Pixels, Pixels]) -> Motion:
        first, second = map(read_of, strips)
        return MEASURE["direct"](passage_at(crossings, RIG, strips[0].shape[1], (first, second)), RIG)

    assert numbers(marked(in_16_bits(256))) == pytest.approx(numbers(marked(plain())), rel=1e-9)


def test_a_dark_vehicle_of_a_12_bit_camera_is_on_the_scale_of_its_strip() -> None:
    """Its own brightest pixel would tell a camera of 10 bits."""
    crossings = plain_found()[0][0].crossings
    strips = [
        np.uint16(3) * (strip // 2).astype(np.uint16) for strip in plain()
    ]  # up to 381: "10 bits" alone
    reads = read_of(strips[0]), read_of(strips[1])
    alone, told = (passage_at(crossings, RIG, strips[0].shape[1], reads, bits) for bits in (8, 12))
    assert [int(one.first.max()) for one in (alone, told)] == [
        int(strips[0][alone.start_1 :][: len(alone.first)].max()) >> drop for drop in (2, 4)
    ]
    assert told.noise_dn == pytest.approx(alone.noise_dn / 4)
    seen = Finder(strips[0].shape[1], RIG)
    seen.push(strips[0][:64], strips[1][:64])
    assert seen.bits == 10
    bright = strips[0][64:128].copy()
    bright[0, 0] = 3000
    seen.push(bright, strips[1][64:128])
    seen.push(strips[0][128:192], strips[1][128:192])
    assert seen.bits == 12
