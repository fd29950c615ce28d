"""Heights of a survey's line scans that wait for a verdict, for the one queue of the reviewers."""

from sightline.infra.database import Session
from sightline.scans.heights.records import LineHeightQueue, WaitingLineHeight
from sightline.scans.heights.store import list_scan_heights, revisions_of_own_clicks
from sightline.scans.records import Scan
from sightline.scans.store import list_scans
from sightline.scans.vehicles.store import list_scan_vehicles

MOST = 200


def line_height_queue(session: Session, survey_id: int, *, actor: int) -> LineHeightQueue:
    """What waits, scan by scan in the vehicles' order, one's own last; all counted, MOST listed."""
    found = [one for scan in list_scans(session, survey_id) for one in _waiting(session, scan, actor)]
    found.sort(key=lambda one: one.mine)
    own = sum(one.mine for one in found)
    return LineHeightQueue(to_review=len(found) - own, own=own, items=tuple(found[:MOST]))


def _waiting(session: Session, scan: Scan, actor: int) -> list[WaitingLineHeight]:
    heights = [
        one
        for one in list_scan_heights(session, scan.id)
        if one.values.status == "ok" and not one.withdrawn and one.review.verdict in ("to_review", "reopened")
    ]
    if not heights:
        return []
    own = revisions_of_own_clicks(session, scan.id, actor)
    numbers = {vehicle.id: vehicle.number for vehicle in list_scan_vehicles(session, scan.id)}
    waiting = [
        WaitingLineHeight(
            id=one.id,
            scan_id=scan.id,
            scan_name=scan.name,
            vehicle_id=one.vehicle_id,
            number=numbers[one.vehicle_id],
            target=one.values.target,
            height_m=one.values.height_m,
            U95_height_m=one.values.U95_height_m,
            mine=one.revision_id in own,
        )
        for one in heights
    ]
    return sorted(waiting, key=lambda one: (one.number, one.target))
