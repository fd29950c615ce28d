"""Do a strip's lines lie close enough for what it shows? Told from the strip itself, not from what was typed.

Between lines a registration reads what lies between them from the lines themselves. That works while a line's
change carries on into the next; where it does not, the details are smaller than the lines' distance, and what
is read between them is a guess whose error no scatter tells.
"""

import numpy as np
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.linescan.parts import Passage, Pixels, Rig
from sightline.linescan.rig import baseline_of
from sightline.messages.said import Said

# Below this correlation of one line's change with the next, a vehicle is refused. On 40 simulated vehicles
# whose strips were thinned out (seeds 701 to 704) u held down to 0.1, and from 45 mm a line on, where it
# fails, 95 of 100 lie below 0.12.
LEAST_CARRIED = 0.15
# what to ask for: simulated vehicles have 0.4 to 0.6 there
GOOD_LINE_M = 0.010
FEWEST_LINES, MOST_LINES = 12, 4096
_SIGMAS = 5.0
# boundaries may be two lines off, so pictures are looked for as far away, and one beside them
_REACH_LINES = 3
# of what passes in so few lines that the finder tells none from another, rough boundaries are off by more
_FAR_REACH_LINES = 8
# pictures no more alike than so do not tell how far apart they lie
_LEAST_ALIKE = 0.3
# to so much of a line is known how many lie from camera to camera: by pictures that share little between two
# lines, and by boundaries
_SURE_BY_PICTURES, _SURE_BY_BOUNDARIES = 0.2, 1.0
_LEAST_APART = 0.5


def too_coarse(passage: Passage, rig: Rig) -> Said | None:
    """Why the lines are too slow for this vehicle, and what to do; None where they are not.

    Also None where the picture shows too little to tell; of a passage with a reason, which has only rough
    boundaries, where both pictures do not tell how far apart they lie.
    """
    rough, c = passage.reason is not None, passage.crossings
    delay = (c.front_line_2 - c.front_line_1 + c.rear_line_2 - c.rear_line_1) / 2
    carried = [
        carried_on(
            _cut_between(picture, front - start, rear - start, 1.0 - rig.shadow_share), passage.noise_dn
        )
        for picture, start, front, rear in (
            (passage.first, passage.start_1, c.front_line_1, c.rear_line_1),
            (passage.second, passage.start_2, c.front_line_2, c.rear_line_2),
        )
    ]
    told = [one for one in carried if one is not None]
    if (delay <= 0 and not rough) or not told or sum(told) / len(told) >= LEAST_CARRIED:
        return None
    # rough ends leave the delay open by half of what they contradict each other
    open_lines = abs(c.front_line_2 - c.front_line_1 - c.rear_line_2 + c.rear_line_1) / 2
    reach = _FAR_REACH_LINES + int(np.ceil(open_lines)) if rough else _REACH_LINES
    apart = lines_apart(passage, delay, 1.0 - rig.shadow_share, reach)
    if rough and apart is not None:
        # the nearer the lags, the more lines have all of them
        apart = lines_apart(passage, apart, 1.0 - rig.shadow_share)
    if rough:
        # either way, but not at once: that is the light, or a camera that gave way
        if apart is None or abs(apart) < _LEAST_APART:
            return None
        apart = abs(apart)
    lines, sure = (delay, _SURE_BY_BOUNDARIES) if apart is None else (apart, _SURE_BY_PICTURES)
    baseline_m, _ = baseline_of(rig)
    line_m = baseline_m / lines
    # the rate does for the fastest that so many lines allow
    most_m = baseline_m / max(lines - sure, lines / 2)
    rate_hz = rig.line_rate_hz * max(most_m / GOOD_LINE_M, 2.0)
    return Said(
        "scan-motion-too-coarse", line_mm=round(1000 * line_m), rate_hz=round(float(f"{rate_hz:.2g}"))
    )


def carried_on(picture: Pixels, noise_dn: float) -> float | None:
    """Correlation of the change from one line to the next with the change after it; None: too little to see.

    `picture` (lines, rows) inside a vehicle. Own method: with e[n] = I[n + 1] - I[n], the mean of e[n, r]
    e[n + 1, r + 1] over that of e[n, r] e[n, r + 1]. Products of neighbouring rows: the noise of different
    pixels is independent and drops out of both, whatever it is. 1 for a picture smooth between lines, 0 for
    changes that have nothing to do with each other, below 0 where single lines stand out.
    """
    if len(picture) < FEWEST_LINES:
        return None
    change = np.diff(picture.astype(np.float32), axis=0)
    here = float(np.mean(change[:, 1:] * change[:, :-1]))
    # the product of two changes of pure noise has the standard deviation 2 sigma^2
    if here <= _SIGMAS * 2 * noise_dn**2 / np.sqrt(change.size):
        return None
    down, up = change[1:, 1:] * change[:-1, :-1], change[1:, :-1] * change[:-1, 1:]
    return float(np.mean(down) + np.mean(up)) / 2 / here


def lines_apart(passage: Passage, delay: float, upper_part: float, reach: int = _REACH_LINES) -> float | None:
    """How many lines after the first picture the second shows the same; None where they do not tell.

    `delay`: lines, what the boundaries say; `upper_part`: of the rows, looked at; `reach`: so many lines
    beside the delay. Own method: the correlation of both pictures, each less its rows' means, at whole lines
    near `delay`; between them it rises and falls in straight lines, as that of lines that share nothing does.
    A side that repeats itself matches elsewhere as well, and tells nothing (`_is_ambiguous`).
    """
    c, least, most = passage.crossings, round(delay) - reach, round(delay) + reach
    start = max(int(np.ceil(c.front_line_1)), passage.start_1, passage.start_2 - least)
    stop = min(
        int(c.rear_line_1) + 1,
        passage.start_1 + len(passage.first),
        passage.start_2 + len(passage.second) - most,
    )
    first = _cut_between(passage.first, start - passage.start_1, stop - 1 - passage.start_1, upper_part)
    start += max(stop - start - MOST_LINES, 0) // 2
    if len(first) < FEWEST_LINES:
        return None
    of_lines = np.array(
        [
            _correlation(first, passage.second[start + lag - passage.start_2 :][: len(first)])
            for lag in range(least, most + 1)
        ]
    )
    alike = of_lines.sum(axis=1)
    best = int(alike.argmax())
    if not 0 < best < len(alike) - 1 or alike[best] < _LEAST_ALIKE or _is_ambiguous(of_lines, best):
        return None
    before, here, after = alike[best - 1 : best + 2]
    return float(least + best + (after - before) / 2 / max(here - min(before, after), 1e-9))


def _is_ambiguous(of_lines: NDArray[np.float64], best: int) -> bool:
    """Whether the pictures match at other lags than about `best` as well as there.

    `of_lines` (lags, lines): what each line brings to the correlation. Own method: a match between two lags
    is the sum of both. Its lead over another, line by line, is a sample whose mean's standard error its own
    scatter tells, for these lines share nothing; one that is not above 0 by COVERAGE_95 of it may be none.
    """
    matches = of_lines[:-1] + of_lines[1:]
    peak = best if of_lines[best + 1].sum() > of_lines[best - 1].sum() else best - 1
    others = np.concatenate([matches[: max(peak - 1, 0)], matches[peak + 2 :]])
    lead = matches[peak] - others
    error = lead.std(axis=1, ddof=1) * np.sqrt(lead.shape[1])
    return bool((lead.sum(axis=1) <= COVERAGE_95 * error).any())


def _correlation(first: Pixels, second: Pixels) -> NDArray[np.float64]:
    """What each line brings to it (lines,) of two pictures (lines, rows), rows that the first lacks left out;
    0 where either shows nothing.
    """
    a, b = (one[:, : first.shape[1]].astype(np.float32) for one in (first, second))
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)
    size = float(np.sqrt(np.vdot(a, a) * np.vdot(b, b)))
    return np.asarray((a * b).sum(axis=1) / (size or 1.0), float)


def _cut_between(picture: Pixels, front: float, rear: float, upper_part: float) -> Pixels:
    """The upper rows of the lines from front to rear, of the middle ones MOST_LINES at most."""
    start, stop = max(int(np.ceil(front)), 0), max(min(int(rear) + 1, len(picture)), 0)
    more = max(stop - start - MOST_LINES, 0) // 2
    return picture[start + more : stop - more, : max(2, int(picture.shape[1] * upper_part))]
