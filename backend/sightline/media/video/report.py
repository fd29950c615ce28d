"""What an ingest noticed about a recording, as counts and in sayings for an operator."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.enums import FILMED_HZ, ClockDoubt
from sightline.errors import BadInput
from sightline.media.video.decode import Damage, VideoFacts
from sightline.media.video.remux import WorkingCopy
from sightline.media.video.sniff import Extent
from sightline.media.video.stated import Stated
from sightline.messages.said import Said, join_with_and, with_commas

RATE_TOLERANCE = 0.02
ROUNDING = 1.001
JITTER = 0.05
# Containers that write down how long they are but not how many frames; other durations may be estimates.
DURATION_IN_HEADER = ("matroska,webm",)
SLOWED = 1.5  # filmed so many times faster than played, or slower: not the trembling of a telephone's rate
MOST_OFF_STEP = (
    0.05  # share of the steps between frames that may be longer or shorter, as where some are lost
)
MOST_HZ = FILMED_HZ[1]  # no camera that films a road takes more pictures a second
LEAST_TURN_DEG = 0.5
GAP = 5.0  # usual steps without a picture, and at least
GAP_S = 0.25


@dataclass(frozen=True)
class IngestReport:
    """`vfr`: the time between frames varies. `duplicates`: frames whose picture equals the one before.
    `clock_doubt`: why the times are not those of filming, so that no motion is measured from them.

    `unordered`: frames whose time stamp is not later than the one before. `damaged`: something could not
    be read. `rate_hz` is measured from the time stamps (None for fewer than two frames). `notes`:
    what people should know.
    """

    vfr: bool
    duplicates: int
    unordered: int
    damaged: bool
    rate_hz: float | None
    notes: tuple[Said, ...]
    clock_doubt: ClockDoubt | None = None


def report_of(
    facts: VideoFacts,
    pts: NDArray[np.int64],
    time_s: NDArray[np.float64],
    crc32: NDArray[np.uint32],
    damage: Damage,
    copy: WorkingCopy | None,
    stated: Stated,
    extent: Extent,
    filmed_hz: float | None = None,
) -> IngestReport:
    """The report of a finished decode; arrays are those of the frame table, shape (N,), but for `time_s`,
    whose times are those of playing. With `filmed_hz`, as a person said, nothing is in doubt.
    """
    doubt = clock_doubt_of(time_s, stated) if filmed_hz is None else None
    vfr = _varies(np.sort(pts))
    duplicates = int(np.count_nonzero(crc32[1:] == crc32[:-1]))
    unordered = int(np.count_nonzero(np.diff(pts) <= 0))
    rate = mean_rate_hz(time_s)
    notes = [
        *_shape_notes(facts),
        *_time_notes(facts, time_s, rate, vfr, copy),
        *(_clock_notes(doubt, time_s, stated) if filmed_hz is None else _filmed_notes(filmed_hz, time_s)),
        *_gap_notes(time_s),
        *_order_notes(duplicates, unordered),
        *_damage_notes(facts, len(pts), damage),
        *_duration_notes(facts, pts, time_s),
        *_extent_notes(extent, time_s),
    ]
    return IngestReport(
        vfr=vfr,
        duplicates=duplicates,
        unordered=unordered,
        damaged=damage.any or extent.missing > 0 or _cut_short(facts, pts, time_s),
        rate_hz=rate if filmed_hz is None else mean_rate_hz(times_of_filming(time_s, filmed_hz)),
        notes=tuple(notes),
        clock_doubt=doubt,
    )


def clock_doubt_of(time_s: NDArray[np.float64], stated: Stated) -> ClockDoubt | None:
    """Why frame times (N,) are not those of filming, by usual step and the file's words; None: no doubt."""
    played_hz = _played_hz(time_s)
    if stated.no_rate:
        return "no_rate"
    if played_hz is None or len(time_s) < 3:
        return None
    if played_hz > MOST_HZ:
        return "impossible_rate"
    if stated.filmed_hz is None:
        return "slow_motion" if stated.to_be_slow else None
    return None if 1 / SLOWED < stated.filmed_hz / played_hz < SLOWED else "slow_motion"


def require_clock_of_filming(doubt: object, name: str) -> None:
    """Raise BadInput before a motion is measured from times in doubt (`IngestReport.clock_doubt`)."""
    if doubt is not None:
        raise BadInput("video-times-not-filming", name=name)


def times_of_filming(time_s: NDArray[np.float64], filmed_hz: float, name: str = "") -> NDArray[np.float64]:
    """Times of playing (N,), s, as those of filming at `filmed_hz`: the usual step becomes one over
    that rate.

    Raises BadInput where the steps are of several lengths, as where only part of it is played slowly.
    """
    played_hz = _played_hz(time_s)
    if played_hz is None:
        return time_s
    if played_hz == float("inf"):
        return np.arange(len(time_s)) / filmed_hz
    steps = np.diff(np.sort(time_s)) * played_hz
    if np.mean((steps < 1 / SLOWED) | (steps > SLOWED)) > MOST_OFF_STEP:
        raise BadInput("video-slowed-in-part", name=name)
    return time_s * (played_hz / filmed_hz)


def _filmed_notes(filmed_hz: float, time_s: NDArray[np.float64]) -> list[Said]:
    played_hz = _played_hz(time_s) or 0.0
    return [Said("video-filmed-at", filmed_hz=_figures(filmed_hz, 6), played_hz=_figures(played_hz, 4))]


def _played_hz(time_s: NDArray[np.float64]) -> float | None:
    """Pictures a second by the usual step from one to the next, endless where it is 0; None for one alone."""
    if len(time_s) < 2:
        return None
    step_s = float(np.median(np.diff(np.sort(time_s))))
    return 1.0 / step_s if step_s > 0 else float("inf")


def _clock_notes(doubt: ClockDoubt | None, time_s: NDArray[np.float64], stated: Stated) -> list[Said]:
    played_hz = _played_hz(time_s)
    if doubt is None or played_hz is None:
        return []
    if doubt == "no_rate":
        return [Said("video-no-rate", played_hz=_figures(played_hz, 4))]
    if doubt == "impossible_rate":
        if played_hz == float("inf"):
            return [Said("video-impossible-rate-endless")]
        return [Said("video-impossible-rate", played_hz=_figures(played_hz, 6))]
    if stated.filmed_hz is None:
        return [Said("video-slow-motion", played_hz=_figures(played_hz, 4))]
    stated_hz = _figures(stated.filmed_hz, 4)
    return [Said("video-slow-motion-at", filmed_hz=stated_hz, played_hz=_figures(played_hz, 4))]


def _figures(value: float, count: int) -> float:
    """Rounded to so many significant figures."""
    return float(f"{value:.{count}g}")


def _gap_notes(time_s: NDArray[np.float64]) -> list[Said]:
    """Where pictures are missing, as after lost packets or between two recordings in one file."""
    steps = np.diff(np.sort(time_s))
    if len(steps) < 3:
        return []
    gaps = np.flatnonzero(steps > max(GAP_S, GAP * float(np.median(steps))))
    if len(gaps) == 0:
        return []
    longest = int(gaps[np.argmax(steps[gaps])])
    return [Said("video-gaps", count=len(gaps), gap_s=round(float(steps[longest]), 2), frame=longest)]


def _extent_notes(extent: Extent, time_s: NDArray[np.float64]) -> list[Said]:
    notes = []
    if extent.missing:
        span_s = round(float(time_s.max()), 2)
        notes.append(Said("video-truncated", missing=extent.missing, count=len(time_s), span_s=span_s))
    if extent.another:
        notes.append(Said("video-another-recording-after"))
    return notes


def _varies(pts: NDArray[np.int64]) -> bool:
    """Whether time stamps leave the line through the first and the last by more than rounding.

    Containers round to their tick, so a constant rate stays within one tick of that line; five per cent
    of a frame more is granted to recorders with fine ticks and a slightly trembling clock.
    """
    if len(pts) < 3:
        return False
    line = np.linspace(float(pts[0]), float(pts[-1]), len(pts))
    step = float(pts[-1] - pts[0]) / (len(pts) - 1)
    return bool(np.max(np.abs(pts - line)) > max(ROUNDING, JITTER * step))


def mean_rate_hz(time_s: NDArray[np.float64]) -> float | None:
    """How many frames a second are, on average, by their times (N,); None where these say nothing of it."""
    span_s = float(time_s.max() - time_s.min()) if len(time_s) > 1 else 0.0
    return (len(time_s) - 1) / span_s if span_s > 0 else None


def _shape_notes(facts: VideoFacts) -> list[Said]:
    notes = []
    if facts.pictures:
        numbered = list(enumerate(facts.pictures, start=1))
        others = [one.said(number) for number, one in numbered if number != facts.stream]
        notes.append(
            Said(
                "video-other-tracks",
                count=len(others),
                others=with_commas(others),
                stream=facts.stream,
                codec=facts.codec,
                width_px=facts.width_px,
                height_px=facts.height_px,
            )
        )
    if facts.shown_upright:
        notes.append(Said("video-shown-upright", done=join_with_and(facts.shown_upright)))
    if facts.left_turned_deg > LEAST_TURN_DEG:
        notes.append(Said("video-not-turned", degrees=round(facts.left_turned_deg)))
    if facts.interlaced:
        notes.append(Said("video-interlaced"))
    return notes


def _time_notes(
    facts: VideoFacts, time_s: NDArray[np.float64], rate: float | None, vfr: bool, copy: WorkingCopy | None
) -> list[Said]:
    notes = []
    if copy is not None and copy.assumed_rate_hz is None:
        notes.append(Said("video-working-copy"))
    if copy is not None and copy.assumed_rate_hz is not None:
        notes.append(Said("video-no-time-stamps", rate_hz=_figures(copy.assumed_rate_hz, 6)))
    if vfr:
        steps = np.diff(np.sort(time_s))
        least_s, most_s = round(float(steps.min()), 4), round(float(steps.max()), 4)
        notes.append(Said("video-rate-varies", least_s=least_s, most_s=most_s))
    if rate and facts.rate_hz and not vfr and abs(facts.rate_hz / rate - 1) > RATE_TOLERANCE:
        stated_hz = _figures(facts.rate_hz, 4)
        notes.append(Said("video-other-rate", stated_hz=stated_hz, rate_hz=_figures(rate, 4)))
    return notes


def _order_notes(duplicates: int, unordered: int) -> list[Said]:
    notes = []
    if duplicates:
        notes.append(Said("video-same-image", count=duplicates))
    if unordered:
        notes.append(Said("video-not-later", count=unordered))
    return notes


def _damage_notes(facts: VideoFacts, count: int, damage: Damage) -> list[Said]:
    notes = []
    claimed = facts.reported_frames
    if damage.reads:
        notes.append(Said("video-unreadable-end", count=count))
    if damage.packets:
        notes.append(Said("video-packets-damaged", count=damage.packets))
    if damage.patched:
        notes.append(Said("video-frames-patched", count=len(damage.patched), first=damage.patched[0]))
    if damage.other_size:
        notes.append(Said("video-other-size-skipped", count=damage.other_size))
    if claimed is not None and claimed != count:
        notes.append(Said("video-other-count", claimed=claimed, count=count))
    return notes


def _duration_notes(facts: VideoFacts, pts: NDArray[np.int64], time_s: NDArray[np.float64]) -> list[Said]:
    """Where the header counts no frames, its duration alone tells that some are gone."""
    if facts.reported_frames is not None or not _cut_short(facts, pts, time_s):
        return []
    end_s = _end_s(facts, pts, time_s)
    duration_s = round(facts.duration_s or 0.0, 1)
    return [Said("video-ends-early", duration_s=duration_s, end_s=round(end_s, 1))]


def _cut_short(facts: VideoFacts, pts: NDArray[np.int64], time_s: NDArray[np.float64]) -> bool:
    """Whether the recording ends long before its header says (an edit list or empty chunks do not count)."""
    claimed, count = facts.reported_frames, len(pts)
    if facts.duration_s is None or count == 0:
        return False
    if count >= claimed if claimed is not None else facts.container not in DURATION_IN_HEADER:
        return False
    return bool(_end_s(facts, pts, time_s) < 0.95 * facts.duration_s - 1.0)


def _end_s(facts: VideoFacts, pts: NDArray[np.int64], time_s: NDArray[np.float64]) -> float:
    """When the last picture is shown; by its stamp where that is later (durations may count from 0)."""
    return max(float(time_s.max()), float(pts.max()) * float(facts.time_base))
