"""Did board and camera stand still, and what do many frames of a still board know?

Frames of a static board do not average as 1/sqrt(N): in compressed video the corner error of neighbouring
frames is correlated (lag-1 correlation about 0.9 was measured in H.264), and what is left is a bias that
every frame shares. So the variance of the mean corners is never the single-frame variance divided by the
number of frames.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats

STILL_PX = 0.3  # a board that moves less stands still
FLOOR_PX = 0.02  # static corner bias that no residual shows (sub-pixel fits reach 0.01 to 0.02 px)


@dataclass(frozen=True, eq=False)
class Still:
    """The frames in which the board stood still. `mean_px` (N, 2); `kept` indices into the frames given;
    `temporal_px` standard deviation of one coordinate in time; `effective` number of independent frames;
    `moved_px` largest shift of the whole board among all frames.
    """

    mean_px: Floats
    kept: tuple[int, ...]
    temporal_px: float
    effective: float
    moved_px: float


def find_still(frames_px: Floats) -> Still:
    """Pick the frames that show one and the same board position; frames_px (F, N, 2) in time order, pixels.

    A frame belongs to the still ones when its corners lie, as a whole, within STILL_PX of a position that
    most frames share: the root mean square over the corners of its smooth displacement (shift, turn, scale),
    which noise hardly moves. Of the frames, the one that most others agree with gives that position. Own
    method: `displacements_px` from each of some frames. Effective number of the F still ones: F (1 - r) / (1
    + r), r their lag-1 correlation (Bayley and Hammersley 1946; CONVENTIONS.md, Pose).
    """
    near = [displacements_px(frames_px - probe, probe) for probe in frames_px[_probes(frames_px)]]
    away = max(near, key=lambda d: (int((d <= STILL_PX).sum()), -float(np.median(d))))
    kept = np.flatnonzero(away <= STILL_PX)
    chosen = frames_px[kept]
    mean = chosen.mean(axis=0)
    temporal, effective = _temporal(chosen - mean)
    return Still(mean, tuple(int(i) for i in kept), temporal, effective, float(away.max()))


def _probes(frames_px: Floats) -> list[int]:
    """A dozen frames spread over the span, to try as the still position."""
    return sorted({int(i) for i in np.linspace(0, len(frames_px) - 1, 12)})


def displacements_px(shifts: Floats, at: Floats) -> Floats:
    """Root mean square (F,), pixels, of the affine part of F displacement fields, `shifts` (F, N, 2), over
    points `at` (N, 2).

    Own derivation: sqrt(|Q'd|^2 / N), d a field and Q of `smooth_basis`, which leaves N - 3 of N parts of the
    noise out.
    """
    return displaced_px(shifts, smooth_basis(at))


def smooth_basis(at: Floats) -> Floats:
    """Orthonormal basis (N, 3) of the affine functions 1, x, y over points `at` (N, 2), by QR."""
    q, _ = np.linalg.qr(np.column_stack([np.ones(len(at)), at - at.mean(axis=0)]))
    return np.asarray(q, dtype=np.float64)


def displaced_px(shifts: Floats, basis: Floats) -> Floats:
    """As `displacements_px`, (F,) of `shifts` (F, N, 2), with the `basis` (N, 3) at hand."""
    smooth = basis.T @ shifts  # the columns are orthonormal, so the length of the smooth part is that of this
    return np.asarray(np.sqrt(np.square(smooth).sum(axis=(1, 2)) / len(basis)), dtype=np.float64)


def _temporal(noise: Floats) -> tuple[float, float]:
    """Standard deviation in time and effective number of frames, from the lag-1 correlation (AR(1))."""
    count = len(noise)
    if count < 2:
        return 0.0, float(count)
    deviation = float(np.sqrt(np.square(noise).sum() / ((count - 1) * noise[0].size)))
    power = float(np.square(noise).mean())
    if count < 4 or power <= 0:
        return deviation, 1.0
    lag = float((noise[1:] * noise[:-1]).mean()) / power + 1.0 / count  # the mean's removal pulls it down
    lag = min(max(lag, 0.0), 0.99)
    return deviation, max(1.0, count * (1.0 - lag) / (1.0 + lag))


def mean_sigma_px(residual_px: float, still: Still) -> float:
    """Standard uncertainty of one coordinate of the mean corners.

    residual_px: what the pose fit to the mean corners left, per coordinate, degrees of freedom respected. It
    holds the static bias and the noise that did not average out; time alone can only raise it, the floor too.
    """
    return max(residual_px, still.temporal_px / float(np.sqrt(still.effective)), FLOOR_PX)
