"""Exchanging the two cameras of a scan whose strips were given the wrong way round."""

from typing import get_args

from sqlalchemy.orm import Session

from sightline.enums import ScanDirection
from sightline.errors import Conflict
from sightline.infra.audit import trail
from sightline.infra.database.rows import change_row, get_row, name_of
from sightline.infra.database.types import now
from sightline.scans.records import Scan
from sightline.scans.store import get_scan, scan_worked_on
from sightline.scans.tables import scans as table

_PAIRS = (
    ("cut_1_px", "cut_2_px"),
    *(
        (f"first_{word}", f"second_{word}")
        for word in ("name", "source_key", "source_sha256", "key", "sha256")
    ),
)
# a lane's direction is told by the camera that is reached first
_OTHER_WAY = dict(zip(get_args(ScanDirection), reversed(get_args(ScanDirection)), strict=True))


def swap_scan_cameras(session: Session, scan_id: int, *, version: int, actor: int | None) -> Scan:
    """What was camera 2 is camera 1 from now on. Vehicles must be found again; until then theirs are wrong.

    Raises NotFound, Conflict (another's change in between; not read yet; people have worked on it: their
    boundaries belong to the order in which they were placed).
    """
    scan = get_scan(session, scan_id)
    if scan.version != version:
        before = get_row(session, table, scan_id, "line-scan recording")
        raise Conflict(
            "scans-changed-look-again", name_of=name_of(session, before["updated_by"]), name=scan.name
        )
    if scan.state != "ready":
        raise Conflict("scans-unread", name=scan.name)
    if scan_worked_on(session, scan_id):
        raise Conflict("scans-cameras-worked-on", name=scan.name)
    row = get_row(session, table, scan_id, "line-scan recording")
    change = {name: row[other] for pair in _PAIRS for name, other in (pair, pair[::-1])}
    if row["misalignment_px"] is not None:
        change["misalignment_px"] = -row["misalignment_px"]
    change["lanes"] = [{**one, "direction": _OTHER_WAY.get(one["direction"])} for one in row["lanes"]]
    stamps = {"version": version + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, table, scan_id, {**change, **stamps})
    trail.record(
        session, actor, "swap_cameras", "scan", scan_id, scan.survey_id, *trail.changed(row, change, change)
    )
    return get_scan(session, scan_id)
