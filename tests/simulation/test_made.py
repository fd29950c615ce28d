"""The demonstration's files are what is drawn, within the loss of their codecs."""

from concurrent.futures import ProcessPoolExecutor
from itertools import islice

import cv2
import numpy as np
import pytest

from sightline.demo.made import FOLDER, LINES, TRUTH, lab_images, strip_of
from sightline.media.images import read_image
from sightline.media.video.decode import frames_of
from tests.simulation.board import LAB_COUNT, lab_image
from tests.simulation.make import (
    RODS,
    SCAN_VEHICLES,
    SITE,
    VIDEOS,
    drawn_frames,
    drawn_strips,
    lab_name,
    scenes,
    strip_name,
    truth_json,
)
from tests.simulation.render import render_frame
from tests.simulation.scan_strips import CHUNK, recording

pytestmark = pytest.mark.once
MOST_BYTES = 12_000_000
# What a codec may take away: grain (root mean square of the pixels), and next to nothing of what is left when
# grain is gone (means of 8 x 8 pixels: their root mean square, and the worst of them).
GRAIN_DN, COARSE_DN, WORST_DN = 5.0, 1.0, 7.0
CHUNKS = 14  # both stands of the rod, and the first vehicle's front


def hold(made: np.ndarray, drawn: np.ndarray) -> None:
    """Both are one image but for what a codec takes away."""
    if drawn.ndim == 3:
        drawn = cv2.cvtColor(drawn, cv2.COLOR_BGR2GRAY)
    assert made.shape == drawn.shape
    apart = made.astype(np.float32) - drawn
    coarse = cv2.resize(apart, (apart.shape[1] // 8, apart.shape[0] // 8), interpolation=cv2.INTER_AREA)
    found = [float(one) for one in (np.std(apart), np.std(coarse), np.abs(coarse).max())]
    assert all(one < most for one, most in zip(found, (GRAIN_DN, COARSE_DN, WORST_DN), strict=True)), found


def test_the_truth_is_what_is_drawn_to_its_last_digit() -> None:
    assert TRUTH.read_text() == truth_json()


def test_all_files_are_there_and_no_other_and_they_are_small() -> None:
    blocks = -(-len(strip_of(1)) // LINES)
    strips = {strip_name(camera, block) for camera in (1, 2) for block in range(blocks)}
    lab = {lab_name(index) for index in range(LAB_COUNT)}
    assert {one.name for one in FOLDER.iterdir()} == {TRUTH.name, *VIDEOS.values(), *strips, *lab}
    assert sum(one.stat().st_size for one in FOLDER.iterdir()) < MOST_BYTES


def test_some_of_it_drawn_anew_is_what_is_there() -> None:
    hold(read_image(lab_images()[3]), lab_image(3))
    for name, scene in scenes().items():
        wanted = (
            scene.board_frames // 2,
            (scene.vehicles[1].first_frame + scene.vehicles[1].last_frame) // 2,
        )
        for n, _, gray in islice(frames_of(FOLDER / VIDEOS[name]), wanted[-1] + 1):
            if n in wanted:
                hold(gray, render_frame(scene, n))
    pairs = list(islice(recording(SITE, SCAN_VEHICLES, rods=RODS), CHUNKS))
    for camera, drawn in enumerate(zip(*pairs, strict=True), 1):
        hold(strip_of(camera)[: CHUNKS * CHUNK], np.concatenate(drawn))


def test_another_picture_is_not_taken_for_it() -> None:
    made, drawn = read_image(lab_images()[3]), lab_image(3)
    for planted in (np.roll(drawn, 1, axis=1), lab_image(4)):
        with pytest.raises(AssertionError):
            hold(made, planted)


@pytest.mark.proof
def test_all_of_it_drawn_anew_is_what_is_there() -> None:
    for index, path in enumerate(lab_images()):
        hold(read_image(path), lab_image(index))
    for camera, drawn in enumerate(drawn_strips(), 1):
        hold(strip_of(camera), drawn)
    with ProcessPoolExecutor() as pool:
        for name, scene in scenes().items():
            made = frames_of(FOLDER / VIDEOS[name])
            for (_, _, gray), drawn in zip(made, drawn_frames(scene, pool), strict=True):
                hold(gray, drawn)
