"""A drawn survey, adjusted: bridges between the independent simulation and the code under test."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from sightline.adjustment.adjust import Adjustment, adjust
from sightline.adjustment.observed import POINTS, Known, ObservedPass
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.height import Height, measure_height
from sightline.geometry.road_pose import RoadPose
from tests.adjustment.survey import (
    BoardBudget,
    Fleet,
    Truth,
    eye_clicks,
    passes,
    prior_covariance,
    told_pose,
    truth_at,
)

EYE_M, INSET_M = 1.15, 0.45


@cache
def site(budget: BoardBudget) -> tuple[Truth, np.ndarray, np.ndarray]:
    truth = truth_at()
    return truth, prior_covariance(truth, budget), eye_clicks(truth, height=EYE_M, inset=INSET_M)


@dataclass(frozen=True)
class Case:
    before: Height
    after: Height
    adjustment: Adjustment
    wrong: list[str]


def draw(
    fleet: Fleet, seed: int, budget: BoardBudget | None = None, lean: float | None = None
) -> tuple[RoadPose, list[ObservedPass], list[str]]:
    truth, covariance, _ = site(budget or BoardBudget())
    rng = np.random.default_rng(seed)
    pose = pose_from_dict(told_pose(truth, budget or BoardBudget(), covariance, rng, lean))
    rows, wrong = passes(truth, fleet, rng)
    return pose, observed(rows), wrong


def case(fleet: Fleet, seed: int, budget: BoardBudget | None = None, lean: float | None = None) -> Case:
    """One survey; heights are of the eye at 6.4 m, clicked without error."""
    pose, traffic, wrong = draw(fleet, seed, budget, lean)
    adjustment = adjust(pose, traffic, fleet.u_common, fleet.u_common)
    return Case(eye(pose, budget), eye(adjustment.pose, budget), adjustment, wrong)


def eye(pose: RoadPose, budget: BoardBudget | None = None) -> Height:
    clicks = site(budget or BoardBudget())[2]
    return measure_height(pose, clicks[0], clicks[1], 0.0, INSET_M)


def observed(rows: Sequence[dict[str, Any]]) -> list[ObservedPass]:
    by_name: dict[str, list[dict[str, Any]]] = {}
    for row in rows:
        by_name.setdefault(row["pass"], []).append(row)
    return [
        ObservedPass(
            name,
            np.array([row["frame"] for row in its]),
            np.array([POINTS.index(row["point"]) for row in its]),
            np.array([[row["x_px"], row["y_px"]] for row in its]),
            np.array([row["sigma_px"] for row in its]),
            *(_known(its[0], length) for length in ("wheelbase", "roof", "roof_inset")),
        )
        for name, its in by_name.items()
    ]


def _known(row: dict[str, Any], name: str) -> Known | None:
    return Known(row[f"{name}_m"], row[f"u_{name}_m"]) if f"{name}_m" in row else None
