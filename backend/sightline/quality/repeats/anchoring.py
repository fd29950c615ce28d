"""How far people lean on what they are shown: heights of proposals shown against those measured free."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from statistics import fmean
from typing import Annotated

from pydantic import Field

from sightline.enums import GoalVerdict, Made, ProposalKept, Target
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import answer
from sightline.measurements.records import Measurement, MeasurementValues
from sightline.measurements.road_poses import road_pose
from sightline.measurements.service import clicked_again
from sightline.quality.repeats.clicks import height_of_first_frame
from sightline.quality.repeats.query import measurements_with_proposals
from sightline.statistics.anchoring import Shift, shift, verdict
from sightline.vehicles.proposing.plan_store import get_free_plan
from sightline.vehicles.proposing.records import FreePlan

GOAL_M = 0.002


@dataclass(frozen=True)
class OfProposedTarget:
    """What showing proposals does to heights of a target, metres; `target` None: of all, a vehicle once."""

    target: Annotated[Target | None, Field(description="None: all targets together.")]
    shift: Shift
    verdict: Annotated[GoalVerdict | None, Field(description="Of the whole interval against the goal.")]


@dataclass(frozen=True)
class Anchoring:
    """`confirmed`: how many compared heights were shown and stored as proposed; `goal_m`: of `shift_m`."""

    plan: FreePlan
    goal_m: float
    confirmed: int
    moved: int
    afresh: Annotated[int, Field(description="Shown, and clicked or snapped all the same.")]
    targets: tuple[OfProposedTarget, ...]


@dataclass(frozen=True)
class _Told:
    vehicle_id: int
    target: Target
    kept: ProposalKept
    made: Made
    difference_m: float


def anchoring(session: Session, survey_id: int) -> Anchoring:
    """Of the standing heights of which contact and target were proposed on their frame, whatever people did
    with what they were shown: to leave out what they turned down would choose the proposals that are right.
    """
    found = measurements_with_proposals(session, survey_id)
    differences = [one for each in found if (one := _compare_with_proposal(session, each)) is not None]
    origins = [one.made for one in differences if one.kept == "shown"]
    targets = sorted({one.target for one in differences})
    return Anchoring(
        plan=get_free_plan(session, survey_id),
        goal_m=GOAL_M,
        confirmed=origins.count("confirmed"),
        moved=origins.count("moved"),
        afresh=len(origins) - origins.count("confirmed") - origins.count("moved"),
        targets=tuple(
            _of_target(target, [one for one in differences if target in (None, one.target)])
            for target in (None, *targets)
        ),
    )


def _compare_with_proposal(session: Session, measurement: Measurement) -> _Told | None:
    """A height minus that of its proposed points, with all else alike; None where either has none."""
    height_m, _ = height_of_first_frame(session, measurement)
    proposed_m = _proposed_height_m(session, measurement.values)
    if height_m is None or proposed_m is None or measurement.values.proposal is None:
        return None
    return _Told(
        vehicle_id=measurement.vehicle_id,
        target=measurement.values.target,
        kept=measurement.values.proposal,
        made=measurement.values.made,
        difference_m=height_m - proposed_m,
    )


def _proposed_height_m(session: Session, values: MeasurementValues) -> float | None:
    x, y = values.proposed_contact_x_px, values.proposed_contact_y_px
    u, v = values.proposed_target_x_px, values.proposed_target_y_px
    if x is None or y is None or u is None or v is None:
        return None
    clicks = replace(clicked_again(values, values.frame, (x, y), (u, v)), more_frames=(), followed=None)
    return answer(road_pose(session, values.pose_id), clicks).height_m


def _of_target(target: Target | None, told: Sequence[_Told]) -> OfProposedTarget:
    found = shift(_by_vehicle(told, "shown"), _by_vehicle(told, "withheld"))
    return OfProposedTarget(target=target, shift=found, verdict=verdict(found, GOAL_M))


def _by_vehicle(told: Iterable[_Told], kept: ProposalKept) -> list[float]:
    """The mean difference of each vehicle: points of one share their contact."""
    of: dict[int, list[float]] = defaultdict(list)
    for one in told:
        if one.kept == kept:
            of[one.vehicle_id].append(one.difference_m)
    return [fmean(of[vehicle_id]) for vehicle_id in sorted(of)]
