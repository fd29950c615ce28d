"""Many measurements at once: the same heights, checks and events as one by one, in a few queries."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sightline.infra.database import Session
from sightline.infra.database.rows import missing
from sightline.measurements.again.query import contexts_of_survey
from sightline.measurements.click_context_query import ClickContext, frames_by_number
from sightline.measurements.click_sigma_store import of_person
from sightline.measurements.ground_query import NewMeasurement
from sightline.measurements.height_of_clicks import answers
from sightline.measurements.records import Clicks
from sightline.measurements.service import (
    clicks_in_context,
    gone_by_measuring,
    pose_in_force,
    values_of_answer,
)
from sightline.measurements.store import add_measurements
from sightline.vehicles.store import update_vehicle


@dataclass(frozen=True, slots=True, kw_only=True)
class NewHeight:
    """Clicks on a vehicle to be measured and stored."""

    vehicle_id: int
    client_key: str
    clicks: Clicks


def store_measurements(
    session: Session, survey_id: int, fresh: Sequence[NewHeight], *, actor: int
) -> list[int]:
    """Measure and store each, with an audit event of its own; their ids, in their order.

    Raises what storing them one by one would: NotFound for a vehicle that is not in the survey or a frame
    that is not in its recording, Conflict without a road pose, for a target that stands measured and for a
    `client_key` that is known already; BadInput for points that are none. ValueError for two heights of one
    vehicle's target.
    """
    contexts = _contexts(session, survey_id, fresh, actor)
    by_recording: dict[int, list[int]] = defaultdict(list)
    for n, one in enumerate(fresh):
        by_recording[contexts[one.vehicle_id].recording_id].append(n)
    measured: dict[int, NewMeasurement] = {}
    for places in by_recording.values():
        pose, _, _ = pose_in_force(session, contexts[fresh[places[0]].vehicle_id])
        filled = [clicks_in_context(fresh[n].clicks, contexts[fresh[n].vehicle_id]) for n in places]
        for n, clicks, found in zip(places, filled, answers(pose, filled), strict=True):
            one = fresh[n]
            values = values_of_answer(contexts[one.vehicle_id], clicks, found)
            measured[n] = NewMeasurement(vehicle_id=one.vehicle_id, client_key=one.client_key, values=values)
    ids = add_measurements(session, survey_id, [measured[n] for n in range(len(fresh))], actor=actor)
    for one in fresh:
        if gone := gone_by_measuring(contexts[one.vehicle_id], one.clicks.target):
            update_vehicle(session, one.vehicle_id, gone, version=None, actor=actor)
    return ids


def _contexts(
    session: Session, survey_id: int, fresh: Sequence[NewHeight], actor: int
) -> dict[int, ClickContext]:
    """The contexts of the vehicles that are measured, with the frames clicked on and the person's sigma."""
    known = contexts_of_survey(session, survey_id)
    numbers: dict[int, set[int]] = defaultdict(set)
    for height in fresh:
        if height.vehicle_id not in known:
            raise missing("vehicle", height.vehicle_id)
        numbers[known[height.vehicle_id].recording_id] |= set(height.clicks.frames)
    frames = {id_: frames_by_number(session, id_, sorted(wanted)) for id_, wanted in numbers.items()}
    own = of_person(session, survey_id, actor)
    return {
        id_: replace(
            known[id_],
            frames=frames[known[id_].recording_id],
            own_sigma_px=None if own is None else own.sigma_px,
        )
        for id_ in {height.vehicle_id for height in fresh}
    }
