"""Reviews: a verdict on a height; a fix, on frames alone, measures again with the reviewer's points."""

from datetime import datetime
from typing import get_args

from sightline.enums import AcceptedVerdict, Point, ReviewVerdict, Verdict
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.measurements.records import Measurement, MeasurementValues, ScanHeight
from sightline.measurements.service import clicked_again, values_of_vehicle
from sightline.reviews.store import add_review, require_clicked_again, require_revision


def require_seen_by_plan(
    session: Session, series_id: int, revision: int, verdict: ReviewVerdict, actor: int
) -> None:
    """A person accepts or fixes what the survey's plan draws once they have clicked it themselves; it draws
    from heights on frames alone (`plan_store`).

    Raises BadInput where they have not, NotAllowed for one's own work, Conflict for another revision.
    """
    if verdict in get_args(AcceptedVerdict):
        one = require_revision(session, series_id, revision)
        if isinstance(one, Measurement):
            require_clicked_again(session, one, actor)


def review(
    session: Session,
    series_id: int,
    *,
    revision: int,
    verdict: ReviewVerdict,
    reason: str | None,
    seen: Verdict | None = None,
    seen_at: datetime | None = None,
    frame: int | None,
    contact: Point | None,
    target_point: Point | None,
    actor: int,
) -> Measurement | ScanHeight:
    """Give a verdict on the revision, and in place of the verdict, that was seen.

    A fix keeps target, sigma and inset of that revision and takes the reviewer's points. Raises NotAllowed
    for one's own work, Conflict for a revision that is not current, BadInput for a rejection without a
    reason, a fix without points or that changes nothing, and a fix in a line scan.
    """
    fixed = None
    if verdict == "fixed":
        before = require_revision(session, series_id, revision)
        if isinstance(before, ScanHeight):
            raise BadInput("reviews-fix-line-scan")
        fixed = _fixed(session, before, frame, contact, target_point, actor)
    elif contact is not None or target_point is not None or frame is not None:
        raise BadInput("reviews-points-without-fix")
    return add_review(
        session,
        series_id,
        seen_revision=revision,
        verdict=verdict,
        reason=reason,
        seen=seen,
        seen_at=seen_at,
        fixed=fixed,
        actor=actor,
    )


def _fixed(
    session: Session,
    before: Measurement,
    frame: int | None,
    contact: Point | None,
    target_point: Point | None,
    actor: int,
) -> MeasurementValues:
    if contact is None or target_point is None:
        raise BadInput("reviews-fix-one-point")
    n = before.values.frame if frame is None else frame
    clicks = clicked_again(before.values, n, contact, target_point)
    values = values_of_vehicle(session, before.vehicle_id, clicks, actor=actor)
    if _made_with(values) == _made_with(before.values):
        raise BadInput("reviews-fix-unchanged")
    return values


def _made_with(values: MeasurementValues) -> tuple[object, ...]:
    """What a height follows from: clicks, inset, pose and lens."""
    inset = (values.inset_m, values.u_inset_m)
    return (
        *values.first_clicks,
        values.more_frames,
        values.followed,
        *inset,
        values.pose_id,
        values.calibration_id,
    )
