"""Traffic of one lane past camera 1, interval by interval: flow, speeds, occupancy, density, lengths.

Intervals follow the clocks of the place: an interval of 5 minutes begins at a full hour or 5, 10, ... minutes
after it. One that the recording only touches is partial, and its figures are of the time that was watched.

Every vehicle that was found counts for flow and occupancy, also one that could not be measured or whose
motion was rejected; speeds and lengths are of those whose motion counts. The mean of the speeds at camera 1
is the time mean speed; their harmonic mean is the space mean speed, as a stretch of road shows it (Wardrop
1952). Flow over space mean speed is the density. Occupancy is the share of the time that some vehicle stood
before camera 1; vehicles beside each other are counted once. Where one stood and nobody saw it leave, it is
not told from there to the end: who comes later may have passed beside it. Of another whose rear nobody saw it
is not told to the first front after it was given up. Where one still stood when the recording before ended,
this one took it for the road and does not know until when it stood: it tells none, nor do those after it
until another has driven through. One of unknown lane may stand in any.

Uncertainties (k = 1) are those of measuring. A count has none of its own; `near_edge` says how many vehicles
passed so near to an edge that the clock leaves it open on which side (95 %); of one whose time has no u of
its own, the largest of the others' stands for it. `flow_low` and `flow_high` are the exact 95 % interval of
the rate of a Poisson process that such a count comes from (Garwood 1936): what to expect of as long a time
again, where vehicles come independently of each other.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from math import hypot, sqrt
from typing import Protocol, TypeVar

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.enums import ScanDirection
from sightline.linescan.parts import STANDS_S
from sightline.messages.said import Said

#: Lengths of an interval, minutes.
MINUTES = (1, 5, 15, 60)
#: Between the four length classes of England's trunk road counters (National Highways): up to 5.2 m, ...
LENGTH_LIMITS_M = (5.2, 6.6, 11.6)
#: From so many axles on they are counted together.
MANY_AXLES = 5
_HOUR_S = 3600.0
_TAIL = 0.025
#: Clocks are never put forward or back by so little, nor told that badly.
_CLOCK_STEP_S = 1.0
#: What edges are off by in floating point.
_ROUNDED_S = 1e-6
_NO_SPEED = Said("scan-flow-no-speed")
_REAR_UNSEEN = Said("scan-flow-rear-unseen")


@dataclass(frozen=True, slots=True)
class Passed:
    """A vehicle that passed camera 1, `since_s` after line 0 and for `occupied_s` (None: not known).

    `u_since_s`: of its time of day, None where unknown. The rest is None where no motion of it counts.
    `rig_ratio`: the share of `u_speed_mps` that the rig gives to all vehicles alike, over the speed.
    `refused`: its motion could not be measured; `stands`: it stood, and may still; `front_seen`: False of one
    that was in view when the recording began, `told_before`: one that another recording counts.
    """

    since_s: float
    occupied_s: float | None
    u_since_s: float | None = None
    speed_mps: float | None = None
    u_speed_mps: float | None = None
    length_m: float | None = None
    u_length_m: float | None = None
    rig_ratio: float = 0.0
    axles: int | None = None
    refused: bool = False
    stands: bool = False
    front_seen: bool = True
    told_before: bool = False


class Came(Protocol):
    """A vehicle as far as traffic is parted by it; None: not known."""

    @property
    def since_s(self) -> float | None: ...
    @property
    def direction(self) -> ScanDirection | None: ...
    @property
    def lane(self) -> str | None: ...


V = TypeVar("V", bound=Came)
#: A direction and a lane, None where it is not known or there are none.
Stream = tuple[ScanDirection, str | None]
#: Which camera those are taken to reach first of whom it is not known.
USUAL_DIRECTION: ScanDirection = "camera_1_first"


def streams_of(vehicles: Sequence[V]) -> dict[Stream, list[V]]:
    """Vehicles that follow each other: by direction and lane, in order, each stream rising by `since_s`, what
    has none last. Those of no known direction are of the first stream; where nobody's is known, they are
    taken to reach camera 1 first.
    """
    by_stream: dict[Stream, list[V]] = {}
    for one in vehicles:
        if one.direction is not None:
            by_stream.setdefault((one.direction, one.lane), []).append(one)
    in_order = sorted(by_stream, key=lambda key: (key[0], key[1] is None, key[1] or ""))
    streams = {key: by_stream[key] for key in in_order} or {(USUAL_DIRECTION, None): []}
    next(iter(streams.values())).extend(one for one in vehicles if one.direction is None)
    for stream in streams.values():
        stream.sort(key=lambda one: (one.since_s is None, one.since_s or 0.0))
    return streams


def strays_s(streams: Mapping[Stream, Sequence[V]], way: ScanDirection) -> list[float]:
    """The fronts of one direction's vehicles whose lane is not known where others' is, rising."""
    if all(lane is None for _, lane in streams):
        return []
    return sorted(one.since_s for one in streams.get((way, None), ()) if one.since_s is not None)


def headways_s(
    fronts_s: Sequence[float], front_seen: Sequence[bool], strays_s: Sequence[float] = ()
) -> list[float | None]:
    """From the front before to each of a stream's fronts (N,), rising; None for the first, where one of the
    two was not `front_seen` (N,), and where one of unknown lane (`strays_s`, rising) came since.
    """
    since = np.searchsorted(np.array(strays_s), np.array(fronts_s)).tolist()
    known = [all(both) for both in pairwise(front_seen)]
    none_since = [behind == ahead for ahead, behind in pairwise(since)]
    found = zip(pairwise(fronts_s), known, none_since, strict=True)
    return [None, *(b - a if known and none else None for (a, b), known, none in found)][: len(fronts_s)]


@dataclass(frozen=True, slots=True)
class Figure:
    """A number with its standard uncertainty; both None where there is none."""

    value: float | None = None
    u: float | None = None


@dataclass(frozen=True, slots=True)
class LengthClass:
    """Vehicles of one length class: longer than `above_m`, None: any, and up to `up_to_m`, None: any.

    `near_limit`: those of them that lie within their 95 % interval of a limit, and may be of the next class.
    `by_axles`: of them with 2, 3, 4, and 5 or more axles, and those whose axles are not known (or only one).
    """

    above_m: float | None
    up_to_m: float | None
    vehicles: int
    near_limit: int
    by_axles: tuple[int, int, int, int, int] = (0, 0, 0, 0, 0)


@dataclass(frozen=True, slots=True)
class Interval:
    """Traffic of `watched_s` seconds that begin `begin_s` after the first line's; see the module.

    `vehicles`: how many fronts passed; `refused`: those whose motion could not be measured; `measured`: those
    with a speed that counts; `unclassed`: those without a length that counts; `near_edge`: None where their
    times have no u. `speeds_mps`: the speeds, rising. `reasons`: why a figure is missing.
    """

    begin_s: float
    watched_s: float
    partial: bool
    vehicles: int
    near_edge: int | None
    refused: int
    measured: int
    flow_per_hour: float
    flow_low: float
    flow_high: float
    mean_headway_s: float | None
    time_mean_speed_mps: Figure
    space_mean_speed_mps: Figure
    occupancy_percent: Figure
    density_per_km: Figure
    classes: tuple[LengthClass, ...]
    unclassed: int
    speeds_mps: tuple[float, ...]
    reasons: tuple[Said, ...]


def intervals(
    passed: Sequence[Passed],
    watched_s: float,
    into_hour_s: Callable[[float], float],
    minutes: int,
    limits_m: Sequence[float] = LENGTH_LIMITS_M,
    *,
    stood_before: bool = False,
    strayed: Sequence[Passed] = (),
    strays_s: Sequence[float] = (),
) -> tuple[Interval, ...]:
    """The intervals of `minutes` that a recording of `watched_s` touches, in order.

    `passed`: rising by `since_s`. `into_hour_s`: what clocks of the place show beyond an hour, so many
    seconds after line 0. `limits_m`: rising. `stood_before`: one stood when the recording just before ended.
    `strayed`: those of unknown lane whose rear nobody saw, who may have stood in this one; `strays_s`:
    see `headways_s`.
    Who is still in view at the end counts until then. Raises ValueError for minutes that do not divide an
    hour.
    """
    if minutes < 1 or 60 % minutes:
        raise ValueError("Minutes of an interval must divide an hour.")
    long_s = 60.0 * minutes
    fronts_s = [max(one.since_s, 0.0) for one in passed]
    end_s = max([watched_s, *fronts_s])
    headways = headways_s(fronts_s, [one.front_seen for one in passed], strays_s)
    covered, edges = _covered(passed), _edges(into_hour_s, long_s, end_s)
    spans = [(max(begin_s, 0.0), min(stop_s, end_s)) for begin_s, stop_s in edges]
    unsure = _unsure(passed, fronts_s, end_s)
    unsure = np.concatenate([unsure.reshape(-1, 2), *([[max(one.since_s, 0.0), end_s]] for one in strayed)])
    begins, stops = np.searchsorted(np.array(fronts_s), np.array(spans).reshape(-1, 2).T).tolist()
    still = _still_there(passed, spans)
    largest_u_s = max((one.u_since_s for one in passed if one.u_since_s is not None), default=None)
    out = []
    for begin, before_stop, (begin_s, stop_s), before, of_clock in zip(
        begins, stops, spans, still, edges, strict=True
    ):
        stop = len(passed) if stop_s == end_s else before_stop
        out.append(
            _interval(
                passed[begin:stop],
                before,
                [
                    gap
                    for one, gap in zip(passed[begin:stop], headways[begin:stop], strict=True)
                    if gap is not None and not one.told_before
                ],
                None
                if stood_before or _overlap(unsure, begin_s, stop_s)
                else _overlap(covered, begin_s, stop_s),
                (begin_s, stop_s),
                of_clock,
                stop_s - begin_s < of_clock[1] - of_clock[0] - _ROUNDED_S,
                limits_m,
                largest_u_s,
            )
        )
    return tuple(out)


def _unsure(passed: Sequence[Passed], fronts_s: Sequence[float], end_s: float) -> NDArray[np.float64]:
    """Stretches (n, 2) of time of which nobody knows whether a vehicle stood before camera 1."""
    unseen = [(at, one.stands) for at, one in zip(fronts_s, passed, strict=True) if one.occupied_s is None]
    since_s = np.array([at for at, _ in unseen])
    given_up = np.searchsorted(fronts_s, since_s + STANDS_S)
    given_up[[stands for _, stands in unseen]] = len(fronts_s)
    return np.stack([since_s, np.array([*fronts_s, end_s])[given_up]], 1)


def _edges(into_hour_s: Callable[[float], float], long_s: float, end_s: float) -> list[tuple[float, float]]:
    """Where the intervals begin and stop by the clocks, seconds after line 0 (the first may begin before it,
    the last stop after the recording). Clocks that are put forward or back by less
    than an hour (Lord Howe Island: half of one) make one of them shorter.
    """
    out, at = list[tuple[float, float]](), -(into_hour_s(0.0) % long_s)
    while at < end_s:
        into_s = (into_hour_s(at) + _CLOCK_STEP_S) % long_s if at > 0 else 0.0
        stop = at + long_s - (into_s - _CLOCK_STEP_S if into_s > 2 * _CLOCK_STEP_S else 0.0)
        out.append((at, stop))
        at = stop
    return out


def _interval(
    inside: Sequence[Passed],
    before: Sequence[Passed],
    headways: Sequence[float],
    occupied_s: float | None,
    span: tuple[float, float],
    edges: tuple[float, float],
    partial: bool,
    limits_m: Sequence[float],
    largest_u_s: float | None,
) -> Interval:
    watched_s, standing = span[1] - span[0], [*before, *inside]
    inside = [one for one in inside if not one.told_before]
    moving = [one for one in inside if one.speed_mps]
    flow = _HOUR_S * len(inside) / watched_s
    low, high = poisson_interval(len(inside))
    time_mean, space_mean = mean_speeds(moving)
    occupancy = Figure()
    if occupied_s is not None:
        occupancy = Figure(100 * occupied_s / watched_s, _u_occupancy(standing, watched_s))
    reasons = [] if moving else [_NO_SPEED]
    if occupancy.value is None:
        reasons.append(_REAR_UNSEEN)
    elif occupancy.u is None:
        unmoved = sum(_u_standing_s(one) is None for one in standing)
        reasons.append(Said("scan-flow-no-u-occupancy", count=unmoved))
    lengths = [one for one in inside if one.length_m is not None]
    return Interval(
        begin_s=span[0],
        watched_s=watched_s,
        partial=partial,
        vehicles=len(inside),
        near_edge=None
        if inside and largest_u_s is None
        else sum(_near_edge(one, edges, largest_u_s or 0.0) for one in inside),
        refused=sum(one.refused for one in inside),
        measured=len(moving),
        flow_per_hour=flow,
        flow_low=_HOUR_S * low / watched_s,
        flow_high=_HOUR_S * high / watched_s,
        mean_headway_s=sum(headways) / len(headways) if headways else None,
        time_mean_speed_mps=time_mean,
        space_mean_speed_mps=space_mean,
        occupancy_percent=occupancy,
        density_per_km=_density(flow, space_mean),
        classes=length_classes(lengths, limits_m),
        unclassed=len(inside) - len(lengths),
        speeds_mps=tuple(sorted(one.speed_mps for one in moving if one.speed_mps)),
        reasons=tuple(reasons),
    )


@lru_cache(maxsize=10_000)
def poisson_interval(count: int) -> tuple[float, float]:
    """The exact 95 % interval of a Poisson process's mean, of which so many came (Garwood 1936)."""
    low = float(scipy.special.gammaincinv(count, _TAIL)) if count else 0.0
    return low, float(scipy.special.gammaincinv(count + 1, 1 - _TAIL))


def mean_speeds(moving: Sequence[Passed]) -> tuple[Figure, Figure]:
    """Time mean and space mean speed. What the rig gives to all alike does not shrink with their number."""
    speeds = [one.speed_mps for one in moving if one.speed_mps]
    if not speeds:
        return Figure(), Figure()
    n, ratio = len(speeds), max(one.rig_ratio for one in moving)
    time_mean, space_mean = sum(speeds) / n, n / sum(1 / speed for speed in speeds)
    own = [
        sqrt(max((one.u_speed_mps or 0.0) ** 2 - (one.rig_ratio * speed) ** 2, 0.0))
        for one, speed in zip(moving, speeds, strict=True)
    ]
    u_time = hypot(ratio * time_mean, hypot(*own) / n)
    weighed = [space_mean**2 / (n * speed**2) * u for speed, u in zip(speeds, own, strict=True)]
    return Figure(time_mean, u_time), Figure(space_mean, hypot(ratio * space_mean, *weighed))


def class_names(limits_m: Sequence[float]) -> list[str]:
    """Names of the classes that rising limits part: to 6 m, 6 to 12 m, above 12 m. A length at a limit is of
    the shorter class.
    """
    between = [f"{low:g} to {high:g} m" for low, high in pairwise(limits_m)]
    return [f"to {limits_m[0]:g} m", *between, f"above {limits_m[-1]:g} m"] if limits_m else []


def length_classes(measured: Sequence[Passed], limits_m: Sequence[float]) -> tuple[LengthClass, ...]:
    """How many vehicles lie between the limits, by the rule of `class_names`."""
    edges = (None, *limits_m, None)
    return _empty_classes(edges) if not measured else _classes(measured, edges)


def _classes(measured: Sequence[Passed], edges: tuple[float | None, ...]) -> tuple[LengthClass, ...]:
    return tuple(_class_between(measured, above, up_to) for above, up_to in pairwise(edges))


@lru_cache(maxsize=100)
def _empty_classes(edges: tuple[float | None, ...]) -> tuple[LengthClass, ...]:
    """The classes of an interval without traffic: most of those of a long recording."""
    return _classes((), edges)


def _class_between(measured: Sequence[Passed], above: float | None, up_to: float | None) -> LengthClass:
    inside = [
        vehicle
        for vehicle in measured
        if vehicle.length_m is not None
        and (above is None or vehicle.length_m > above)
        and (up_to is None or vehicle.length_m <= up_to)
    ]
    near = [
        vehicle
        for vehicle in inside
        if vehicle.length_m is not None
        and any(
            limit is not None and abs(vehicle.length_m - limit) <= COVERAGE_95 * (vehicle.u_length_m or 0.0)
            for limit in (above, up_to)
        )
    ]
    axles = [vehicle.axles or 0 for vehicle in inside]
    known = (axles.count(2), axles.count(3), axles.count(4), sum(count >= MANY_AXLES for count in axles))
    return LengthClass(above, up_to, len(inside), len(near), (*known, len(axles) - sum(known)))


def _density(flow_per_hour: float, space_mean: Figure) -> Figure:
    """Vehicles a kilometre: flow over space mean speed; its u is that of the speed."""
    if space_mean.value is None or space_mean.u is None:
        return Figure()
    value = flow_per_hour / (3.6 * space_mean.value)
    return Figure(value, value * space_mean.u / space_mean.value)


def _near_edge(one: Passed, edges: tuple[float, float], largest_u_s: float) -> bool:
    reach_s = COVERAGE_95 * (largest_u_s if one.u_since_s is None else one.u_since_s)
    return any(abs(one.since_s - edge) <= reach_s for edge in edges)


def _still_there(passed: Sequence[Passed], spans: Sequence[tuple[float, float]]) -> list[list[Passed]]:
    """For each of the spans of time, rising, the vehicles that came before it and stand in it."""
    standing: list[list[Passed]] = [[] for _ in spans]
    begins_s = np.array([begin_s for begin_s, _ in spans])
    fronts_s = np.array([max(one.since_s, 0.0) for one in passed])
    rears_s = np.array([one.since_s + (one.occupied_s or 0.0) for one in passed])
    first = np.searchsorted(begins_s, fronts_s, side="right")
    last = np.searchsorted(begins_s, rears_s)
    for one in np.flatnonzero(first < last).tolist():
        for at in range(first[one], last[one]):
            standing[at].append(passed[one])
    return standing


def _u_occupancy(standing: Sequence[Passed], watched_s: float) -> float | None:
    """Of the vehicles that stood before the camera meanwhile; None where it is not known of one."""
    each_s = [_u_standing_s(one) for one in standing]
    known_s = [one for one in each_s if one is not None]
    return 100 * hypot(*known_s) / watched_s if len(known_s) == len(each_s) else None


def _u_standing_s(one: Passed) -> float | None:
    """A vehicle's time before the camera is known at least as well as its length over its speed."""
    return one.u_length_m / one.speed_mps if one.speed_mps and one.u_length_m is not None else None


def _covered(passed: Sequence[Passed]) -> NDArray[np.float64]:
    """Stretches (n, 2) of time in which some vehicle stood before camera 1, apart from each other."""
    out: list[tuple[float, float]] = []
    for one in passed:
        begin, end = one.since_s, one.since_s + (one.occupied_s or 0.0)
        if out and begin <= out[-1][1]:
            out[-1] = (out[-1][0], max(out[-1][1], end))
        else:
            out.append((begin, end))
    return np.array(out, dtype=np.float64).reshape(-1, 2)


def _overlap(covered: NDArray[np.float64], begin_s: float, stop_s: float) -> float:
    within = np.minimum(covered[:, 1], stop_s) - np.maximum(covered[:, 0], begin_s)
    return float(within[within > 0].sum())
