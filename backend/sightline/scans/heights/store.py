"""Heights of scanned vehicles: append-only revisions by target; a withdrawn one is a revision too."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any

from sqlalchemy import ColumnElement, Select, and_, exists, func, select, tuple_
from sqlalchemy.orm import Session

from sightline.enums import Target
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, add_rows, missing, stored_hash, stored_hashes, who
from sightline.infra.database.types import now
from sightline.measurements.again.differences import judged_alike
from sightline.measurements.records import ReviewState
from sightline.scans.heights.records import LineHeightValues, StoredLineHeight, same_line_height
from sightline.scans.heights.tables import line_height_reviews, line_heights
from sightline.scans.tables import scan_vehicles, scans
from sightline.scans.vehicles.store import require_scan_vehicle_version

_VALUES = tuple(LineHeightValues.__slots__)
_later = line_heights.alias("later")
_is_current: ColumnElement[bool] = ~exists().where(
    _later.c.vehicle_id == line_heights.c.vehicle_id,
    _later.c.target == line_heights.c.target,
    _later.c.revision > line_heights.c.revision,
)
_alive: ColumnElement[bool] = scan_vehicles.c.deleted_at.is_(None)
#: Of a height that counts: the newest of its vehicle and target, not withdrawn, all of it still there.
stands: ColumnElement[bool] = and_(
    _is_current, ~line_heights.c.withdrawn, _alive, scans.c.deleted_at.is_(None)
)
_newest_review = (
    select(func.max(line_height_reviews.c.id))
    .where(line_height_reviews.c.height_id.in_((line_heights.c.id, line_heights.c.verdict_of_id)))
    .correlate(line_heights)
    .scalar_subquery()
)
_reviewer = people.alias("reviewer")
_SOME = 500
_CLICKS = ("contact_line", "contact_row_px", "target_line", "target_row_px")


def append_line_height(
    session: Session, vehicle_id: int, values: LineHeightValues, *, seen_revision: int, actor: int | None
) -> StoredLineHeight:
    """The next revision of a target's height; `seen_revision`: 0 where none was there.

    Raises NotFound, Conflict if it was measured meanwhile or the vehicle was deleted, BadInput.
    """
    if values.status != "ok" and not values.reason:
        raise BadInput("scans-target-no-height-needs-reason-why")
    return _append(
        session, vehicle_id, values, current(session, vehicle_id, values.target), seen_revision, actor
    )


def withdraw_line_height(
    session: Session, vehicle_id: int, target: Target, *, seen_revision: int, actor: int | None
) -> StoredLineHeight:
    """Take a height back: a revision that says so. Raises NotFound, Conflict (changed or withdrawn)."""
    before = current(session, vehicle_id, target)
    if before is None:
        raise missing("height of this target")
    if before.values.withdrawn:
        raise Conflict("scans-height-withdrawn-already-nothing-done")
    values = replace(before.values, withdrawn=True)
    return _append(session, vehicle_id, values, before, seen_revision, actor)


def current(session: Session, vehicle_id: int, target: Target) -> StoredLineHeight | None:
    """The newest revision of one target, withdrawn or not; None where it was never measured."""
    mine = (line_heights.c.vehicle_id == vehicle_id) & (line_heights.c.target == target)
    found = _where(session, mine & _is_current)
    return found[0] if found else None


def get_line_height(session: Session, height_id: int) -> StoredLineHeight:
    """One revision. Raises NotFound."""
    found = _where(session, line_heights.c.id == height_id)
    if not found:
        raise missing("height in a line scan", height_id)
    return found[0]


def is_newest_line_height(session: Session, one: StoredLineHeight) -> bool:
    """Whether no later revision of the same vehicle and target is there."""
    query = select(line_heights.c.id).where(line_heights.c.id == one.id, _is_current)
    return session.execute(query).first() is not None


def heights_of_own_clicks(session: Session, scan_id: int, person_id: int) -> frozenset[int]:
    """The revisions of a scan whose clicks or figures this person made.

    Computed again by somebody else, with another calibration, the clicks are still theirs who placed them.
    """
    mine = line_heights.alias("mine")
    same = [mine.c[name] == line_heights.c[name] for name in ("vehicle_id", "target", *_CLICKS)]
    made = exists().where(*same, mine.c.created_by == person_id)
    query = select(line_heights.c.id).where(line_heights.c.scan_id == scan_id, made)
    return frozenset(session.execute(query).scalars())


def line_height_states(*conditions: ColumnElement[bool]) -> Select[Any]:
    """(scan, verdict) of each standing height with a figure, of living vehicles: what counts are made of."""
    return (
        select(line_heights.c.scan_id, line_height_reviews.c.verdict)
        .join(scan_vehicles, scan_vehicles.c.id == line_heights.c.vehicle_id)
        .outerjoin(line_height_reviews, line_height_reviews.c.id == _newest_review)
        .where(_is_current, _alive, line_heights.c.status == "ok", ~line_heights.c.withdrawn, *conditions)
    )


def list_line_heights(session: Session, scan_id: int) -> tuple[StoredLineHeight, ...]:
    """The newest revision of every target of a scan's living vehicles, withdrawn or not."""
    return _where(session, (line_heights.c.scan_id == scan_id) & _is_current & _alive)


def standing_line_heights(session: Session, survey_id: int) -> tuple[StoredLineHeight, ...]:
    """The standing heights of a survey's living vehicles, in the order of their making."""
    return _where(session, (line_heights.c.survey_id == survey_id) & stands)


def line_heights_of_computing(
    session: Session, computing_id: int
) -> tuple[tuple[StoredLineHeight, StoredLineHeight, StoredLineHeight], ...]:
    """The heights that a computing made, of vehicles that are still there: (before, made, newest) each."""
    made = select(line_heights.c.vehicle_id, line_heights.c.target)
    made = made.where(line_heights.c.computing_id == computing_id)
    place = tuple_(line_heights.c.vehicle_id, line_heights.c.target)
    revisions: dict[tuple[int, Target], list[StoredLineHeight]] = {}
    for one in _where(session, place.in_(made) & _alive & scans.c.deleted_at.is_(None)):
        revisions.setdefault((one.vehicle_id, one.values.target), []).append(one)
    return tuple(
        (before, one, all_[-1])
        for all_ in revisions.values()
        for before, one in pairwise(all_)
        if one.computing_id == computing_id and not all_[-1].values.withdrawn
    )


def line_height_history(session: Session, vehicle_id: int) -> tuple[StoredLineHeight, ...]:
    """Every revision of a vehicle's heights, oldest first."""
    return _where(session, line_heights.c.vehicle_id == vehicle_id)


def line_height_history_of_scan(session: Session, scan_id: int) -> dict[int, list[StoredLineHeight]]:
    """The same for every vehicle of a scan that has heights, by vehicle; one query."""
    found: dict[int, list[StoredLineHeight]] = {}
    for one in _where(session, line_heights.c.scan_id == scan_id):
        found.setdefault(one.vehicle_id, []).append(one)
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class LineComputedAgain:
    """A revision to come of the same clicks: after which one, its content, and the earlier revision whose
    verdict holds for it too.
    """

    before: StoredLineHeight
    values: LineHeightValues
    verdict_of_id: int | None = None


def append_line_heights_again(
    session: Session,
    survey_id: int,
    computing_id: int,
    computed: Sequence[LineComputedAgain],
    *,
    action: str,
    actor: int | None,
) -> None:
    """Write thousands of revisions of the same clicks, each with its audit event.

    They stay by who clicked. The revisions before them are read in the same transaction.
    """
    moment = now()
    for at in range(0, len(computed), _SOME):
        some = computed[at : at + _SOME]
        contents = [_content_again(one, computing_id) for one in some]
        makers = [one.before.created_by for one in some]
        rows = [
            {**content, "created_at": moment, "created_by": maker.id if maker else None}
            for content, maker in zip(contents, makers, strict=True)
        ]
        ids = add_rows(session, line_heights, rows)
        hash_of = stored_hashes(session, line_heights, ids)
        events = [
            (row_id, _then(one.before), _told(content, hash_of[row_id]))
            for one, content, row_id in zip(some, contents, ids, strict=True)
        ]
        trail.record_many(session, actor, action, "line_height", survey_id, events)


def _content_again(one: LineComputedAgain, computing_id: int) -> dict[str, Any]:
    return {
        **{name: getattr(one.before, name) for name in ("survey_id", "scan_id", "vehicle_id")},
        "revision": one.before.revision + 1,
        **asdict(one.values),
        "computing_id": computing_id,
        "verdict_of_id": one.verdict_of_id,
    }


def _then(before: StoredLineHeight) -> dict[str, Any]:
    """What an event says of the revision before."""
    names = ("status", "height_m", "withdrawn")
    return {name: getattr(before.values, name) for name in names} | {"revision": before.revision}


def _told(content: Mapping[str, Any], sha256: str) -> dict[str, Any]:
    """What an event says of a revision."""
    told = {name: value for name, value in content.items() if name not in ("budget", "warnings")}
    return {**told, "content_sha256": sha256}


def _append(
    session: Session,
    vehicle_id: int,
    values: LineHeightValues,
    before: StoredLineHeight | None,
    seen_revision: int,
    actor: int | None,
) -> StoredLineHeight:
    vehicle = require_scan_vehicle_version(session, vehicle_id, None)
    revision = before.revision if before else 0
    if revision != seen_revision:
        name = name_or_somebody(before.created_by if before else None)
        raise Conflict("scans-measured-target-meanwhile-look-height-first", name=name)
    place = {"survey_id": vehicle["survey_id"], "scan_id": vehicle["scan_id"], "vehicle_id": vehicle_id}
    content: dict[str, Any] = {**place, "revision": revision + 1, **asdict(values)}
    stood = None if before is None or values.withdrawn else _verdict_that_stood(session, vehicle_id, values)
    content |= {"computing_id": None, "verdict_of_id": stood}
    row_id = add_row(session, line_heights, {**content, "created_at": now(), "created_by": actor})
    after = _told(content, stored_hash(session, line_heights, row_id))
    then = None if before is None else _then(before)
    action = "withdraw" if values.withdrawn else "create" if before is None else "revise"
    trail.record(session, actor, action, "line_height", row_id, vehicle["survey_id"], then, after)
    return _where(session, line_heights.c.id == row_id)[0]


def _verdict_that_stood(session: Session, vehicle_id: int, values: LineHeightValues) -> int | None:
    mine = (line_heights.c.vehicle_id == vehicle_id) & (line_heights.c.target == values.target)
    history = reversed(_where(session, mine))
    return judged_alike(history, lambda one: same_line_height(one.values, values), lambda one: one.judged_id)


def _where(session: Session, condition: ColumnElement[bool]) -> tuple[StoredLineHeight, ...]:
    query = (
        select(
            line_heights,
            scan_vehicles.c.category,
            people.c.name.label("maker"),
            line_height_reviews.c.verdict,
            line_height_reviews.c.reason.label("review_reason"),
            line_height_reviews.c.created_by.label("reviewed_by"),
            line_height_reviews.c.created_at.label("reviewed_at"),
            line_height_reviews.c.height_id.label("judged_id"),
            _reviewer.c.name.label("reviewer_name"),
        )
        .join(scan_vehicles, scan_vehicles.c.id == line_heights.c.vehicle_id)
        .join(scans, scans.c.id == line_heights.c.scan_id)
        .outerjoin(people, people.c.id == line_heights.c.created_by)
        .outerjoin(line_height_reviews, line_height_reviews.c.id == _newest_review)
        .outerjoin(_reviewer, _reviewer.c.id == line_height_reviews.c.created_by)
        .where(condition)
        .order_by(line_heights.c.id)
    )
    return tuple(_height(row) for row in session.execute(query).mappings())


def _height(row: Any) -> StoredLineHeight:
    review = ReviewState("to_review")
    if row["verdict"] is not None:
        reviewer = who(row["reviewed_by"], row["reviewer_name"])
        review = ReviewState(row["verdict"], row["review_reason"], reviewer, row["reviewed_at"])
    return StoredLineHeight(
        id=row["id"],
        survey_id=row["survey_id"],
        scan_id=row["scan_id"],
        vehicle_id=row["vehicle_id"],
        revision=row["revision"],
        values=LineHeightValues(**{name: row[name] for name in _VALUES}),
        created_by=who(row["created_by"], row["maker"]),
        created_at=row["created_at"],
        review=review,
        computing_id=row["computing_id"],
        verdict_of_id=row["verdict_of_id"],
        judged_id=row["judged_id"],
        category=row["category"],
    )
