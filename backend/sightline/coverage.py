"""From standard uncertainties (k = 1) to 95 % intervals: the one factor that every U95 is made with."""

from typing import overload

#: The 97.5 % point of the normal distribution.
COVERAGE_95 = 1.959963984540054


@overload
def expanded(u: float) -> float: ...
@overload
def expanded(u: None) -> None: ...
def expanded(u: float | None) -> float | None:
    """U95 of a standard uncertainty, in its unit: half the width of the 95 % interval; None of None."""
    return None if u is None else COVERAGE_95 * u
