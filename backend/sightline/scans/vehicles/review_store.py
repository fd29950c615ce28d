"""Verdicts on scanned vehicles' measurements: append-only. Nobody reviews boundaries of their own."""

from datetime import datetime

from sqlalchemy.orm import Session

from sightline.enums import ScanVerdict, Verdict
from sightline.errors import Conflict, NotAllowed
from sightline.infra.audit.written import written_once
from sightline.measurements.verdicts import require_verdict
from sightline.scans.query import reviews_where
from sightline.scans.records import ScanMeasurement, ScanReview
from sightline.scans.tables import scan_measurements, scan_reviews
from sightline.scans.vehicles.measurement_store import get_scan_measurement, is_newest_scan_measurement
from sightline.scans.vehicles.store import require_scan_vehicle_version


def add_scan_review(
    session: Session,
    measurement_id: int,
    *,
    verdict: ScanVerdict,
    reason: str | None = None,
    seen: Verdict | None = None,
    seen_at: datetime | None = None,
    actor: int,
) -> ScanMeasurement:
    """Give a verdict on the revision, and in place of the verdict, that was seen.

    Raises Conflict if there is a newer revision or another verdict than `seen` of `seen_at`, NotAllowed for
    boundaries of one's own, BadInput for a rejection without a reason.
    """
    before = get_scan_measurement(session, measurement_id)
    require_scan_vehicle_version(session, before.vehicle_id, None)
    if not is_newest_scan_measurement(session, before):
        raise Conflict("scans-vehicle-measured-meanwhile")
    if before.values.placed_by == actor:
        raise NotAllowed("scans-own-boundaries")
    given_reason = require_verdict(before.review, seen, seen_at, verdict, reason)
    content = {"survey_id": before.survey_id, "measurement_id": measurement_id, "verdict": verdict}
    written_once(
        session,
        scan_reviews,
        {**content, "reason": given_reason},
        "review",
        before={"verdict": before.review.verdict},
        also={"vehicle_id": before.vehicle_id, "revision": before.revision},
        actor=actor,
    )
    return get_scan_measurement(session, measurement_id)


def scan_reviews_of_vehicle(session: Session, vehicle_id: int) -> tuple[ScanReview, ...]:
    """Every verdict on a vehicle's revisions, oldest first."""
    return reviews_where(session, scan_measurements.c.vehicle_id == vehicle_id)


def list_scan_reviews(session: Session, survey_id: int) -> tuple[ScanReview, ...]:
    """Every verdict of a survey, oldest first, for the export."""
    return reviews_where(session, scan_reviews.c.survey_id == survey_id)
