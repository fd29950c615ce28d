"""A made-up survey's statistics to draw, of any size."""

from __future__ import annotations

import numpy as np

from sightline.results.survey_statistics import (
    SHOWN,
    SampleCounts,
    Statistics,
    StatisticsOptions,
    sight_pair,
    standards_of,
)
from sightline.results.usual_standards import STANDARDS
from sightline.statistics.lateral import Lateral, lateral_positions
from sightline.statistics.rules import rule_today
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.summary import Grouping, Roofs, errors_of, target_of
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

MEAN_SD = {
    "driver_eye": (1.24, 0.075),
    "taillight": (0.85, 0.13),
    "headlight": (0.66, 0.06),
    "roof": (1.52, 0.13),
}


def statistics(
    n: int = 400,
    low_light: float = 0.35,
    choices: StatisticsOptions = StatisticsOptions(),
    absent: tuple[str, ...] = ("headlight",),
    site: Grouping | None = None,
) -> Statistics:
    """`n` vehicles, a share of them in low light; the paper's heights are too high below the camera."""
    rng = np.random.default_rng(7)
    reference = rng.normal(*MEAN_SD["roof"], n)
    measured = reference + rng.normal(0.004, 0.019, n) - 0.05 * (reference - 1.52)
    lighting = np.where(rng.random(n) < low_light, "low_light", "daytime").astype(str)
    paper = measured + (1.5 - measured) * 0.09
    roofs = Roofs(measured, paper, reference, np.full(n, 0.0173), lighting)
    standards = (*STANDARDS, *choices.own_standards)
    categories = ("hatchback", "saloon", "estate", "suv", "van", "lorry", "other")
    targets = {}
    samples = {}
    for name in SHOWN:
        size = 0 if name in absent else n
        height = rng.normal(*MEAN_SD[name], size)
        groupings = {
            "lighting": Grouping((lighting[:size] == "low_light").astype(np.int64), ("daytime", "low_light")),
            "category": Grouping(rng.integers(0, len(categories), size), categories),
        }
        if site is not None and size:
            groupings["site"] = site
        limits = [one.height_m for one in standards_of(standards, name)]
        raw = height + (1.5 - height) * 0.13
        one_pose = SharedErrors(np.zeros(size, np.int64), np.full(size, 0.007))
        sample = HeightSample(height, np.full(size, 0.012), (one_pose,))
        targets[name] = target_of(height, raw, roofs, choices.correction, limits, groupings, sample)
        samples[name] = sample
    figures = {name: TotalUncertainty(one) if len(one.height_m) else None for name, one in samples.items()}
    rules = [rule_today(one, figures["driver_eye"], True) for one in standards_of(standards, "driver_eye")]
    pair = sight_pair(standards)
    assert pair is not None
    eye, thing = (
        rule_today(one, figures[name], True)
        for one, name in zip(pair, ("driver_eye", "taillight"), strict=True)
    )
    assert eye is not None and thing is not None
    errors = errors_of(roofs, choices.correction, choices.rounding)
    counted = SampleCounts(3 * n, n, n, 0, {"rejected": 7, "to_review": 21} if n else {}, 0, 0)
    return Statistics(
        counted=counted,
        standards=standards,
        errors=errors,
        targets=targets,
        surveys={1: "A survey"},
        operators={1: "An operator"},
        rules=tuple(one for one in rules if one is not None),
        sight=(eye, thing),
        lateral=_lateral(n),
    )


def _lateral(n: int) -> Lateral:
    """Two lanes, 3.2 and 6.4 m from the camera, of two classes each."""
    rng = np.random.default_rng(11)
    lane, category = rng.integers(0, 2, n), rng.integers(0, 2, n)
    across = 3.2 * (1 + lane) + 0.2 * rng.standard_normal(n)
    return lateral_positions(across, np.arange(n), lane, category, ("right", "left"), ("hatchback", "van"))
