"""Reviews: a verdict on a measurement; a fix measures again with the reviewer's points."""

from __future__ import annotations

from sqlalchemy.orm import Session

from sightline.enums import ReviewVerdict
from sightline.errors import BadInput
from sightline.measurements.click_context_query import click_context
from sightline.measurements.records import Measurement, MeasurementValues
from sightline.measurements.service import Point, as_clicked, clicked_frames, values_of_clicks
from sightline.measurements.store import require_measurement_revision
from sightline.reviews.store import add_review


def review(
    session: Session,
    series_id: int,
    *,
    revision: int,
    verdict: ReviewVerdict,
    reason: str | None,
    frame: int | None,
    contact: Point | None,
    point: Point | None,
    actor: int,
) -> Measurement:
    """Give a verdict on the revision that was seen.

    A fix keeps target, sigma and inset of that revision and takes the reviewer's points. Raises NotAllowed
    for one's own work, Conflict for a revision that is not current, BadInput for a rejection without a reason
    or a fix without points.
    """
    before = require_measurement_revision(session, series_id, revision)
    fixed = None
    if verdict == "fixed":
        fixed = _fixed(session, before, frame, contact, point, actor)
    elif contact is not None or point is not None or frame is not None:
        raise BadInput("Only a fix carries points; leave them out or choose the verdict fixed.")
    return add_review(
        session,
        series_id,
        seen_revision=revision,
        verdict=verdict,
        reason=reason,
        fixed=fixed,
        actor=actor,
    )


def _fixed(
    session: Session,
    before: Measurement,
    frame: int | None,
    contact: Point | None,
    point: Point | None,
    actor: int,
) -> MeasurementValues:
    if contact is None or point is None:
        raise BadInput("A fix needs both points, contact and target; click them and send them along.")
    n = before.values.frame if frame is None else frame
    clicked = as_clicked(before, n, contact, point)
    context = click_context(session, before.recording_id, actor, clicked_frames(n, clicked))
    return values_of_clicks(session, context, n, clicked)
