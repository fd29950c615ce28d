"""Proposals of a recording's found passes: put down and read as a whole."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict

from sqlalchemy import Select, delete, select
from sqlalchemy.orm import Session

from sightline.infra.audit import choice, trail
from sightline.infra.audit.records import survey_chain
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_rows, get_row
from sightline.infra.database.types import now
from sightline.infra.version import code_version
from sightline.recordings.tables import recordings
from sightline.vehicles.proposing.records import FreePlan, PointProposal
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


# How many vehicles of a survey are measured free of proposals, and which: drawn once, chosen by nobody.
#
# The plan has no table of its own (`infra/audit/choice`).


_PLAN = choice.DrawPlan(
    choice.Kind("free_plan", "free_one_in"),
    usual=10,
    least=2,
    changed="proposals-somebody-changed-plan",
    refused="proposals-plan-one-in",
)


def get_free_plan(session: Session, survey_id: int) -> FreePlan:
    """The plan in force; version 0 is the usual one. Raises NotFound."""
    return FreePlan(*_PLAN.in_force(session, survey_id))


def choose_free_plan(
    session: Session, survey_id: int, *, free_one_in: int, version: int, actor: int | None
) -> FreePlan:
    """Vehicles of which something is proposed for the first time from now on: one in `free_one_in` is
    measured free, none at 0. What was drawn stays drawn.

    Raises BadInput outside 0 and 2 to 100, Conflict if `version` is not the current one, NotFound.
    """
    return FreePlan(*_PLAN.choose(session, survey_id, free_one_in, version=version, actor=actor))


def drawn_free(session: Session, survey_id: int, vehicles: Iterable[int]) -> tuple[frozenset[int], str]:
    """(the vehicles that are measured free, the seed): those drawn before stay what they were; the rest is
    drawn by the end of the survey's audit chain, which nobody chooses.
    """
    one_in = get_free_plan(session, survey_id).free_one_in
    seed = trail.hold_chain_end(session, survey_chain(survey_id)).hash
    wanted = set(vehicles)
    before = select(proposals.c.vehicle_id, proposals.c.withheld).where(
        proposals.c.recording_id.in_(select(recordings.c.id).where(recordings.c.survey_id == survey_id))
    )
    known = {row.vehicle_id: row.withheld for row in session.execute(before)}
    drawn = {id_ for id_ in wanted if known.get(id_, is_drawn_free(seed, id_, one_in))}
    return frozenset(drawn), seed


def is_drawn_free(seed: str, vehicle_id: int, one_in: int) -> bool:
    """By sha256 of seed and vehicle, which anybody can compute."""
    return choice.one_of(f"{seed} {vehicle_id}", one_in)
