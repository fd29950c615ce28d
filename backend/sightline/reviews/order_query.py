"""A survey's standing heights, of frames and of line scans, in the order in which they are reviewed."""

from dataclasses import dataclass
from datetime import datetime
from threading import Lock
from typing import Any

import numpy as np
from cachetools import LRUCache, cached
from sqlalchemy import Row, func
from sqlalchemy.orm import Session

from sightline.enums import ReviewSign, Verdict
from sightline.infra.audit import trail
from sightline.measurements.query import (
    clicked_at,
    is_current,
    is_first,
    is_own,
    operator_id,
    verdict,
    with_verdict,
)
from sightline.measurements.tables import measurement_series
from sightline.measurements.tables import measurements as revision_rows
from sightline.scans.tables import scan_vehicles, scans
from sightline.statistics.agreement import U_MANUFACTURER_M
from sightline.statistics.review_order import SIGNS, review_order
from sightline.vehicles.records import is_reference
from sightline.vehicles.tables import vehicles

#: Measurements whose place is kept, of all surveys and people together: some 300 bytes each.
MOST_KEPT = 400_000


@dataclass(frozen=True, slots=True)
class Standing:
    """A height that stands: its verdict, whose it is, what speaks against it; `scanned`: of a line scan.
    `operator`: the number of who clicked its points, at `clicked_at`; `mine`: the actor may not judge it.
    """

    scanned: bool
    verdict: Verdict
    mine: bool
    operator: int | None
    clicked_at: datetime
    signs: tuple[ReviewSign, ...]
    error_m: float | None
    u_error_m: float | None


def standing_order(session: Session, survey_id: int, actor: int | None) -> dict[int, Standing]:
    """By number of the measurement: others' before the actor's own, frames before line scans, those most
    likely wrong first.

    What is usual takes a look at all of them, so it is kept until anything of the survey changes.
    """
    return _standing_order(session, survey_id, actor, trail.head(session, survey_id).hash)


@cached(LRUCache(MOST_KEPT, len), key=lambda _session, *rest: rest, lock=Lock())
def _standing_order(session: Session, survey_id: int, actor: int | None, _end: str) -> dict[int, Standing]:
    """`_end`: the hash in which the survey's audit chain ends: another one with each change."""
    r, of = revision_rows.c, measurement_series.c
    number = func.coalesce(vehicles.c.number, scan_vehicles.c.number)
    query = (
        with_verdict(
            *(
                r.series_id,
                r.target,
                r.height_m,
                r.u_height_m,
                verdict.label("verdict"),
                is_own(actor).label("mine"),
            ),
            *(operator_id.label("operator"), clicked_at.label("clicked_at"), of.scan_id),
            *(vehicles.c.manufacturer_height_m, vehicles.c.u_manufacturer_height_m),
            vehicles.c.model_chosen_by,
        )
        .outerjoin(vehicles, vehicles.c.id == of.vehicle_id)
        .outerjoin(scan_vehicles, scan_vehicles.c.id == of.scan_vehicle_id)
        .outerjoin(scans, scans.c.id == of.scan_id)
        .where(
            of.survey_id == survey_id,
            *(one.c.deleted_at.is_(None) for one in (vehicles, scan_vehicles, scans)),
        )
        .where(is_current, ~r.withdrawn, is_first)
        .order_by(of.scan_id.is_not(None), of.scan_id, number, r.series_id)
    )
    rows = session.execute(query).all()
    errors = np.array([_error(row) for row in rows], dtype=float).reshape(-1, 2)
    ranked = review_order(
        np.array([row.height_m for row in rows], dtype=float),
        np.array([row.u_height_m for row in rows], dtype=float),
        # what is usual of a target is another uncertainty on frames than in line scans
        np.unique([f"{row.target} {row.scan_id is None}" for row in rows], return_inverse=True)[1],
        np.array([row.operator or 0 for row in rows], dtype=np.int64),
        errors[:, 0],
        errors[:, 1],
    )
    # own ones last, those of frames before those of strips, which are judged by other pictures; then the
    # riskiest first, else as they stand
    of_strips = np.array([row.scan_id is not None for row in rows], dtype=bool)
    mine = np.array([row.mine for row in rows], dtype=bool)
    order = np.lexsort((np.arange(len(rows)), -ranked.risk, of_strips, mine))
    return {
        rows[at].series_id: Standing(
            scanned=rows[at].scan_id is not None,
            verdict="to_review" if rows[at].verdict == "reopened" else rows[at].verdict,
            mine=bool(rows[at].mine),
            operator=rows[at].operator,
            clicked_at=rows[at].clicked_at,
            signs=tuple(sign for sign, there in zip(SIGNS, ranked.signs[at], strict=True) if there),
            error_m=_none_for_nan(errors[at, 0]),
            u_error_m=_none_for_nan(errors[at, 1]),
        )
        for at in order
    }


def _error(row: Row[Any]) -> tuple[float, float]:
    """Of a roof against its maker's height, with its standard uncertainty; NaN for anything else."""
    if row.target != "roof" or row.height_m is None or row.manufacturer_height_m is None:
        return np.nan, np.nan
    if not is_reference(row.model_chosen_by):
        return np.nan, np.nan
    u_reference_m = row.u_manufacturer_height_m
    u_m = float(U_MANUFACTURER_M) if u_reference_m is None else u_reference_m
    return row.height_m - row.manufacturer_height_m, float(np.hypot(row.u_height_m, u_m))


def _none_for_nan(value: float) -> float | None:
    return None if np.isnan(value) else float(value)
