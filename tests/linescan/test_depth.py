"""The same pixels in 8 bits and in 16 are the same vehicles, whatever the camera's own depth is."""

import numpy as np
import pytest

from sightline.enums import ScanMethod
from sightline.linescan.by_hand import Read, passage_at
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Motion, Pixels
from tests.linescan.scenes import RIG, found, plain, plain_found

pytestmark = pytest.mark.once


def numbers(motion: Motion) -> tuple[float | None, ...]:
    assert motion.status == "ok"
    return motion.speed_mps, motion.u_speed_mps, motion.acceleration_mps2, motion.length_m, motion.u_length_m


def in_16_bits(times: int) -> tuple[Pixels, Pixels]:
    first, second = (np.uint16(times) * strip.astype(np.uint16) for strip in plain())
    return first, second


def read_of(strip: Pixels) -> Read:
    return lambda start, stop: strip[max(start, 0) : stop]


# times 257 sums of grey values round otherwise
DEPTHS = {"as they are": (1, 1e-9), "12 bits": (16, 1e-9), "16 bits": (256, 1e-9), "widened": (257, 1e-5)}


@pytest.mark.parametrize(("times", "rel"), DEPTHS.values(), ids=DEPTHS)
@pytest.mark.parametrize("method", ["direct", "paper"])
def test_the_same_pixels_in_8_and_16_bit_give_the_same_speed(
    method: ScanMethod, times: int, rel: float
) -> None:
    eight, sixteen = plain_found()[0], found(in_16_bits(times))[0]
    assert len(eight) == len(sixteen) == 3
    for one, other in zip(eight, sixteen, strict=True):
        assert numbers(MEASURE[method](other, RIG)) == pytest.approx(
            numbers(MEASURE[method](one, RIG)), rel=rel
        )


def test_a_vehicle_that_is_marked_is_the_same_in_16_bits() -> None:
    crossings = plain_found()[0][0].crossings

    def marked(strips: tuple[Pixels, Pixels]) -> Motion:
        first, second = map(read_of, strips)
        return MEASURE["direct"](passage_at(crossings, RIG, strips[0].shape[1], (first, second)), RIG)

    assert numbers(marked(in_16_bits(256))) == pytest.approx(numbers(marked(plain())), rel=1e-9)
