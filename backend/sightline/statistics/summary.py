"""What a statistics page, a report and a package show, computed in one place from columns of measurements."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints
from sightline.enums import Correction, Lighting, Rounding
from sightline.messages.said import Said
from sightline.statistics.agreement import (
    BlandAltman,
    ReferencePart,
    Trend,
    bland_altman,
    reference_part,
    trend,
)
from sightline.statistics.corrections import Corrected, Known, correct_heights
from sightline.statistics.distributions import (
    PERCENTILES,
    Density,
    Ecdf,
    Percentile,
    Share,
    density,
    ecdf,
    percentiles,
    share_below,
    sorted_values,
)
from sightline.statistics.errors import WHOLE_CM, ErrorGroup, error_table, signed_errors
from sightline.statistics.total_uncertainty import HeightSample, TotalFigures, total_figures

MOST_POINTS = 1500
MOST_GROUPS = 24
_POINTS_OF_GROUPS = 200
_SEED = 20190403


@dataclass(frozen=True, eq=False)
class Roofs:
    """Roofs of vehicles with a reference height, (N,) each, metres; `lighting` "" where unknown; `parts`: the
    same heights with the parts of their uncertainty and their sites.
    """

    measured_m: Floats
    paper_m: Floats
    reference_m: Floats
    u_reference_m: Floats
    lighting: NDArray[np.str_]
    parts: HeightSample | None = None

    def known(self) -> Known:
        """What the paper's corrections start from: heights with inset 0 and the errors they have."""
        return Known(self.paper_m, self.paper_m - self.reference_m)


@dataclass(frozen=True, eq=False)
class Errors:
    """Errors against reference heights; a part that cannot be computed is its reason.

    `points`: (reference height, signed error, index of the lighting in daytime, low_light, none), thinned to
    MOST_POINTS at random but always alike.
    """

    rounding: Rounding
    groups: dict[str, ErrorGroup]
    reference_part: ReferencePart | Said
    bland_altman: BlandAltman | Said
    trend: Trend | Said
    absolute_trend: Trend | Said
    absolute: dict[str, Ecdf | None]
    relative: dict[str, Ecdf | None]
    density: dict[str, Density | Said]
    points: Floats


@dataclass(frozen=True, eq=False)
class Distribution:
    """The heights of one target in one group of vehicles; without any, all parts are empty."""

    n: int
    mean_m: float | None
    sd_m: float | None
    ecdf: Ecdf | None
    percentiles: list[Percentile]
    shares: list[Share]


@dataclass(frozen=True, eq=False)
class Grouping:
    """A way to divide measurements: `code` (N,) says which of the `words` each belongs to, -1 for none."""

    code: Ints
    words: Sequence[str]

    def where(self, chosen: NDArray[np.bool_]) -> "Grouping":
        """The rows that are chosen (N,)."""
        return Grouping(self.code[chosen], self.words)


@dataclass(frozen=True, eq=False)
class Groups:
    """Distributions by word, in the order of the words; of many only the MOST_GROUPS largest."""

    of: dict[str, Distribution]
    left_out: int


@dataclass(frozen=True, eq=False)
class Target:
    """A target's heights as the paper measures them and corrected, and the corrected ones by group.

    total: figures of the true heights with their total uncertainty, where each height is corrected by its
    inset.
    """

    raw: Distribution
    corrected: Distribution
    correction: Corrected | Said
    density: Density | Said
    groups: dict[str, Groups]
    total: TotalFigures | None = None


def errors_of(roofs: Roofs, correction: Correction, rounding: Rounding) -> Errors:
    """The error table and figures of roofs against their reference heights.

    "inset" takes the heights corrected by each measurement's inset, every other correction the paper's.
    """
    measured = roofs.measured_m if correction == "inset" else roofs.paper_m
    error, reference = signed_errors(measured, roofs.reference_m, rounding)
    where = {name: roofs.lighting == name for name in get_args(Lighting)}
    where["overall"] = np.ones(len(error), dtype=np.bool_)
    absolute = np.abs(error)
    step_m = WHOLE_CM if rounding == "cm" else 0.0
    groups = error_table(measured, roofs.reference_m, list(roofs.lighting), rounding, roofs.parts)
    return Errors(
        rounding=rounding,
        groups=groups,
        reference_part=reference_part(error, reference, roofs.u_reference_m, rounded=rounding == "cm"),
        bland_altman=bland_altman(error, *groups["overall"].total_ends()),
        trend=trend(reference, error),
        absolute_trend=trend(reference, absolute),
        absolute={name: ecdf(sorted_values(absolute[rows])) for name, rows in where.items()},
        relative={
            name: ecdf(sorted_values(absolute[rows] / reference[rows])) for name, rows in where.items()
        },
        density={name: density(sorted_values(error[rows]), step=step_m) for name, rows in where.items()},
        points=_points(reference, error, roofs.lighting),
    )


def target_of(
    inset_m: Floats,
    paper_m: Floats,
    roofs: Roofs,
    correction: Correction,
    limits_m: Sequence[float],
    groupings: Mapping[str, Grouping],
    sample: HeightSample | None = None,
) -> Target:
    """One target: heights `inset_m` (N,) corrected by inset, and `paper_m` (N,), the paper's (NaN where it
    has none), metres; limits_m: heights whose share below is wanted; sample: the heights with the parts of
    their uncertainty.

    Raw and corrected distribution as in Dupuis et al. 2019, sections 3.5 and 3.6; the correction is
    that of `correct_heights`.
    """
    raw = distribution(paper_m, limits_m)
    if correction != "inset":
        measured = np.isfinite(paper_m)
        inset_m, paper_m = inset_m[measured], paper_m[measured]
        groupings = {name: one.where(measured) for name, one in groupings.items()}
    known = roofs.known()
    part = reference_part(known.error_m, roofs.reference_m, roofs.u_reference_m)
    camera_sd_m = None if isinstance(part, Said) else part.camera_sd_m
    done = correct_heights(correction, inset_m, paper_m, known, camera_sd_m)
    if isinstance(done, Said):
        return Target(raw, distribution(np.empty(0)), done, done, {})
    heights = done.height_m
    by = {name: groups_of(heights, one, limits_m) for name, one in groupings.items()}
    inset = correction == "inset" and sample is not None
    return Target(
        raw=raw,
        corrected=distribution(heights, limits_m),
        correction=done,
        density=density(sorted_values(heights)),
        groups=by,
        total=total_figures(sample, PERCENTILES, limits_m) if inset and sample is not None else None,
    )


def groups_of(heights_m: Floats, grouping: Grouping, limits_m: Sequence[float] = ()) -> Groups:
    """The distribution of heights_m (N,), metres, in each group, as Dupuis et al. 2019, section 3.5, by
    `distribution`; the smallest of many groups are left out.
    """
    counts = np.bincount(grouping.code + 1, minlength=len(grouping.words) + 1)[1:]
    largest = np.argsort(-counts, kind="stable")[:MOST_GROUPS]
    present = [int(code) for code in sorted(largest) if counts[code]]
    of = {
        grouping.words[code]: distribution(
            heights_m[grouping.code == code], limits_m, most_steps=_POINTS_OF_GROUPS
        )
        for code in present
    }
    return Groups(of, int(np.count_nonzero(counts)) - len(present))


def distribution(heights_m: Floats, limits_m: Sequence[float] = (), most_steps: int = 600) -> Distribution:
    """Percentiles, cumulative distribution and shares below `limits_m` of heights `heights_m` (N,), metres;
    what is not finite is left out.

    The figures of Dupuis et al. 2019, sections 3.5 and 3.6; each by its function of `distributions`, sd with
    n - 1.
    """
    ordered = sorted_values(heights_m)
    n = len(ordered)
    shares = [found for limit in limits_m if (found := share_below(ordered, limit)) is not None]
    return Distribution(
        n=n,
        mean_m=float(ordered.mean()) if n else None,
        sd_m=float(ordered.std(ddof=1)) if n > 1 else None,
        ecdf=ecdf(ordered, most_steps),
        percentiles=percentiles(ordered),
        shares=shares,
    )


def _points(reference: Floats, error: Floats, lighting: NDArray[np.str_]) -> Floats:
    code = np.select([lighting == "daytime", lighting == "low_light"], [0.0, 1.0], 2.0)
    rows = np.arange(len(error))
    if len(rows) > MOST_POINTS:
        chosen = np.random.default_rng(_SEED).choice(len(rows), MOST_POINTS, replace=False)
        rows = np.sort(chosen)
    return np.column_stack([reference, error, code])[rows]
