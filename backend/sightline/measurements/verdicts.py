"""What a verdict must be, on a height or on the motion of a scanned vehicle."""

from datetime import datetime

from sightline.enums import ReviewVerdict, Verdict
from sightline.errors import BadInput, Conflict
from sightline.infra.audit.records import name_or_somebody
from sightline.measurements.records import ReviewState


def require_verdict(
    standing: ReviewState,
    seen_verdict: Verdict | None,
    seen_at: datetime | None,
    verdict: ReviewVerdict,
    reason: str | None,
) -> str | None:
    """The reason of a verdict that may be given, without blanks around it.

    Raises Conflict if another verdict than `seen_verdict`, or one of another time than `seen_at`, stands
    (None: not compared), or for reopening what waits already, BadInput for a rejection without a reason.
    """
    if seen_verdict not in (None, standing.verdict) or seen_at not in (None, standing.at):
        name = name_or_somebody(standing.reviewer)
        raise Conflict("reviews-verdict-given-meanwhile", name=name, verdict=standing.verdict)
    given_reason = (reason or "").strip() or None
    if verdict == "rejected" and given_reason is None:
        raise BadInput("reviews-rejection-no-reason")
    if verdict == "reopened" and standing.verdict in ("to_review", "reopened"):
        raise Conflict("reviews-waits-review-already")
    return given_reason
