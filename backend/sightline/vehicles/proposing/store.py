"""Proposals of a recording's found passes: put down and read as a whole."""

from collections.abc import Sequence
from dataclasses import asdict

from sqlalchemy import Select, delete, select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_rows, get_row
from sightline.infra.database.types import now
from sightline.infra.version import code_version
from sightline.recordings.tables import recordings
from sightline.vehicles.proposing.plan_store import drawn_free
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.tables import proposals
from sightline.vehicles.tables import vehicles


def replace_proposals(
    session: Session, recording_id: int, pose_id: int, fresh: Sequence[PointProposal], *, actor: int | None
) -> None:
    """Put these in place of a recording's proposals, one event; vehicles to measure free are drawn here."""
    recording = get_row(session, recordings, recording_id, "recording")
    free, seed = drawn_free(session, recording["survey_id"], {one.vehicle_id for one in fresh})
    session.execute(delete(proposals).where(proposals.c.recording_id == recording_id))
    version, moment = code_version(), now()
    shared = {"recording_id": recording_id, "pose_id": pose_id, "code_version": version, "created_at": moment}
    rows = [{**shared, **_row_of(one), "withheld": one.vehicle_id in free} for one in fresh]
    if rows:
        add_rows(session, proposals, rows)
    after = {
        "vehicles": len({one.vehicle_id for one in fresh}),
        "points": sum(one.point_px is not None for one in fresh),
        "pose_id": pose_id,
        "code_version": version,
        "free": sorted(free),
        "seed": seed,
    }
    trail.record(session, actor, "propose", "proposals", recording_id, recording["survey_id"], None, after)


def proposals_of_recording(session: Session, recording_id: int) -> tuple[PointProposal, ...]:
    """What is proposed with the road pose in force, by vehicle; none of vehicles that were deleted."""
    return _fetch(session, _select_standing().where(proposals.c.recording_id == recording_id))


def proposals_of_vehicle(session: Session, vehicle_id: int) -> tuple[PointProposal, ...]:
    """What is proposed of one vehicle with the road pose in force."""
    return _fetch(session, _select_standing().where(proposals.c.vehicle_id == vehicle_id))


def _select_standing() -> Select[tuple[object, ...]]:
    """Where a pass was cut since, only those on a frame that it still has."""
    within = proposals.c.frame.is_(None) | proposals.c.frame.between(
        vehicles.c.first_frame, vehicles.c.last_frame
    )
    return (
        select(proposals)
        .join(recordings, recordings.c.id == proposals.c.recording_id)
        .join(vehicles, vehicles.c.id == proposals.c.vehicle_id)
        .where(recordings.c.pose_id == proposals.c.pose_id, vehicles.c.deleted_at.is_(None), within)
        .where(recordings.c.deleted_at.is_(None), vehicles.c.discarded.is_(None))
        .order_by(proposals.c.id)
    )


def _fetch(session: Session, query: Select[tuple[object, ...]]) -> tuple[PointProposal, ...]:
    return tuple(
        record_of(PointProposal, row, point_px=None if row["x_px"] is None else (row["x_px"], row["y_px"]))
        for row in session.execute(query).mappings()
    )


def _row_of(one: PointProposal) -> dict[str, object]:
    row = asdict(one)
    row["x_px"], row["y_px"] = row.pop("point_px") or (None, None)
    return row
