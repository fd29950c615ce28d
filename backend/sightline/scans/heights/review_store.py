"""Verdicts on heights of scanned vehicles: append-only. Nobody reviews clicks of their own."""

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.enums import ScanVerdict, Verdict
from sightline.errors import Conflict, NotAllowed
from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, stored_hash, who
from sightline.infra.database.types import now
from sightline.reviews.store import require_verdict
from sightline.scans.heights.records import LineHeightReview, StoredLineHeight
from sightline.scans.heights.store import get_line_height, heights_of_own_clicks, is_newest_line_height
from sightline.scans.heights.tables import line_height_reviews, line_heights
from sightline.scans.vehicles.store import require_scan_vehicle_version


def add_line_height_review(
    session: Session,
    height_id: int,
    *,
    verdict: ScanVerdict,
    reason: str | None = None,
    seen: Verdict | None = None,
    actor: int,
) -> StoredLineHeight:
    """Give a verdict on the revision, and in place of the verdict, that was seen.

    Raises Conflict if there is a newer revision, a withdrawn height or none, or another verdict than `seen`;
    NotAllowed for clicks of one's own, BadInput for a rejection without a reason.
    """
    before = get_line_height(session, height_id)
    require_scan_vehicle_version(session, before.vehicle_id, None)
    if not is_newest_line_height(session, before):
        raise Conflict("scans-height-measured-again-meanwhile-look-newer")
    if before.values.withdrawn or before.values.status != "ok":
        raise Conflict("scans-height-without-figure-nothing-review")
    if height_id in heights_of_own_clicks(session, before.scan_id, actor):
        raise NotAllowed("scans-nobody-reviews-height-they-clicked-themselves")
    told = require_verdict(before.review, seen, verdict, reason)
    content = {"survey_id": before.survey_id, "height_id": height_id, "verdict": verdict, "reason": told}
    row_id = add_row(session, line_height_reviews, {**content, "created_at": now(), "created_by": actor})
    after = {
        **content,
        "vehicle_id": before.vehicle_id,
        "target": before.values.target,
        "revision": before.revision,
        "content_sha256": stored_hash(session, line_height_reviews, row_id),
    }
    then = {"verdict": before.review.verdict}
    trail.record(session, actor, "review", "line_height_review", row_id, before.survey_id, then, after)
    return get_line_height(session, height_id)


def reviews_of_scan_heights(session: Session, scan_id: int) -> tuple[LineHeightReview, ...]:
    """Every verdict on the heights of a scan, oldest first, for the export."""
    query = (
        select(line_height_reviews, line_heights.c.vehicle_id, people.c.name.label("reviewer_name"))
        .join(line_heights, line_heights.c.id == line_height_reviews.c.height_id)
        .outerjoin(people, people.c.id == line_height_reviews.c.created_by)
        .where(line_heights.c.scan_id == scan_id)
        .order_by(line_height_reviews.c.id)
    )
    return tuple(
        LineHeightReview(
            id=row.id,
            height_id=row.height_id,
            vehicle_id=row.vehicle_id,
            verdict=row.verdict,
            reason=row.reason,
            reviewer=who(row.created_by, row.reviewer_name),
            at=row.created_at,
        )
        for row in session.execute(query)
    )
