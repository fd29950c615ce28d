"""What a recording says against itself: for the person who must decide whether to believe it.

Lines lost while the road was empty cannot be told from the pictures: all vehicles after them are shifted.
Recorders that count them should say so beside the file.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sightline.linescan.background import MOST_UNREST
from sightline.linescan.finding import Finder
from sightline.linescan.parts import Passage
from sightline.linescan.watching import Watcher
from sightline.messages.said import Said

BLIPS_PER_S = 3.0
FLICKER_SHARE = 0.012
SATURATED_SHARE = 0.02


def notes_of(finder: Finder) -> list[Said]:
    """A saying for each thing that a finder saw besides vehicles, after `finish`; empty if nothing."""
    seconds = max(finder.watchers[0].lines / finder.rig.line_rate_hz, 1e-9)
    notes = [_none_found(finder), _swapped(finder), _too_many_alone(finder)]
    notes += [_rests_again(finder), _jumps(finder), _moves(finder)]
    for number, watcher in enumerate(finder.watchers, 1):
        notes += [
            _unrest(number, watcher),
            _blips(number, watcher, seconds),
            _flicker(number, watcher),
            _saturated(number, watcher),
        ]
    return [one for one in notes if one]


def lines_lost(passage: Passage, lost: Sequence[Said]) -> Passage:
    """The passage, with a reason where the recorder lost lines of one camera or both as it passed."""
    if not lost or passage.reason:
        return passage
    said = lost[0] if len(lost) == 1 else Said("words-both", first=lost[0], second=lost[1])
    return replace(passage, reason=Said("scan-motion-lines-lost", lost=said))


def _none_found(finder: Finder) -> Said | None:
    if finder.found:
        return None
    return Said("scan-run-none-found")


def _swapped(finder: Finder) -> Said | None:
    if finder.reversed < 2 or finder.reversed * 10 < finder.found * 9:
        return None
    return Said("scan-run-swapped", reversed=finder.reversed, found=finder.found)


def _too_many_alone(finder: Finder) -> Said | None:
    if finder.alone <= max(2, 0.2 * finder.found):
        return None
    return Said("scan-run-alone", alone=finder.alone)


def _rests_again(finder: Finder) -> Said | None:
    """What comes to rest before one that stands is told as another; it may be the same, moved on."""
    rests = max(watcher.rests_again for watcher in finder.watchers)
    return Said("scan-run-rests-again", count=rests) if rests else None


def _jumps(finder: Finder) -> Said | None:
    jumps = max(watcher.jumps for watcher in finder.watchers)
    return Said("scan-run-light-changed", count=jumps) if jumps else None


def _moves(finder: Finder) -> Said | None:
    moves = max(watcher.moves for watcher in finder.watchers)
    return Said("scan-run-camera-moved", count=moves) if moves else None


def _unrest(number: int, watcher: Watcher) -> Said | None:
    if watcher.road is None or watcher.road.unrest <= MOST_UNREST:
        return None
    return Said("scan-run-road-unsteady", camera=number, percent=round(100 * watcher.road.unrest))


def _blips(number: int, watcher: Watcher, seconds: float) -> Said | None:
    rate = watcher.blips / seconds
    if rate < BLIPS_PER_S:
        return None
    return Said("scan-run-short-objects", camera=number, per_s=round(rate))


def _flicker(number: int, watcher: Watcher) -> Said | None:
    if watcher.road is None or watcher.road.unrest > MOST_UNREST:
        return None
    share = np.sqrt(2) * watcher.road.common_dn / max(float(np.mean(watcher.road.pooled)), 1.0)
    if share < FLICKER_SHARE:
        return None
    return Said("scan-run-flicker", camera=number, percent=round(100 * share))


def _saturated(number: int, watcher: Watcher) -> Said | None:
    share = watcher.saturated_lines / max(watcher.lines, 1)
    if share < SATURATED_SHARE:
        return None
    return Said("scan-run-saturated", camera=number, percent=round(100 * share))
