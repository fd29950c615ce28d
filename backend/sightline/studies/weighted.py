"""Heights as a designed sample: each stands for others by its site and by its class in the fleet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Ints
from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.results.measured_columns_query import CATEGORIES, LIGHTING, Heights
from sightline.results.survey_statistics import height_sample
from sightline.statistics.drawn import lonely_strata, reorder_design
from sightline.statistics.sites import compact
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import Margin, calibrate_weights
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
from sightline.studies.places import Places, design_of
from sightline.studies.records import Fleet

LEAST = 2  # heights for a figure


@dataclass(frozen=True, eq=False)
class Weighted:
    """Heights (N,) of one target that count, with their design; or `reason`: why they have none."""

    rows: Heights
    design: Design | None
    reason: Said | None = None

    @property
    def n(self) -> int:
        """How many heights."""
        return len(self.rows)

    def figures(self) -> TotalUncertainty:
        """Ready for figures; only where there is a design."""
        assert self.design is not None
        return TotalUncertainty(sample_of(self.rows), self.design)

    def domain(self, chosen: NDArray[np.bool_]) -> Weighted:
        """The chosen heights (N,) with the weights that they have among all: of classes, not of a fleet."""
        if self.design is None:
            return self
        rows = self.rows.where(chosen)
        design = reorder_design(self.design, np.flatnonzero(chosen))
        if len(rows) < LEAST:
            return Weighted(rows, None, _too_few())
        design = replace(design, site=compact(design.site))
        if lonely_strata(design) and not lonely_strata(self.design):
            return Weighted(rows, None, Said("study-class-at-one-site"))
        return Weighted(rows, design)


def weight_heights(rows: Heights, places: Places, fleet: Fleet | None) -> Weighted:
    """The heights of one target, weighted to the fleet where there is one: those of a class that it has."""
    rows = rows.where(_in_fleet(rows, fleet, places))
    if len(rows) < LEAST:
        return Weighted(rows, None, _too_few())
    design = design_of(rows.survey_id, places)
    alone = lonely_strata(design)
    if len(places.names) > 1 and alone:
        return Weighted(rows, None, Said("study-one-site-of-stratum", stratum=places.strata[alone[0]]))
    if fleet is None:
        return Weighted(rows, design)
    found = _to_fleet(design, rows, places, fleet)
    return Weighted(rows, None, found) if isinstance(found, Said) else Weighted(rows, found)


def _too_few() -> Said:
    return Said("study-heights-needed", least=LEAST)


def refuse_fleet(fleet: Fleet | None, cars: tuple[Ints, Ints, Ints], places: Places) -> None:
    """Every class of the fleet was seen, and every class seen is in the fleet."""
    for variable, shares in (fleet.margins if fleet else {}).items():
        words, code = _coded(variable, cars[0], cars[1], cars[2], places)
        classes_seen = {words[n] for n in np.unique(code[code >= 0]).tolist()}
        for name, share in shares.items():
            if name not in words and variable in ("category", "lighting"):
                raise BadInput("studies-class-unknown", variable=variable, name=name, known=", ".join(words))
            if share > 0.0 and name not in classes_seen:
                raise BadInput("studies-class-never-seen", variable=variable, name=name)
        for name in sorted(classes_seen - set(shares)):
            count = int(np.count_nonzero(code == words.index(name)))
            raise BadInput("studies-fleet-lacks-class", variable=variable, name=name, count=count)


def _coded(
    variable: str, package: Ints, category: Ints, lighting: Ints, places: Places
) -> tuple[Sequence[str], Ints]:
    """Words of what divides the fleet, and the code of each row (N,), -1 for none."""
    site = places.of_survey[package]
    return {
        "category": (CATEGORIES, category),
        "lighting": (LIGHTING, lighting),
        "site": (places.names, site),
        "stratum": (places.strata, places.stratum[site]),
    }[variable]


def _to_fleet(design: Design, rows: Heights, places: Places, fleet: Fleet) -> Design | Said:
    """The design with weights that meet the fleet, or the reason why there are none."""
    margins = []
    for variable, shares in fleet.margins.items():
        words, code = _coded(variable, rows.survey_id, rows.category, rows.lighting, places)
        there = np.bincount(code, minlength=len(words))
        share = np.array([shares.get(word, 0.0) for word in words])
        for n in np.flatnonzero((share > 0.0) & (there == 0)).tolist():
            return Said("study-class-not-counted", variable=variable, name=words[n])
        margins.append(Margin(code, share))
    weight = calibrate_weights(design.weight, margins)
    if weight is None:
        return Said("study-no-weights")
    return Design(
        weight, design.stratum, design.site, design.sites_there, margins=tuple(margins), drawn=design.weight
    )


def _in_fleet(rows: Heights, fleet: Fleet | None, places: Places) -> NDArray[np.bool_]:
    """Whether each row (N,) is of a known class that the fleet has."""
    keep = np.ones(len(rows), dtype=np.bool_)
    for variable, shares in (fleet.margins if fleet else {}).items():
        words, code = _coded(variable, rows.survey_id, rows.category, rows.lighting, places)
        keep &= np.array([*(shares.get(word, 0.0) > 0.0 for word in words), False])[code]  # -1: not known
    return keep


def sample_of(rows: Heights) -> HeightSample:
    """As the statistics of a survey take them; poses of one package are no other package's."""
    return height_sample(rows, named_poses=(rows.survey_id << 32) + rows.pose_id)
