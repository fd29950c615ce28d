"""What the heights clicked in a survey's line scans say together: pure of where they are."""

from collections.abc import Iterable
from dataclasses import dataclass
from statistics import fmean, median, stdev

from sightline.scans.records import state_of


@dataclass(frozen=True, slots=True)
class HeightSeen:
    """A standing height as the statistics see it; `verdict`: the one that stands on it."""

    target: str
    verdict: str
    height_m: float
    U95_m: float


@dataclass(frozen=True, slots=True)
class ScannedHeights:
    """Heights of one target; figures are of the `n` that count.

    `to_review`, `rejected`: how many wait and how many were refused. `U95_m`: the median half-width of the
    intervals. Figures are None where none counts, `sd_m` where one does.
    """

    target: str
    n: int
    to_review: int
    rejected: int
    mean_m: float | None
    sd_m: float | None
    median_m: float | None
    U95_m: float | None


def scanned_heights(seen: Iterable[HeightSeen], *, accepted_only: bool) -> tuple[ScannedHeights, ...]:
    """Target by target; rejected heights never count, unreviewed ones where asked for."""
    of_target: dict[str, list[HeightSeen]] = {}
    for one in seen:
        of_target.setdefault(one.target, []).append(one)
    return tuple(_scanned(target, found, accepted_only) for target, found in sorted(of_target.items()))


def _scanned(target: str, found: list[HeightSeen], accepted_only: bool) -> ScannedHeights:
    states = [state_of("ok", one.verdict) for one in found]
    counting = ("accepted",) if accepted_only else ("accepted", "to_review")
    used = [one for one, state in zip(found, states, strict=True) if state in counting]
    heights = [one.height_m for one in used]
    return ScannedHeights(
        target=target,
        n=len(used),
        to_review=states.count("to_review"),
        rejected=states.count("rejected"),
        mean_m=fmean(heights) if heights else None,
        sd_m=stdev(heights) if len(heights) > 1 else None,
        median_m=median(heights) if heights else None,
        U95_m=median(one.U95_m for one in used) if used else None,
    )
