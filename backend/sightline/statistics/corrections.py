"""Corrected distributions of heights, given what vehicles of known height say of the error.

The paper's "corrected CDF given the measurement error" can be read in three ways: A shifts by the mean signed
error, B takes the error's regression on the measured height off, C shifts and takes the measurement's own
variance out. They start from the paper's heights (inset 0). The per-measurement inset needs no such table:
its heights come corrected.
"""

from dataclasses import dataclass
from typing import get_args

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from sightline.enums import Correction
from sightline.statistics.agreement import LEAST
from sightline.statistics.wording import there_are

Floats = NDArray[np.float64]
CORRECTIONS: tuple[Correction, ...] = get_args(Correction)
_MANY_OUTSIDE = 0.01


@dataclass(frozen=True, eq=False)
class Corrected:
    """Heights (N,) after a correction, what was done in words, and what to beware of."""

    height_m: Floats
    words: str
    warning: str | None = None


@dataclass(frozen=True, eq=False)
class Known:
    """Vehicles of known height (M,): the paper's measured heights and the errors they have, metres."""

    measured_m: Floats
    error_m: Floats


def corrected(
    kind: Correction,
    inset_m: ArrayLike,
    paper_m: ArrayLike,
    known: Known,
    camera_sd_m: float | None = None,
) -> Corrected | str:
    """Heights (N,) under a correction, metres, or the reason why it cannot be made.

    inset_m (N,): heights corrected by each measurement's inset; paper_m (N,): the paper's, with inset 0;
    known: the survey's vehicles with a reference height, measured the paper's way. camera_sd_m: for
    "deconvolution", the standard deviation of the measurement alone, without the reference's.

    Dupuis et al. 2019, sections 3.5 and 3.6, say "corrected CDF given the measurement error" and no more. Own
    readings of it: "shift" h - mean(e); "regression" h - (a + b h), the line through the errors;
    "deconvolution" c - mean(e) + (h - c) sqrt(1 - camera_sd^2 / var(h)), c the mean of h.
    """
    if kind == "inset":
        words = "Each height is corrected by the inset of its measurement; no other correction is made."
        return Corrected(np.asarray(inset_m, dtype=np.float64), words)
    heights = np.asarray(paper_m, dtype=np.float64)
    if kind == "none":
        return Corrected(heights, "Heights as in Dupuis et al. (inset 0), without a correction.")
    if len(known.error_m) < LEAST:
        return (
            f"This correction needs at least {LEAST} vehicles with a reference height; "
            f"{there_are(len(known.error_m))}."
        )
    if kind == "shift":
        return _shifted(heights, known)
    if kind == "regression":
        return _regressed(heights, known)
    return _deconvolved(heights, known, camera_sd_m)


def _shifted(heights: Floats, known: Known) -> Corrected:
    mean = float(known.error_m.mean())
    words = (
        f"The mean signed error of {len(known.error_m)} vehicles of known height, "
        f"{1000 * mean:+.1f} mm, was subtracted from every height (as in Dupuis et al.)."
    )
    return Corrected(heights - mean, words)


def _regressed(heights: Floats, known: Known) -> Corrected | str:
    if np.ptp(known.measured_m) <= 0:
        return "The vehicles of known height are all of one height, so their error has no trend with it."
    line = scipy.stats.linregress(known.measured_m, known.error_m)
    low, high = float(known.measured_m.min()), float(known.measured_m.max())
    outside = float(np.mean((heights < low) | (heights > high))) if len(heights) else 0.0
    words = (
        f"The error's regression on the measured height of {len(known.error_m)} vehicles, "
        f"{1000 * line.intercept:+.1f} mm {1000 * line.slope:+.1f} mm per m, was subtracted from "
        "every height."
    )
    warning = None
    if outside > _MANY_OUTSIDE:
        warning = (
            f"{100 * outside:.0f} % of the heights lie outside the {low:.2f} to {high:.2f} m of the "
            "regression; the correction extrapolates there and is not reliable."
        )
    return Corrected(heights - (line.intercept + line.slope * heights), words, warning)


def _deconvolved(heights: Floats, known: Known, camera_sd_m: float | None) -> Corrected | str:
    if camera_sd_m is None:
        return (
            "The reference heights alone explain the errors' variance, so the variance of the "
            "measurement is unknown and cannot be removed."
        )
    if len(heights) < 2:
        return "A variance needs at least 2 heights."
    variance = float(heights.var(ddof=1))
    keep = 1.0 - camera_sd_m**2 / variance if variance > 0 else 0.0
    if keep <= 0:
        return "The variance of the measurement is larger than that of the heights, so it cannot be removed."
    centre = float(heights.mean())
    mean = float(known.error_m.mean())
    words = (
        f"After the shift by {1000 * mean:+.1f} mm, the measurement's own standard deviation of "
        f"{1000 * camera_sd_m:.1f} mm was removed: every height moved towards the mean by "
        f"{100 * (1 - np.sqrt(keep)):.1f} %."
    )
    return Corrected(centre - mean + (heights - centre) * np.sqrt(keep), words)
