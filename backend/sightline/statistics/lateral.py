"""Where vehicles drive across the road: distances of near sides from the camera, by lane and class."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from sightline.arrays import Floats, Ints
from sightline.statistics.summary import Distribution, Grouping, Groups, distribution, groups_of


@dataclass(frozen=True, eq=False)
class Lateral:
    """Lateral positions, one of each vehicle, metres: of `all`, by lane, and of each lane by class."""

    all: Distribution
    lanes: Groups
    classes: dict[str, Groups] = field(default_factory=dict)


def lateral_positions(
    across_m: Floats,
    vehicle: Ints,
    lane: Ints,
    category: Ints,
    lanes: Sequence[str],
    categories: Sequence[str],
) -> Lateral:
    """The distributions of across_m (N,), the contact's distance from the camera across the road, metres, NaN
    where it is unknown; vehicle (N,): its number; lane, category (N,): codes into the words, -1 for none.

    Never fails. Own method: a vehicle counts once, by the median of its contacts, for they are of the same
    side plane, clicked once for each target. Figures as in `distribution` (Hyndman and Fan 1996).
    """
    known = np.isfinite(across_m)
    across_m, vehicle, lane, category = across_m[known], vehicle[known], lane[known], category[known]
    order = np.lexsort((across_m, vehicle))
    _, first, count = np.unique(vehicle[order], return_index=True, return_counts=True)
    low, high = order[first + (count - 1) // 2], order[first + count // 2]
    middle = 0.5 * (across_m[low] + across_m[high])
    of_lane, of_class = Grouping(lane[low], lanes), Grouping(category[low], categories)
    by_lane = groups_of(middle, of_lane)
    return Lateral(
        all=distribution(middle),
        lanes=by_lane,
        classes={
            word: groups_of(middle[rows], of_class.where(rows))
            for word in by_lane.of
            if (rows := of_lane.code == list(lanes).index(word)).any()
        },
    )
