"""What a recording says against itself, in words: for the person who must decide whether to believe it.

Lines lost while the road was empty cannot be told from the pictures: all vehicles after them are shifted.
Recorders that count them should say so beside the file.
"""

import numpy as np

from sightline.linescan.background import MOST_UNREST
from sightline.linescan.finding import Finder
from sightline.linescan.watching import Watcher

BLIPS_PER_S = 3.0
FLICKER_SHARE = 0.012
SATURATED_SHARE = 0.02


def notes_of(finder: Finder) -> list[str]:
    """One sentence for each thing that a finder saw besides vehicles, after `finish`; empty if nothing."""
    seconds = max(finder.watchers[0].lines / finder.rig.line_rate_hz, 1e-9)
    said = [_none_found(finder), _swapped(finder), _alone(finder), _jumps(finder), _moves(finder)]
    for number, watcher in enumerate(finder.watchers, 1):
        said += [
            _unrest(number, watcher),
            _blips(number, watcher, seconds),
            _flicker(number, watcher),
            _saturated(number, watcher),
        ]
    return [sentence for sentence in said if sentence]


def _none_found(finder: Finder) -> str | None:
    if finder.found:
        return None
    return "No vehicle was found; check the strips, and that time runs along the chosen axis."


def _swapped(finder: Finder) -> str | None:
    if finder.reversed < 2 or finder.reversed * 10 < finder.found * 9:
        return None
    return (
        f"{finder.reversed} of {finder.found} vehicles reached the second strip first; if traffic "
        "does not run that way here, the strips are swapped."
    )


def _alone(finder: Finder) -> str | None:
    if finder.alone <= max(2, 0.2 * finder.found):
        return None
    return (
        f"{finder.alone} times something passed only one camera: check that both show the same "
        "lane, and check baseline and line rate."
    )


def _jumps(finder: Finder) -> str | None:
    jumps = max(watcher.jumps for watcher in finder.watchers)
    if not jumps:
        return None
    times = "once" if jumps == 1 else f"{jumps} times"
    return f"The brightness changed suddenly {times}; vehicles that passed at that moment may be missing."


def _moves(finder: Finder) -> str | None:
    moves = max(watcher.moves for watcher in finder.watchers)
    if not moves:
        return None
    times = "once" if moves == 1 else f"{moves} times"
    return f"A camera moved {times}: the road is some rows higher or lower since then; fix the camera firmly."


def _unrest(number: int, watcher: Watcher) -> str | None:
    if watcher.road is None or watcher.road.unrest <= MOST_UNREST:
        return None
    return (
        f"The empty road of camera {number} varies by {100 * watcher.road.unrest:.0f} % from line "
        "to line: snow, rain, or a vehicle at the start; record the empty road first."
    )


def _blips(number: int, watcher: Watcher, seconds: float) -> str | None:
    rate = watcher.blips / seconds
    if rate < BLIPS_PER_S:
        return None
    return (
        f"Camera {number} shows {rate:.0f} short objects a second: rain, snow or insects; check "
        "the boundaries."
    )


def _flicker(number: int, watcher: Watcher) -> str | None:
    if watcher.road is None or watcher.road.unrest > MOST_UNREST:
        return None
    share = np.sqrt(2) * watcher.road.common_dn / max(float(np.mean(watcher.road.pooled)), 1.0)
    if share < FLICKER_SHARE:
        return None
    return (
        f"The light at camera {number} flickers by {100 * share:.0f} %, as mains lighting does; "
        "use other lighting, or expect larger uncertainties."
    )


def _saturated(number: int, watcher: Watcher) -> str | None:
    share = watcher.saturated_lines / max(watcher.lines, 1)
    if share < SATURATED_SHARE:
        return None
    return f"{100 * share:.0f} % of the image of camera {number} is saturated; reduce the exposure."
