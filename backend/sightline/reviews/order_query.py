"""A survey's standing measurements in the order in which they are reviewed."""

from dataclasses import dataclass
from threading import Lock
from typing import Any

import numpy as np
from cachetools import LRUCache, cached
from sqlalchemy import Row, and_
from sqlalchemy.orm import Session

from sightline.enums import ReviewSign, Verdict
from sightline.infra.audit import trail
from sightline.measurements.query import is_current, is_first, is_own, verdict, with_verdict
from sightline.measurements.tables import measurement_series
from sightline.measurements.tables import measurements as revision_rows
from sightline.statistics.agreement import U_MANUFACTURER_M
from sightline.statistics.review_order import SIGNS, review_order
from sightline.vehicles.records import is_reference
from sightline.vehicles.tables import vehicles

#: Measurements whose place is kept, of all surveys and people together: some 300 bytes each.
MOST_KEPT = 400_000


@dataclass(frozen=True, slots=True)
class Standing:
    """A measurement that stands: its verdict, whose it is, and what speaks against it."""

    verdict: Verdict
    mine: bool
    signs: tuple[ReviewSign, ...]
    error_m: float | None
    u_error_m: float | None


def standing_order(session: Session, survey_id: int, actor: int | None) -> dict[int, Standing]:
    """By number of the measurement: others' before the actor's own, those most likely wrong first.

    What is usual takes a look at all of them, so it is kept until anything of the survey changes.
    """
    return _standing_order(session, survey_id, actor, trail.head(session, survey_id).hash)


def _size(order: dict[int, Standing]) -> int:
    return len(order)


@cached(LRUCache(MOST_KEPT, _size), key=lambda _session, *rest: rest, lock=Lock())
def _standing_order(session: Session, survey_id: int, actor: int | None, _end: str) -> dict[int, Standing]:
    """`_end`: the hash in which the survey's audit chain ends: another one with each change."""
    r = revision_rows.c
    maker = revision_rows.alias("maker")
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
            *(maker.c.created_by.label("operator"), vehicles.c.number),
            *(vehicles.c.manufacturer_height_m, vehicles.c.u_manufacturer_height_m),
            vehicles.c.model_chosen_by,
        )
        .join(vehicles, vehicles.c.id == measurement_series.c.vehicle_id)
        .join(maker, and_(maker.c.series_id == r.series_id, maker.c.revision == 1))
        .where(measurement_series.c.survey_id == survey_id, vehicles.c.deleted_at.is_(None))
        .where(is_current, ~r.withdrawn, is_first)
        .order_by(vehicles.c.number, r.series_id)
    )
    rows = session.execute(query).all()
    errors = np.array([_error(row) for row in rows], dtype=float).reshape(-1, 2)
    found = review_order(
        np.array([row.height_m for row in rows], dtype=float),
        np.array([row.u_height_m for row in rows], dtype=float),
        np.unique([row.target for row in rows], return_inverse=True)[1],
        np.array([row.operator or 0 for row in rows], dtype=np.int64),
        errors[:, 0],
        errors[:, 1],
    )
    # own ones last, the riskiest first, else as they stand
    order = np.lexsort((np.arange(len(rows)), -found.risk, np.array([row.mine for row in rows], dtype=bool)))
    return {
        rows[at].series_id: Standing(
            verdict="to_review" if rows[at].verdict == "reopened" else rows[at].verdict,
            mine=bool(rows[at].mine),
            signs=tuple(sign for sign, there in zip(SIGNS, found.signs[at], strict=True) if there),
            error_m=_known(errors[at, 0]),
            u_error_m=_known(errors[at, 1]),
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


def _known(value: float) -> float | None:
    return None if np.isnan(value) else float(value)
