"""Passes taken apart and put together; measurements never change their vehicle."""

from sightline.errors import BadInput, Conflict
from sightline.infra.database import Session
from sightline.measurements.sheets.query import frames_used_of_vehicle
from sightline.vehicles.records import Vehicle, VehicleChanges
from sightline.vehicles.store import create_vehicle, get_vehicle, remove_vehicle, update_vehicle


def split(
    session: Session, vehicle_id: int, frame: int, *, version: int, actor: int
) -> tuple[Vehicle, Vehicle]:
    """Two passes of one, the second beginning at `frame`: the earlier, then the later.

    The vehicle keeps the side on which it was measured (the earlier one, if it was not), the other side is
    a new pass. Raises BadInput for a frame that leaves no two sides, Conflict where measurements lie on both
    sides or somebody changed the vehicle since `version`.
    """
    whole = get_vehicle(session, vehicle_id)
    if not whole.first_frame < frame <= whole.last_frame:
        raise BadInput(
            "measurements-frame-cannot-split",
            frame=frame,
            number=whole.number,
            first_frame=whole.first_frame,
            last_frame=whole.last_frame,
        )
    later = _side_of_measurements(session, whole, frame)
    sides = (whole.first_frame, frame - 1), (frame, whole.last_frame)
    kept = update_vehicle(
        session, vehicle_id, _span(sides[later], whole.best_frame), version=version, actor=actor
    )
    fields = {
        **_span(sides[1 - later], whole.best_frame),
        "lighting": whole.lighting,
        "origin": whole.origin,
        "direction": whole.direction,
        "driver_side": whole.driver_side,
    }
    made = create_vehicle(session, whole.recording_id, fields, actor=actor)
    return (made, kept) if later else (kept, made)


def join(
    session: Session, vehicle_id: int, other_id: int, *, version: int, other_version: int, actor: int
) -> Vehicle:
    """One pass of two of a recording: the one with measurements (the first, if none has) spans both, the
    other is discarded.

    Raises Conflict where both were measured or somebody changed one of them, BadInput for passes of two
    recordings.
    """
    vehicle, other = get_vehicle(session, vehicle_id), get_vehicle(session, other_id)
    if vehicle.id == other.id or vehicle.recording_id != other.recording_id:
        raise BadInput("measurements-join-other-recording")
    both = frames_used_of_vehicle(session, vehicle.id), frames_used_of_vehicle(session, other.id)
    if both[0] and both[1]:
        raise Conflict("measurements-join-both-measured", number=vehicle.number, number_2=other.number)
    keeps_other = bool(both[1])
    kept, gone = (other, vehicle) if keeps_other else (vehicle, other)
    versions = (other_version, version) if keeps_other else (version, other_version)
    span = {
        "first_frame": min(vehicle.first_frame, other.first_frame),
        "last_frame": max(vehicle.last_frame, other.last_frame),
    }
    if kept.best_frame is None and gone.best_frame is not None:
        span["best_frame"] = gone.best_frame
    remove_vehicle(session, gone.id, version=versions[1], actor=actor)
    return update_vehicle(session, kept.id, span, version=versions[0], actor=actor)


def _side_of_measurements(session: Session, whole: Vehicle, frame: int) -> int:
    """0 if nothing was measured at or after `frame`, 1 if all was. Raises Conflict."""
    used = {n for frames in frames_used_of_vehicle(session, whole.id) for n in frames}
    if any(n < frame for n in used) and any(n >= frame for n in used):
        raise Conflict("measurements-split-between", number=whole.number, frame=frame)
    return int(any(n >= frame for n in used))


def _span(side: tuple[int, int], best_frame: int | None) -> VehicleChanges:
    first, last = side
    stays = best_frame is not None and first <= best_frame <= last
    return {"first_frame": first, "last_frame": last, "best_frame": best_frame if stays else None}
