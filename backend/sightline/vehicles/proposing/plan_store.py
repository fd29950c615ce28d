"""How many vehicles of a survey are measured free of proposals, and which: drawn once, chosen by nobody.

The plan has no table of its own (`infra/audit/choice`).
"""

from collections.abc import Iterable

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit import choice, trail
from sightline.infra.audit.records import survey_chain
from sightline.recordings.tables import recordings
from sightline.vehicles.proposing.records import FreePlan
from sightline.vehicles.proposing.tables import proposals

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
