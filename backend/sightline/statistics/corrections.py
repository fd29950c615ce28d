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
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.enums import Correction
from sightline.messages.said import Said
from sightline.statistics.agreement import LEAST

CORRECTIONS: tuple[Correction, ...] = get_args(Correction)
_MANY_OUTSIDE = 0.01


@dataclass(frozen=True, eq=False)
class Corrected:
    """Heights (N,) after a correction, what was done in words, and what to beware of."""

    height_m: Floats
    words: Said
    warning: Said | None = None


@dataclass(frozen=True, eq=False)
class Known:
    """Vehicles of known height (M,): the paper's measured heights and the errors they have, metres."""

    measured_m: Floats
    error_m: Floats


def correct_heights(
    kind: Correction, inset_m: ArrayLike, paper_m: ArrayLike, known: Known, camera_sd_m: float | None = None
) -> Corrected | Said:
    """Heights (N,) under a correction, metres, or the reason why it cannot be made.

    inset_m (N,): heights corrected by each measurement's inset; paper_m (N,): the paper's, with inset 0;
    known: the survey's vehicles with a reference height, measured the paper's way. camera_sd_m: for
    "deconvolution", the standard deviation of the measurement alone, without the reference's.

    Dupuis et al. 2019, sections 3.5 and 3.6, say "corrected CDF given the measurement error" and no more. Own
    readings of it: "shift" h - mean(e); "regression" h - (a + b h), the line through the errors;
    "deconvolution" c - mean(e) + (h - c) sqrt(1 - camera_sd^2 / var(h)), c the mean of h.
    """
    if kind == "inset":
        return Corrected(np.asarray(inset_m, dtype=np.float64), Said("stat-by-inset"))
    heights = np.asarray(paper_m, dtype=np.float64)
    if kind == "none":
        return Corrected(heights, Said("stat-uncorrected"))
    if len(known.error_m) < LEAST:
        return Said("stat-correction-needs", least=LEAST, count=len(known.error_m))
    if kind == "shift":
        return _shifted(heights, known)
    if kind == "regression":
        return _regressed(heights, known)
    return _deconvolved(heights, known, camera_sd_m)


def _shifted(heights: Floats, known: Known) -> Corrected:
    mean = float(known.error_m.mean())
    words = Said("stat-shifted", count=len(known.error_m), mean_m=round(mean, 4))
    return Corrected(heights - mean, words)


def _regressed(heights: Floats, known: Known) -> Corrected | Said:
    if np.ptp(known.measured_m) <= 0:
        return Said("stat-known-alike")
    line = scipy.stats.linregress(known.measured_m, known.error_m)
    low, high = float(known.measured_m.min()), float(known.measured_m.max())
    outside = float(np.mean((heights < low) | (heights > high))) if len(heights) else 0.0
    intercept_m, slope = round(float(line.intercept), 4), round(1000 * float(line.slope), 1)
    words = Said("stat-regressed", count=len(known.error_m), intercept_m=intercept_m, slope=slope)
    warning = None
    if outside > _MANY_OUTSIDE:
        share = round(100 * outside)
        warning = Said("stat-extrapolated", outside=share, low_m=round(low, 2), high_m=round(high, 2))
    return Corrected(heights - (line.intercept + line.slope * heights), words, warning)


def _deconvolved(heights: Floats, known: Known, camera_sd_m: float | None) -> Corrected | Said:
    if camera_sd_m is None:
        return Said("stat-variance-unknown")
    if len(heights) < 2:
        return Said("stat-variance-needs")
    variance = float(heights.var(ddof=1))
    keep = 1.0 - camera_sd_m**2 / variance if variance > 0 else 0.0
    if keep <= 0:
        return Said("stat-variance-too-large")
    centre = float(heights.mean())
    mean = float(known.error_m.mean())
    words = Said(
        "stat-deconvolved",
        mean_m=round(mean, 4),
        camera_sd_m=round(camera_sd_m, 4),
        keep=round(100 * (1 - float(np.sqrt(keep))), 1),
    )
    return Corrected(centre - mean + (heights - centre) * np.sqrt(keep), words)
