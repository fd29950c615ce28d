"""Real trains as line scans: slits cut from two videos, both methods, in pixels, beside what is known.

Run: python tests/bench/bench_trains.py FOLDER, with the videos train_day.mp4 and train_snow.mp4 in it. A slit
is as wide as the train moves in a frame, or its picture would be sampled too coarsely to be matched. Leaves
the strips as pictures in .build/trains.
"""

import sys
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import av
import cv2
import numpy as np
from scipy.stats import theilslopes

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.linescan.direct import measure_direct
from sightline.linescan.methods import MEASURE
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Crossings, Motion, Passage, Rig

OUT = Path(__file__).resolve().parents[2] / ".build" / "trains"
SLIT_PX = 36
# of the locomotive, 18.40 m long; the nominal 50 is too large
PX_PER_M = 42.0
BASELINES_PX = (108, 144, 180)


@dataclass(frozen=True)
class Train:
    """A video with what its repository's tests say of it: px/s and px/s2 at a nominal 50 px/m."""

    file: str
    to_right: bool
    empty: slice
    speed_px_s: float
    acceleration_px_s2: float


TRAINS = (
    Train("train_day.mp4", False, slice(0, 20), 21.53 * 50, 0.27 * 50),
    Train("train_snow.mp4", True, slice(-6, None), 20.5 * 50, -0.75 * 50),
)
NOISE_DN = 2.0
SEEN_DN = 12.0


def read(path: Path) -> tuple[np.ndarray, float]:
    """(frames, rows, columns) grey, and the frame rate."""
    with av.open(str(path)) as video:
        rate = float(video.streams.video[0].average_rate or 0)
        return np.stack([frame.to_ndarray(format="gray") for frame in video.decode(video=0)]), rate


def by_pictures(frames: np.ndarray, rate: float) -> tuple[float, float]:
    """Speed in the middle and acceleration by phase correlation of whole pictures: an independent way."""
    window = cv2.createHanningWindow((frames.shape[2], 180), cv2.CV_32F)
    cut = frames[:, 60:240].astype(np.float32)
    shifts = np.array([cv2.phaseCorrelate(a, b, window)[0][0] for a, b in pairwise(cut)])
    time_s = (np.arange(len(shifts)) + 0.5) / rate
    moving = np.abs(shifts) > 10
    # some pictures are mismatched, so a slope that they cannot pull
    slope, middle, _, _ = theilslopes(np.abs(shifts[moving]) * rate, time_s[moving] - time_s[moving].mean())
    return float(middle), float(slope)


def strip(frames: np.ndarray, column: float) -> np.ndarray:
    """(lines, rows): a line a frame, the mean of a slit about a column."""
    left = round(column - SLIT_PX / 2)
    mean = frames[:, :, left : left + SLIT_PX].astype(np.float32).mean(axis=2)
    return np.ascontiguousarray(np.clip(mean + 0.5, 0, 255).astype(np.uint8))


def passage(train: Train, frames: np.ndarray, baseline_px: int) -> Passage:
    """The train between the first and the last line that shows it; cut off where the video begins with it."""
    middle = frames.shape[2] / 2
    ahead, behind = middle - baseline_px / 2, middle + baseline_px / 2
    columns = (ahead, behind) if train.to_right else (behind, ahead)
    strips = [strip(frames, column) for column in columns]
    roads = [picture[train.empty].mean(axis=0).astype(np.float32) for picture in strips]
    seen = [
        np.flatnonzero(np.abs(picture - road).mean(axis=1) > SEEN_DN)
        for picture, road in zip(strips, roads, strict=True)
    ]
    front, rear = float(seen[0][0]), float(seen[0][-1])
    delay = float(seen[1][-1]) - rear if seen[1][0] <= seen[0][0] else float(seen[1][0]) - front
    last = min(rear, len(strips[1]) - 1 - delay)
    return Passage(Crossings(front, last, front + delay, last + delay), *strips, 0, 0, *roads, NOISE_DN)


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if folder is None or not folder.is_dir():
        print("trains: give the folder of the videos to have them measured")
        return
    for train in TRAINS:
        frames, rate = read(folder / train.file)
        speed, acceleration = by_pictures(frames, rate)
        print(f"{train.file}: known {train.speed_px_s:.0f} px/s, {train.acceleration_px_s2:+.1f} px/s2; "
              f"whole pictures {speed:.1f} px/s in the middle, {acceleration:+.1f} px/s2")  # fmt: skip
        for baseline_px in BASELINES_PX:
            cut = passage(train, frames, baseline_px)
            OUT.mkdir(parents=True, exist_ok=True)
            for number, picture in enumerate((cut.first, cut.second), 1):
                cv2.imwrite(str(OUT / f"{Path(train.file).stem}-{baseline_px}-{number}.png"), picture.T)
            for method in (measure_paper, measure_direct):
                told(method(cut, Rig(baseline_px / PX_PER_M, rate)), cut, baseline_px, rate)
            reason = MEASURE["direct"](cut, Rig(baseline_px / PX_PER_M, rate)).reason
            print(f"  baseline {baseline_px} px, as an operator has it: {reason or 'measured'}")


def told(motion: Motion, cut: Passage, baseline_px: int, rate: float) -> None:
    head = f"  baseline {baseline_px} px, {motion.method:6}"
    if motion.speed_mps is None or motion.acceleration_mps2 is None:
        print(f"{head}: {motion.reason}")
        return
    half_s = (cut.crossings.rear_line_1 - cut.crossings.front_line_1) / rate / 2
    middle = motion.speed_mps + motion.acceleration_mps2 * half_s
    speed, u_speed, middle, acceleration, u_acceleration, length = (
        PX_PER_M * (one or 0.0)
        for one in (
            motion.speed_mps,
            motion.u_speed_mps,
            middle,
            motion.acceleration_mps2,
            motion.u_acceleration_mps2,
            motion.length_m,
        )
    )
    print(
        f"{head}: {speed:.1f} +- {u_speed:.1f} px/s at the front, {middle:.1f} in the middle; "
        f"{acceleration:+.1f} +- {u_acceleration:.1f} px/s2; length {length:.0f} px"
    )


if __name__ == "__main__":
    main()
