"""What a recording says against itself, in words: for the person who must decide whether to believe it.

Lines lost while the road was empty cannot be told from the pictures: all vehicles after them are shifted.
Recorders that count them should say so beside the file.
"""

import numpy as np

from sightline.linescan.finding import Finder
from sightline.linescan.watching import Watcher

BLIPS_PER_S = 3.0
FLICKER_SHARE = 0.012
SATURATED_SHARE = 0.02


def notes_of(finder: Finder) -> list[str]:
    """One sentence for each thing that a finder saw besides vehicles, after `finish`; empty if nothing."""
    seconds = max(finder.watchers[0].lines / finder.rig.line_rate_hz, 1e-9)
    said = [_none_found(finder), _swapped(finder), _alone(finder), _jumps(finder)]
    for number, watcher in enumerate(finder.watchers, 1):
        said += [_blips(number, watcher, seconds), _flicker(number, watcher), _saturated(number, watcher)]
    return [sentence for sentence in said if sentence]


def _none_found(finder: Finder) -> str | None:
    if finder.found:
        return None
    return (
        "No vehicle was found: the road is empty, or the strips do not show it; look at them, and check "
        "that time runs along the axis given."
    )


def _swapped(finder: Finder) -> str | None:
    if finder.reversed * 2 <= max(2, finder.found):
        return None
    return (
        f"{finder.reversed} of {finder.found} vehicles reached the second strip first; if all traffic goes "
        "one way, the strips are swapped: give them the other way round."
    )


def _alone(finder: Finder) -> str | None:
    if finder.alone <= max(2, 0.2 * finder.found):
        return None
    return (
        f"{finder.alone} times something passed one camera only: check that both look at the same lane and "
        "that baseline and line rate are right."
    )


def _jumps(finder: Finder) -> str | None:
    jumps = max(watcher.jumps for watcher in finder.watchers)
    if not jumps:
        return None
    times = "once" if jumps == 1 else f"{jumps} times"
    return f"The light jumped {times}; a vehicle that passed at such a moment may be missing."


def _blips(number: int, watcher: Watcher, seconds: float) -> str | None:
    rate = watcher.blips / seconds
    if rate < BLIPS_PER_S:
        return None
    return (
        f"Camera {number} saw {rate:.0f} short things a second: rain, snow or insects; boundaries are "
        "unsure, look at them."
    )


def _flicker(number: int, watcher: Watcher) -> str | None:
    if watcher.road is None:
        return None
    share = np.sqrt(2) * watcher.road.common_dn / max(float(np.mean(watcher.road.pooled)), 1.0)
    if share < FLICKER_SHARE:
        return None
    return (
        f"The light before camera {number} flickers by {100 * share:.0f} %, as lamps on mains do; use other "
        "lamps, or expect wider uncertainties."
    )


def _saturated(number: int, watcher: Watcher) -> str | None:
    share = watcher.saturated_lines / max(watcher.lines, 1)
    if share < SATURATED_SHARE:
        return None
    return f"{100 * share:.0f} % of the picture of camera {number} is saturated: open the exposure less."
