"""Real trains, a line a frame: far too coarse to be measured, and that is the reason that is given."""

import os
from pathlib import Path

import numpy as np
import pytest

from sightline.linescan.finding import Finder
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Rig
from tests.bench.bench_trains import BASELINES_PX, PX_PER_M, TRAINS, Train, passage, read

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("SIGHTLINE_SHARED_DATA") or ROOT.parent / "shared" / "data") / "linescan"

pytestmark = [
    pytest.mark.skipif(not DATA.exists(), reason="the shared data folder is not here"),
    pytest.mark.once,
]


@pytest.mark.parametrize("train", TRAINS, ids=lambda train: train.file)
def test_lines_too_far_apart_are_refused_with_how_far_and_the_rate_that_would_do(train: Train) -> None:
    frames, rate_hz = read(DATA / train.file)
    known_mm = 1000 * train.speed_px_s / PX_PER_M / rate_hz
    for baseline_px in BASELINES_PX:
        reason = MEASURE["direct"](
            passage(train, frames, baseline_px), Rig(baseline_px / PX_PER_M, rate_hz)
        ).reason
        assert reason is not None and reason.code == "scan-motion-too-coarse"
        assert reason.values["line_mm"] == pytest.approx(known_mm, rel=0.05)
        assert 2500 <= reason.values["rate_hz"] <= 2800  # 9 to 10 mm a line


@pytest.mark.parametrize("baseline_px", [40, 80, 120, 160, 200, 240, 280])
def test_a_train_of_single_columns_in_few_lines_is_refused_for_its_lines(baseline_px: int) -> None:
    """As the app cuts it: by the rough boundaries "about 0 lines were recorded between the two cameras", and
    at 240 and 280 px, where front and rear tell opposite ways, 257 and 164 m of a train of 102 m.
    """
    train = TRAINS[0]
    frames, rate_hz = read(DATA / train.file)
    rig = Rig(baseline_px / PX_PER_M, rate_hz)
    middle = frames.shape[2] // 2
    first, second = (
        np.ascontiguousarray(frames[:, :, middle + by]) for by in (baseline_px // 2, -baseline_px // 2)
    )
    finder = Finder(frames.shape[1], rig)
    (seen,) = finder.push(first, second) + finder.finish()
    known_mm = 1000 * train.speed_px_s / PX_PER_M / rate_hz
    lines = baseline_px * rate_hz / train.speed_px_s
    for measure in MEASURE.values():
        reason = measure(seen, rig).reason
        assert reason is not None and reason.code == "scan-motion-too-coarse"
        assert reason.values["line_mm"] == pytest.approx(known_mm, rel=0.2 / lines)
        # 9 to 10 mm a line, and what the fastest train of so many lines needs
        assert 2500 <= reason.values["rate_hz"] <= 2800 / (1 - 0.2 / lines)
