"""Which passes of a survey are to be measured, and what became of them: selection, quotas, response rates.

A pass is selected by its number in the survey, which it keeps, and by its headway: who has numbers, rule and
times can tell again which passes were to be measured.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import get_args

from sightline.enums import (
    AskedTarget,
    ClassSet,
    Lighting,
    PassEnd,
    ResponseLighting,
    ResponseSet,
    SamplingMethod,
)
from sightline.statistics.distributions import share_interval

MOST_STEP, MOST_HEADWAY_S = 1000, 60.0


@dataclass(frozen=True, slots=True)
class Quota:
    """How many vehicles are wanted of one lighting and one set of classes, None for any class."""

    lighting: Lighting
    class_set: ClassSet | None
    wanted: int


@dataclass(frozen=True, slots=True)
class Sampling:
    """The rule: every pass, each `step`-th from `start` on, or a share drawn by `seed`; of them, where
    `free_flowing_s` is given, those at least so many seconds behind the pass before in their direction.

    `outside_counts`: whether heights of passes that it does not take count in results all the same.
    """

    method: SamplingMethod = "every"
    step: int = 1
    start: int = 1
    share_percent: float = 100.0
    seed: int = 1
    free_flowing_s: float | None = None
    quotas: tuple[Quota, ...] = ()
    outside_counts: bool = False

    @property
    def takes_all(self) -> bool:
        return self.method == "every" and self.free_flowing_s is None

    @property
    def leaves_out(self) -> bool:
        """Whether there may be heights that count in no result because their pass is out of the sample."""
        return not self.takes_all and not self.outside_counts


@dataclass(frozen=True, slots=True)
class PassTime:
    """When a pass of a recording begins; `counts` is false for one that was discarded."""

    vehicle_id: int
    recording_id: int
    direction: str | None
    begins_s: float
    counts: bool


@dataclass(frozen=True, slots=True)
class PassAnswers:
    """What became of a pass: targets `measured`, by a height not rejected, and answered `not_visible`."""

    lighting: Lighting | None
    class_set: ClassSet | None
    in_sample: bool
    discarded: bool
    asked: tuple[AskedTarget, ...]
    measured: frozenset[str]
    not_visible: frozenset[str]

    @property
    def end(self) -> PassEnd:
        """How it ends; one that was measured though out of the sample ends as out of it."""
        if self.discarded:
            return "discarded"
        if not self.in_sample:
            return "out_of_sample"
        if not set(self.asked) <= self.measured | self.not_visible:
            return "open"
        return "measured" if self.measured else "not_visible"


@dataclass(frozen=True, slots=True)
class Response:
    """Passes of a lighting and a set by how they end; `target` is None for the vehicle as a whole.

    `rate` is measured over in_sample, with the exact binomial 95 % interval (Clopper and Pearson 1934); None
    while there is no pass. `outside` counts passes that were measured though they are out of the sample.
    """

    lighting: ResponseLighting
    class_set: ResponseSet
    target: AskedTarget | None
    passes: int
    discarded: int
    out_of_sample: int
    in_sample: int
    measured: int
    not_visible: int
    open: int
    outside: int
    rate: float | None
    low: float | None
    high: float | None


def is_in_sample(rule: Sampling, number: int, headway_s: float | None) -> bool:
    """Whether the pass of a number is to be measured; `headway_s` None: none goes before it.

    A share is drawn by SplitMix64 (Steele, Lea and Flood 2014) of seed and number, so that a pass found later
    changes no other's lot.
    """
    if rule.free_flowing_s is not None and headway_s is not None and headway_s < rule.free_flowing_s:
        return False
    if rule.method == "nth":
        return number >= rule.start and (number - rule.start) % rule.step == 0
    if rule.method == "share":
        return _mixed((rule.seed << 32) + number) / 2.0**64 < rule.share_percent / 100.0
    return True


def counts_in_results(rule: Sampling, in_sample: bool, check_target: bool) -> bool:
    """Whether the heights of a pass count: THE population of every result. A check target is no vehicle of
    the traffic; its errors are told apart.
    """
    return not check_target and (in_sample or rule.outside_counts)


def _mixed(state: int) -> int:
    """The number of 64 bits that SplitMix64 gives at a state."""
    bits = 2**64 - 1
    z = (state + 0x9E3779B97F4A7C15) & bits
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & bits
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & bits
    return z ^ (z >> 31)


def headways(passes: Iterable[PassTime]) -> dict[int, float]:
    """Seconds from the beginning of the pass before, of the same recording and direction, by vehicle.

    The first has none. Discarded passes are no vehicles: none is behind them.
    """
    last: dict[tuple[int, str | None], float] = {}
    seconds: dict[int, float] = {}
    for passing in sorted(passes, key=lambda one: (one.recording_id, one.begins_s, one.vehicle_id)):
        key = (passing.recording_id, passing.direction)
        if key in last:
            seconds[passing.vehicle_id] = passing.begins_s - last[key]
        if passing.counts:
            last[key] = passing.begins_s
    return seconds


def response(passes: Iterable[PassAnswers]) -> list[Response]:
    """The table of response: by lighting, by set, and by target; groups without a pass are left out."""
    groups: dict[tuple[str, str], list[PassAnswers]] = {}
    for passing in passes:
        for lighting in ("all", passing.lighting or "unknown"):
            for class_set in ("all", passing.class_set or "none"):
                groups.setdefault((lighting, class_set), []).append(passing)
    return [row for key in sorted(groups, key=_order) for row in _rows_of_group(*key, groups[key])]


def _order(key: tuple[str, str]) -> tuple[int, ...]:
    return get_args(ResponseLighting).index(key[0]), get_args(ResponseSet).index(key[1])


def _rows_of_group(lighting: str, class_set: str, passes: list[PassAnswers]) -> Iterator[Response]:
    yield _row_of_ends(lighting, class_set, None, passes, Counter(one.end for one in passes))
    for target in get_args(AskedTarget):
        of = [one for one in passes if target in one.asked]
        if of:
            yield _row_of_ends(lighting, class_set, target, of, Counter(_end_of(one, target) for one in of))


def _end_of(passing: PassAnswers, target: AskedTarget) -> PassEnd:
    if passing.end in ("discarded", "out_of_sample"):
        return passing.end
    if target in passing.measured:
        return "measured"
    return "not_visible" if target in passing.not_visible else "open"


def _row_of_ends(
    lighting: str,
    class_set: str,
    target: AskedTarget | None,
    passes: list[PassAnswers],
    ends: Mapping[PassEnd, int],
) -> Response:
    wanted = ends.get("measured", 0) + ends.get("not_visible", 0) + ends.get("open", 0)
    measured = ends.get("measured", 0)
    low = high = None
    if wanted:
        low, high = share_interval(measured, wanted)
    return Response(
        lighting=lighting,  # type: ignore[arg-type]
        class_set=class_set,  # type: ignore[arg-type]
        target=target,
        passes=len(passes),
        discarded=ends.get("discarded", 0),
        out_of_sample=ends.get("out_of_sample", 0),
        in_sample=wanted,
        measured=measured,
        not_visible=ends.get("not_visible", 0),
        open=ends.get("open", 0),
        outside=sum(
            bool(one.measured if target is None else target in one.measured)
            for one in passes
            if one.end == "out_of_sample"
        ),
        rate=measured / wanted if wanted else None,
        low=low,
        high=high,
    )
