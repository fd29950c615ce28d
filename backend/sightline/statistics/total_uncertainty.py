"""Total uncertainty of percentiles, means, spreads and shares of heights (JCGM 101:2008, GUM Supplement 1).

What an interval holds: the sample; sites as clusters, where heights of several are pooled (`sites`); errors
that many heights share (`shared_errors`); the random error of each height, which widens a distribution and is
taken out of the value (`deconvolution`). Their distributions are propagated by draws, always the same ones.
One site, or no word of sites, gives intervals for that place and those days alone.

One engine serves a survey and a study: a survey is a study of one stratum in which all heights weigh alike.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints
from sightline.coverage import COVERAGE_95, MEAN_OF_INSET
from sightline.enums import IntervalPart
from sightline.messages.said import Said
from sightline.statistics.deconvolution import LEAST_SPREAD, SmoothDensity, noise_of, smooth_density
from sightline.statistics.distributions import PERCENTILES, too_few_for, vehicles_for_interval
from sightline.statistics.drawn import Drawn, Sampled, reorder_design
from sightline.statistics.draws import LEVELS, OTHER, TAIL, ends_of, normal_draws
from sightline.statistics.figures import TotalFigure, TotalPercentile, without_interval
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.sites import sites_of
from sightline.statistics.study_plan import Components
from sightline.statistics.survey_design import Design
from sightline.statistics.wording import interval_contents

_SHAPE = 0.1  # of a correction for random error: what a density of another shape may change it by (k = 1)
_WIDEST, _IN_WINDOW = 0.5, 2.0  # scores, heights of a site about a percentile, by which sites are compared
_INSIDE = (1e-15, 1.0 - 1e-15)  # ranks that have a score
_WINDOW = 0.10  # of all heights, on either side of a percentile: those that say which groups it rests on
_LEAST_IN_WINDOW = 25
_UNLIKE = 0.55  # of the spread on the narrower side, by which sites differ: few hold what they say then
_LARGEST = 30.0  # of the logarithm of a variance's ratio, beyond which numbers end
_NODES = 20_000  # at which smooth functions of more heights are computed


@dataclass(frozen=True, eq=False)
class HeightSample:
    """Heights (N,) with the parts of their uncertainty, metres.

    u_random_m: (N,), of what no other height shares; site: (N,), codes of any kind, or None.
    """

    height_m: Floats
    u_random_m: Floats
    shared: tuple[SharedErrors, ...] = ()
    site: Ints | None = None

    def where(self, chosen: Ints | NDArray[np.bool_]) -> HeightSample:
        """The rows that are `chosen` (M,), by number, or (N,), by truth."""
        shared = tuple(one.where(chosen) for one in self.shared)
        site = None if self.site is None else self.site[chosen]
        return HeightSample(self.height_m[chosen], self.u_random_m[chosen], shared, site)


def sample_of_measurements(
    height_m: Floats,
    u_height_m: Floats,
    u_clicks_m: Floats,
    u_by_inset_m: Floats,
    pose: Ints,
    inset: Ints,
    site: Ints | None = None,
    pose_names: Ints | None = None,
) -> HeightSample:
    """Heights with their budgets, as the figures of a distribution want them.

    Own reading of the budget: clicks are random; what neither clicks nor inset explain (lens, pose, board) is
    shared by all heights of a pose; of an assumed inset half the variance is the vehicles' own and half that
    of its mean, which all heights with that inset share, for no inset's source says how much.

    Parameters
    ----------
    height_m, u_height_m : (N,) array
        Heights and their standard uncertainties, metres.
    u_clicks_m, u_by_inset_m : (N,) array
        The parts of u that come from clicks and from an assumed inset, metres; where they are not known (NaN)
        all of u is taken as the pose's.
    pose, inset : (N,) array of int
        Codes from 0: which pose and which inset a height used.
    site : (N,) array of int, optional
        Codes from 0; heights of one site go together.
    pose_names : (G,) array of int, optional
        By which another sample knows each pose.

    Returns
    -------
    HeightSample

    Examples
    --------
    >>> import numpy as np, sightline
    >>> height_m = np.random.default_rng(1).normal(1.45, 0.08, 60)
    >>> parts_m = np.full(60, 0.01), np.full(60, 0.006), np.full(60, 0.005)
    >>> one = np.zeros(60, np.int64)
    >>> sample = sightline.sample_of_measurements(height_m, *parts_m, pose=one, inset=one)
    >>> sample.height_m.shape
    (60,)
    """
    clicks, by_inset = np.nan_to_num(u_clicks_m), np.nan_to_num(u_by_inset_m)
    by_pose = np.sqrt(np.maximum(np.nan_to_num(u_height_m) ** 2 - clicks**2 - by_inset**2, 0.0))
    shared = (
        SharedErrors(pose, by_pose, pose_names),
        SharedErrors(inset, by_inset * np.sqrt(MEAN_OF_INSET)),
    )
    random = np.sqrt(clicks**2 + (1.0 - MEAN_OF_INSET) * by_inset**2)
    return HeightSample(height_m, random, tuple(one for one in shared if np.any(one.u_m > 0.0)), site)


@dataclass(frozen=True, eq=False)
class _Confidence:
    """A percentile: its value and draws (D,) of what it may be, ascending, metres, and the design effect."""

    value_m: float
    possible_m: Floats
    effect: float


class TotalUncertainty:
    """Figures of one sample of heights (N,), N > 0, each with its total uncertainty.

    design: what each height stands for and how sites were drawn; None: all heights weigh alike, and the
    sample's own sites are some of many; where there is a design, the sample's own are not read. Coverage of
    the intervals by simulation: docs/proofs.md, DECISIONS.md 31.
    """

    def __init__(self, sample: HeightSample, design: Design | None = None) -> None:
        order = np.argsort(sample.height_m, kind="stable")
        design = reorder_design(_one_stratum(sample) if design is None else design, order)
        self._height_m = sample.height_m[order]
        self._shared = tuple(one.where(order) for one in sample.shared)
        self._drawn = Drawn(design, self._shared)
        self._site = design.site
        share = design.weight / design.weight.sum()
        self._alike = bool(np.ptp(share) <= 1e-12 * share.max())
        self._share = np.full(len(share), 1.0 / len(share)) if self._alike else share
        # Heights of equal weight that would tell a mean as well (Kish 1965, 11.7).
        self._n = float(self.n) if self._alike else 1.0 / float(np.square(share).sum())
        weighs = None if self._alike else self._share
        spread_m2 = sum(one.spread_m2(weighs) for one in self._shared)
        # Sites show by their differences what their shared errors were; a sample of one site does not.
        compares = self._drawn.compares_sites
        unknown = 0.0 if compares else sum(one.variance_of_spread_m4(weighs) for one in self._shared)
        self._u_spread_m2 = float(np.sqrt(unknown))
        self._noise = noise_of(sample.u_random_m[order], spread_m2, weighs)
        self._noise_m2 = self._noise.variance_m2
        self._random = bool(np.any(sample.u_random_m > 0.0))
        # Of a mean, what the heights' own errors are known to make at least.
        self._known_m2 = float(np.sum(np.square(self._share * sample.u_random_m[order])))
        self._known_m2 += self._drawn.of_all_m2

    @cached_property
    def _density(self) -> SmoothDensity | None:
        """Of the true heights; a mean needs none."""
        return smooth_density(self._height_m, self._noise, None if self._alike else self._share)

    @cached_property
    def _cell(self) -> Ints:
        """The density's cell of each height, (N,)."""
        assert self._density is not None
        return self._density.cell_of(self._height_m)

    @cached_property
    def _middle(self) -> Floats:
        """The share below the middle of each height's own, (N,)."""
        return np.clip(np.cumsum(self._share) - 0.5 * self._share, *_INSIDE)

    @cached_property
    def _smooth_parts(self) -> tuple[Floats, Ints, Floats]:
        """Nodes (M,) of the heights' normal scores, equal heights having that of their middle; the node of
        each height (N,), and the share of heights at each node (M,).
        """
        first = np.concatenate([[True], np.diff(self._height_m) > 0.0])
        group = np.cumsum(first) - 1
        share = np.bincount(group, self._share)
        score = scipy.special.ndtri(np.clip(np.cumsum(share) - 0.5 * share, *_INSIDE))
        nodes, node = _nodes(np.asarray(score[group], dtype=np.float64))
        return nodes, node, np.bincount(node, self._share, len(nodes)).astype(np.float64)

    @property
    def n(self) -> int:
        """How many heights."""
        return len(self._height_m)

    @property
    def sites(self) -> int | None:
        """How many sites are the clusters; None where heights stand for one place."""
        there = int(np.count_nonzero(np.bincount(self._site)))
        return there if self._drawn.compares_sites else None

    @property
    def holds(self) -> tuple[IntervalPart, ...]:
        """What the intervals hold."""
        parts: dict[IntervalPart, bool] = {
            "sampling": True,
            "sites": self.sites is not None,
            "shared_errors": bool(self._shared),
            "random_error": self._random,
        }
        return tuple(part for part, there in parts.items() if there)

    @property
    def holds_in_words(self) -> Said:
        """What the intervals hold, and for which roads, as the end of a sentence."""
        random = Said("stat-random-error-removed")
        return interval_contents(self.holds, self.sites, random, unlike=self.sites_are_unlike)

    @cached_property
    def sites_are_unlike(self) -> bool:
        """Whether sites differ so much that intervals of percentiles far from the median hold the truth less
        often than they say (docs/proofs.md, "Sites that differ as their vehicles do").
        """
        ranks = [0.05, 0.4, 0.5, 0.6, 0.95]
        low, below, median, above, high = np.interp(ranks, self._middle, self._height_m)
        beside_median = np.asarray(0.5 - (self._height_m <= median), dtype=np.float64)
        between_m = self._drawn.between(beside_median * (above - below) / 0.2)
        spread_m = min(median - low, high - median) / 1.645  # of a normal distribution, its SD
        return self.sites is not None and between_m > _UNLIKE * float(spread_m)

    def percentile(self, percent: float) -> TotalPercentile:
        """THE percentile, 0 < percent < 100, metres: of the true heights, with its total 95 % interval.

        The value is the sample's (Hyndman & Fan 1996, type 8) with the correction of `deconvolution`. Its
        interval without sites is that of order statistics (David & Nagaraja 2003, 7.1), read between ranks;
        with sites it is Student's, of the rank (Woodruff 1952), as much longer on one side. Percentiles
        never run backwards: values and intervals are put in order from the median outwards, so that what is
        little known moves nothing that is known better. Without support there is a count in place of a value.
        """
        raw = float(self._quantile(percent / 100.0, 0.5, -1.0))
        needs = vehicles_for_interval(percent)
        known = self._find_confidence(percent)
        if isinstance(known, Said):
            value = self._percentile_m(percent / 100.0) if self._supported(percent) else None
            return TotalPercentile(
                percent=percent, value=value, U95_low=None, U95_high=None, raw=raw, needs=needs, reason=known
            )
        low, high = ends_of(known.possible_m)
        return TotalPercentile(
            percent=percent,
            value=known.value_m,
            U95_low=low,
            U95_high=high,
            raw=raw,
            needs=needs,
            effect=known.effect,
        )

    def percentile_draws(self, percent: float) -> tuple[float, Floats] | Said:
        """A percentile's value and draws of its error (D,), metres, ascending, or the reason why there are
        none.

        The same as `percentile`'s.
        """
        found = self._find_confidence(percent)
        return found if isinstance(found, Said) else (found.value_m, found.possible_m - found.value_m)

    @cached_property
    def _in_order(self) -> dict[float, _Confidence]:
        """Those of `PERCENTILES` that have support, none below one of a smaller percent: the distributions of
        what is known of each, put in order at every level.
        """
        there = [one for one in PERCENTILES if self._supported(one)]
        confidences = [self._confidence(one / 100.0) for one in there]
        if not confidences:
            return {}
        values = _outwards(there, np.array([one.value_m for one in confidences]))
        possible = _outwards(there, np.array([one.possible_m for one in confidences]))
        return {
            percent: _Confidence(float(value), draws, one.effect)
            for percent, value, draws, one in zip(there, values, possible, confidences, strict=True)
        }

    def _find_confidence(self, percent: float) -> _Confidence | Said:
        if not self._supported(percent):
            return too_few_for(percent, self.n, int(self._n + 1e-9))
        if not self._drawn.tells_spread:
            return self._drawn.more_needed()
        if self._spread_unknown is not None:
            return self._spread_unknown
        if percent in self._in_order:
            return self._in_order[percent]
        own = self._confidence(percent / 100.0)
        possible, value = own.possible_m, own.value_m
        for other, neighbour in self._in_order.items():  # between its neighbours
            keep = np.minimum if other > percent else np.maximum
            possible = keep(possible, neighbour.possible_m)
            value = float(keep(value, neighbour.value_m))
        return _Confidence(value, possible, own.effect)

    def _supported(self, percent: float) -> bool:
        return vehicles_for_interval(percent) <= int(self._n + 1e-9)

    def _confidence(self, p: float) -> _Confidence:
        assert self._density is not None
        at, slope = self._percentile_m(p), self._slope(p, self._density)
        own = np.asarray((p - (self._height_m <= at)) / slope, dtype=np.float64)
        # Between ranks the share below is one of few numbers and its variance not quite p (1 - p).
        own *= np.sqrt(p * (1.0 - p)) / slope / max(self._deviation(own), 1e-12)
        of_correction = self._density.correction_influence_m(p, self._least_density(p, self._density))[
            self._cell
        ]
        smooth = [one + of_correction for one in self._smooth_influences(p, slope)]
        sampled = self._drawn.sampled(own + of_correction, smooth)
        plain_m2 = p * (1.0 - p) / slope**2
        correction = self._correction_m(p, self._density)
        u_m2 = self._unseen(sampled, self._near(p)) + (_SHAPE * correction) ** 2
        u_m2 += (correction * self._u_spread_m2 / max(self._noise_m2, 1e-12)) ** 2
        draws = self._draws(sampled, p, slope) - at
        error = np.sort(draws + np.sqrt(u_m2) * normal_draws())
        return _Confidence(at + correction, at + correction + error, sampled.variance * self.n / plain_m2)

    def _draws(self, by_design: Sampled, p: float, slope: float) -> Floats:
        """Draws (D,) of percentile p of the measured heights by its design, metres: errors of its rank, on
        the scale of normal scores, where no distribution has a gap or a bend, are carried to heights by the
        sample's own quantiles (Woodruff 1952; docs/proofs.md, "Percentiles in a gap"); what shared errors
        move the sites by moves heights as it is.

        Without sites the scores are those of order statistics, as much wider as the design makes them; with
        them they are Student's, as much longer on one side as those of order statistics are. What few sites
        have says nothing of heights that none of them has: the error as it is, in metres, counts where it
        goes further.
        """
        n, ranked, place = self._n, self._order_scores(p), self._score_of(p)
        per_score = _height_per_score(p, slope)
        plain = float(np.sqrt(p * (1.0 - p) / n)) / (slope * per_score)  # standard error of the score
        if not self._drawn.compares_sites:
            wider = float(by_design.variance * (n - 1.0) / (n * (plain * per_score) ** 2))
            return self._height_at(place + (ranked - place) * np.sqrt(max(wider, 0.0)), per_score)
        low, high = ends_of(ranked - place)
        deviate, other = by_design.draws(), by_design.other_draws()
        longer = np.where(deviate < 0.0, -low, high) / (COVERAGE_95 * plain)
        deviate = deviate * np.sqrt(by_design.within * longer**2 + 1.0 - by_design.within)
        of_shift = by_design.shift
        moved = of_shift * deviate - np.sqrt(of_shift * (1.0 - of_shift)) * other
        ranked = np.sort(self._height_at(place + (deviate - moved) / per_score, per_score) + moved)
        linear, below = self._percentile_m(p) + deviate, deviate < 0.0
        return np.where(below, np.minimum(ranked, linear), np.maximum(ranked, linear))

    def named_effects_m(self, percent: float) -> dict[int, float]:
        """What one standard uncertainty of each error that other samples know (a road pose's) moves a
        percentile by, metres, by the error's name.

        Of the heights whose ranks lie about it, as in its own uncertainty.
        """
        near = self._near(percent / 100.0)
        found: dict[int, float] = {}
        for one in self._shared:
            found |= one.where(near).named_of_mean_m(self._share[near])
        return found

    def components(self, percent: float) -> Components | None:
        """What makes a percentile uncertain, for the plan of another study; None where it has no interval.

        What sites differ by beyond sampling within them is taken from the variance that they show (moments,
        Cochran 1954), their road poses' errors included.
        """
        p = percent / 100.0
        if self._density is None or self._spread_unknown is not None or not self._supported(percent):
            return None
        slope = self._slope(p, self._density)
        sampling = float(np.sqrt(p * (1.0 - p))) / slope
        found, smooth = max(
            ((self._drawn.sampled(one), one) for one in self._smooth_influences(p, slope)),
            key=lambda pair: pair[0].variance,
        )
        return Components(sampling, self._drawn.between(smooth), float(np.sqrt(found.unseen)))

    def mean(self) -> TotalFigure:
        """The mean height, metres: random errors leave it as it is, and it is no surer than they are, however
        close together the heights lie.
        """
        value = float(self._height_m.mean()) if self._alike else self._mean(self._height_m)
        if self.n < 2 or not self._drawn.tells_spread:
            return without_interval(self._too_few(max(self.n + 1, 2)), value)
        influence = self._height_m - value
        found = self._drawn.sampled(influence)
        u_m2 = self._unseen(found, np.arange(self.n))
        if found.variance == u_m2 == self._known_m2 == 0.0:
            return without_interval(Said("stat-true-heights-alike"), value)
        low, high = ends_of(found.draws() + np.sqrt(u_m2) * normal_draws())
        least = COVERAGE_95 * float(np.sqrt(self._known_m2))
        low, high = min(low, -least), max(high, least)
        plain = self._mean(np.square(influence)) / self.n
        effect = found.variance / plain if plain > 0.0 else None
        return TotalFigure(value, value + low, value + high, effect=effect)

    def sd(self) -> TotalFigure:
        """The standard deviation of the true heights, metres: what the errors added to it is taken out.

        0 where errors explain it all; a reason where they would have set the heights further apart.
        """
        if self.n < 3 or not self._drawn.tells_spread:
            return without_interval(self._too_few(max(self.n + 1, 3)))
        if self._spread_unknown is not None:
            return without_interval(self._spread_unknown)
        value, low, high = np.sqrt(np.maximum(self._true_m2, 0.0))
        return TotalFigure(float(value), float(low), float(high))

    @cached_property
    def _true_m2(self) -> tuple[float, float, float]:
        """The variance of the true heights and the ends of its interval, as estimated: below 0 where heights
        scatter less than their errors. The logarithm of the measured variance has a Student interval.
        """
        apart = np.square(self._height_m - self._mean(self._height_m))
        measured_m2 = self._mean(apart) * self._n / (self._n - 1.0)
        found = self._drawn.sampled(apart - self._mean(apart), height=False)
        draws = (
            measured_m2 * np.expm1(np.minimum(found.draws() / max(measured_m2, 1e-12), _LARGEST))
            + self._u_spread_m2 * normal_draws()
        )
        value = measured_m2 - self._noise_m2
        low, high = ends_of(draws)
        return value, value + low, value + high

    @cached_property
    def _spread_unknown(self) -> Said | None:
        """Why nothing is known of how far the true heights lie apart, None where it is."""
        if self._height_m.std() <= LEAST_SPREAD:
            return Said("stat-true-heights-alike")
        return Said("stat-heights-closer-than-errors") if self._true_m2[2] <= 0.0 else None

    def share_below(self, limit_m: float) -> TotalFigure:
        """The share of the true heights below a limit, 0 to 1.

        Sampling by Jeffreys' interval (Brown, Cai & DasGupta 2001), of the heights that a sample without
        sites would need for the same variance (Korn & Graubard 1998).
        """
        plain = self._mean(self._height_m < limit_m)
        if self._density is None or not self._drawn.tells_spread:
            return without_interval(self._too_few(vehicles_for_interval(50.0)), plain)
        if self._spread_unknown is not None:
            return without_interval(self._spread_unknown, plain)
        correction = self._density.share_correction(limit_m)
        n = self._effective_n(plain, limit_m)
        draws = scipy.special.betaincinv(n * plain + 0.5, n * (1.0 - plain) + 0.5, LEVELS) - plain
        near = self._near(plain)
        compares = self._drawn.compares_sites
        shared_m2 = 0.0 if compares else self._unseen(Sampled(0.0, 1.0, 0.0), near)
        u2 = self._density.true_density(limit_m) ** 2 * shared_m2 + (_SHAPE * correction) ** 2
        low, high = ends_of(draws + np.sqrt(u2) * normal_draws())
        value = float(np.clip(plain + correction, 0.0, 1.0))
        return TotalFigure(value, max(value + low, 0.0), min(value + high, 1.0))

    def _effective_n(self, share: float, limit_m: float) -> float:
        compares = self._drawn.compares_sites
        if not 0.0 < share < 1.0 or (self._alike and not compares):
            return self._n
        influence = np.asarray((self._height_m < limit_m) - share, dtype=np.float64)
        found = self._drawn.sampled(influence, height=False)
        wider = float(scipy.special.stdtrit(found.freedom, 1.0 - TAIL)) / COVERAGE_95 if compares else 1.0
        return min(share * (1.0 - share) / max(found.variance * wider**2, 1e-12), float(self.n))

    def _too_few(self, needed: int) -> Said:
        if self.n >= needed:
            return Said("stat-true-heights-alike")
        return Said("stat-heights-needed", needed=needed, count=self.n)

    def _unseen(self, sampled: Sampled, near: Ints) -> float:
        """Variance of what heights share that sites do not show; of one site, all of it, by the rows `near`
        (M,) that the figure rests on.
        """
        if self._drawn.compares_sites:
            return sampled.unseen
        weight = None if self._alike else self._share[near]
        return sum(one.where(near).variance_of_mean_m2(weight) for one in self._shared)

    def _deviation(self, values: Floats) -> float:
        """The standard deviation of values (N,), as they weigh."""
        return float(np.sqrt(self._mean(np.square(values - self._mean(values)))))

    def _mean(self, values: Floats | NDArray[np.bool_]) -> float:
        """The mean of values (N,), as they weigh. A product of vectors would hang on the threads of BLAS."""
        return float(np.sum(self._share * values))

    def _percentile_m(self, p: float) -> float:
        """Percentile p of the measured heights, without bias of the median (Hyndman & Fan 1996, type 8)."""
        return float(self._quantile(p, -1.0 / 6.0, 1.0 / 3.0))

    def _quantile(self, p: float, first: float, more: float) -> float:
        """The height at rank p (n + `more`) + `first` + 1/2 of n that weigh alike (Hyndman & Fan 1996);
        weighted, n is as many as tell a mean as well.
        """
        n = self._n
        place = np.array([(p * (n + more) + first) / n])
        return float(np.interp(place, self._middle, self._height_m)[0])

    def _score_of(self, p: float) -> float:
        """The score of percentile p of the measured heights: of the rank that `_percentile_m` has."""
        rank = p + (p - 0.5) / (3.0 * self._n)
        return float(scipy.special.ndtri(np.clip(rank, self._middle[0], self._middle[-1])))

    def _height_at(self, score: Floats, steepest: float) -> Floats:
        """The measured heights of normal scores (D,), metres: those at the ranks of which these are scores;
        beyond the outermost height those of a normal distribution through it and the median, no wider than
        `steepest`, metres per score.
        """
        heights, middle = self._height_m, self._middle
        found = np.interp(scipy.special.ndtr(score), middle, heights)
        median = float(np.interp(0.5, middle, heights))
        for outermost, end in ((heights[0], middle[0]), (heights[-1], middle[-1])):
            last = float(scipy.special.ndtri(end))
            beyond = (score - last) * np.sign(last) > 0.0
            found[beyond] = outermost + (score[beyond] - last) * min((outermost - median) / last, steepest)
        return np.asarray(found, dtype=np.float64)

    def _order_scores(self, p: float) -> Floats:
        """Scores (D,) of percentile p by its confidence distribution, of order statistics.

        The height of rank x lies above it with probability 1 - I_p(x, n - x + 1), which is read between whole
        ranks too, and weighted ones. Beyond the outermost height the limit lies where the outermost of n
        would reach the percentile with the probability wanted.
        """
        n = self._n
        reach = 5.0 * np.sqrt(n * p * (1.0 - p)) + 6.0
        rank = np.linspace(max(n * p - reach, 1.0), min(n * p + reach, n), 500)
        level = 1.0 - scipy.special.betainc(rank, n - rank + 1.0, p)
        score = np.asarray(scipy.special.ndtri((np.interp(LEVELS, level, rank) - 0.5) / n))
        low, high = (1.0 - p) ** n > LEVELS, 1.0 - p**n < LEVELS
        outermost, middle = float(scipy.special.ndtri(0.5 / n)), float(scipy.special.ndtri(p))
        score[low] = outermost - (scipy.special.ndtri(1.0 - LEVELS[low] ** (1.0 / n)) - middle)
        score[high] = -outermost + (middle - scipy.special.ndtri((1.0 - LEVELS[high]) ** (1.0 / n)))
        return np.asarray(score, dtype=np.float64)

    def _correction_m(self, p: float, density: SmoothDensity) -> float:
        """What is to be added for random errors at p, metres, no more than if all spread were theirs: by
        a gap between two kinds of vehicles smooth densities may find p on either side.
        """
        most = max(abs(float(scipy.special.ndtri(p))), 1.0) * float(np.sqrt(self._noise_m2))
        return float(np.clip(density.correction_m(p), -most, most))

    def _slope(self, p: float, density: SmoothDensity) -> float:
        """The density of measured heights at percentile p, 1/m."""
        return max(density.measured_density(self._percentile_m(p)), self._least_density(p, density))

    def _least_density(self, p: float, density: SmoothDensity) -> float:
        """Half the density that heights within a standard error of p's rank show, 1/m: between two kinds of
        vehicles a smooth one may be next to nothing (Siddiqui 1960).
        """
        half = float(np.sqrt(p * (1.0 - p) / self._n))
        low, high = np.interp([p - half, p + half], self._middle, self._height_m)
        return half / max(float(high - low), 2.5 * half * density.spread_m)

    def _smooth_influences(self, p: float, slope: float) -> list[Floats]:
        """Influences (N,) of each height, metres, on percentile p of smoothed scores, whose density is known:
        by a narrow window and by a wide one.

        Own choice of the widths: the narrow one has `_IN_WINDOW` heights of a site, so that sites do not tie
        and a difference between two kinds of vehicles is not smoothed away; the wide one sees sites whose
        heights lie beside the percentile altogether. What shows more difference counts.
        """
        nodes, node, share = self._smooth_parts
        place = float(scipy.special.ndtri(p))
        per_score = self._n / np.count_nonzero(np.bincount(self._site)) * _normal_density(place)
        found = []
        for width in {_WIDEST, min(_WIDEST, _IN_WINDOW / per_score)}:
            below = scipy.special.ndtr((place - nodes) / width)
            wide = float(np.hypot(1.0, width))
            away = (float(np.sum(share * below)) - below) * wide / _normal_density(place / wide)
            found.append(np.asarray((away * _height_per_score(p, slope))[node], dtype=np.float64))
        return found

    def _near(self, p: float) -> Ints:
        """Rows whose ranks lie about p."""
        half = max(_WINDOW, _LEAST_IN_WINDOW / self._n)
        first, last = np.searchsorted(self._middle, [p - half - 1e-12, p + half + 1e-12])
        return np.arange(first, last)


def _outwards(percents: Sequence[float], rows: Floats) -> Floats:
    """Rows (K, ...) of ascending percents put in order from the median outwards: none turns back."""
    middle = int(np.argmin(np.abs(np.asarray(percents) - 50.0)))
    above, below = rows[middle:], rows[: middle + 1][::-1]
    upper, lower = np.maximum.accumulate(above, axis=0), np.minimum.accumulate(below, axis=0)
    return np.concatenate([lower[:0:-1], upper])


def _one_stratum(sample: HeightSample) -> Design:
    """A survey as a design: one stratum of many sites, of which the sample's are some, all heights alike."""
    n = len(sample.height_m)
    nowhere, sites = np.zeros(n, dtype=np.int64), sites_of(sample.site)
    return Design(np.ones(n), nowhere, nowhere if sites is None else sites.code, np.array([np.inf]))


def _height_per_score(p: float, slope: float) -> float:
    """Metres of a normal score at percentile p, where the density of heights is `slope`, 1/m."""
    return _normal_density(float(scipy.special.ndtri(p))) / slope


def _normal_density(score: float) -> float:
    return float(np.exp(-0.5 * score**2) / np.sqrt(2.0 * np.pi))


def _nodes(score: Floats) -> tuple[Floats, Ints]:
    """Scores (M,) at which smooth functions of sorted scores (N,) are computed, and which each has, (N,):
    their own of few, of many those of fine steps over their range.
    """
    if len(score) <= _NODES:
        return score, np.arange(len(score))
    step = (score[-1] - score[0]) / _NODES
    node = np.minimum(((score - score[0]) / max(step, 1e-12)).astype(np.int64), _NODES - 1)
    return score[0] + (np.arange(_NODES) + 0.5) * step, node


@dataclass(frozen=True)
class TotalFigures:
    """The figures of one sample with their total uncertainty; shares: in the order of their limits.

    words: what the intervals hold, and for which roads, as the end of a sentence.
    """

    n: int
    sites: int | None
    holds: tuple[IntervalPart, ...]
    words: Said
    mean: TotalFigure
    sd: TotalFigure
    percentiles: list[TotalPercentile]
    shares: list[TotalFigure]


def total_figures(
    sample: HeightSample, percents: Sequence[float], limits_m: Sequence[float] = ()
) -> TotalFigures | None:
    """Mean, standard deviation, percentiles and shares of a sample with their total uncertainty.

    Values are those of the true heights: random error is taken out of the spread. Intervals hold sampling,
    differences between sites, shared and random error. Own derivation: `TotalUncertainty` has it.

    Parameters
    ----------
    sample : HeightSample
        N heights, metres.
    percents : sequence of float
        Which percentiles, 0 to 100.
    limits_m : sequence of float
        For each of them, the share of heights below it; one that lies on it is not.

    Returns
    -------
    TotalFigures or None
        `value`, `U95_low`, `U95_high` of each figure, or its reason; None of an empty sample.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> height_m = np.random.default_rng(1).normal(1.45, 0.08, 60)
    >>> parts_m = np.full(60, 0.01), np.full(60, 0.006), np.full(60, 0.005)
    >>> one, site = np.zeros(60, np.int64), np.repeat([0, 1, 2], 20)
    >>> sample = sightline.sample_of_measurements(height_m, *parts_m, pose=one, inset=one, site=site)
    >>> mean = sightline.total_figures(sample, [10.0, 50.0]).mean
    >>> round(mean.value, 2), mean.U95_low < 1.45 < mean.U95_high
    (1.45, True)
    """
    if not len(sample.height_m):
        return None
    total = TotalUncertainty(sample)
    return TotalFigures(
        n=total.n,
        sites=total.sites,
        holds=total.holds,
        words=total.holds_in_words,
        mean=total.mean(),
        sd=total.sd(),
        percentiles=[total.percentile(percent) for percent in percents],
        shares=_rising(limits_m, [total.share_below(limit) for limit in limits_m]),
    )


def _rising(limits_m: Sequence[float], shares: Sequence[TotalFigure]) -> list[TotalFigure]:
    """Shares below limits, those of higher ones no smaller: values and ends put in order (monotone
    rearrangement), for of few heights a step and the error taken out of it may fall together.
    """
    out = list(shares)
    known = sorted((limit, n) for n, limit in enumerate(limits_m) if shares[n].U95_low is not None)
    names = ("value", "U95_low", "U95_high")
    parts = [sorted(getattr(shares[n], name) for _limit, n in known) for name in names]
    for (_limit, n), *in_order in zip(known, *parts, strict=True):
        out[n] = replace(out[n], **dict(zip(names, in_order, strict=True)))
    return out


def difference(total: TotalUncertainty, other: TotalUncertainty, percent: float) -> TotalFigure | Said:
    """A percentile of `other` less that of `total`, metres, with its interval, or the reason why not.

    The two are taken to share no error.
    """
    first, second = total.percentile_draws(percent), other.percentile_draws(percent)
    if isinstance(first, Said):
        return first
    if isinstance(second, Said):
        return second
    value = second[0] - first[0]
    low, high = ends_of(second[1] - first[1][OTHER])
    return TotalFigure(value, value + low, value + high)
