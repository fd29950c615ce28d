"""From standard uncertainties (k = 1) to 95 % intervals: the one factor that every U95 is made with; and what
part of an assumed inset's error stays, however many heights assume it; and how likely a chi-square is.
"""

from typing import overload

#: The 97.5 % point of the normal distribution.
COVERAGE_95 = 1.959963984540054

#: Of an assumed inset's variance: its mean's, which all that assume it share; the rest is each vehicle's own
#: (estimate: no source of an inset says how much).
MEAN_OF_INSET = 0.5


@overload
def expanded(u: float) -> float: ...
@overload
def expanded(u: None) -> None: ...
def expanded(u: float | None) -> float | None:
    """U95 of a standard uncertainty: half the width of the 95 % interval (JCGM 100:2008, 6.2).

    Parameters
    ----------
    u : float or None
        Standard uncertainty (k = 1), in any unit.

    Returns
    -------
    float or None
        In the same unit; None of None.

    Examples
    --------
    >>> import sightline
    >>> round(sightline.expanded(0.01), 4)
    0.0196
    """
    return None if u is None else COVERAGE_95 * u


def chance_of_larger(chi2: float, freedom: int) -> float:
    """The chance of a chi-square above `chi2` with `freedom` degrees; NaN without one, where nothing
    is left over that could disagree (`chdtrc` says 0).
    """
    from scipy.special import chdtrc  # who only expands needs no SciPy

    return float(chdtrc(freedom, chi2)) if freedom > 0 else float("nan")
