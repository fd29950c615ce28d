"""The work of the demonstration's two people: some vehicles measured, some of that reviewed.

The operator clicks where things are in the picture, 0.7 px beside it: the same way from points to heights as
for everybody else, so every number on the screens is one that the program computed.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from uuid import UUID, uuid5

import numpy as np

from sightline.demo.made import PassTruth
from sightline.enums import AskedTarget, DemoFate, Point
from sightline.infra.database import Session
from sightline.measurements.records import ClickedFrame, Clicks, Measurement
from sightline.measurements.service import store_measurement
from sightline.reviews.service import review
from sightline.reviews.store import add_review
from sightline.vehicles.records import Vehicle

CLICK_NOISE_PX = 0.7
# The demonstration asks for all three by day and in low light, so that each can be tried.
TARGETS: tuple[AskedTarget, ...] = ("roof", "driver_eye", "taillight")
REJECTED = "The contact point is on the shadow, below the tyre; click where the tyre touches the road."
_NAMESPACE = UUID("6f0b5a52-4d1c-4b6e-9d6e-2f1f0a3f7c11")
_SLIP_PX = 7.0
# Every third vehicle has its taillight clicked on a second frame too, this far along its way.
_SECOND_EVERY, _SECOND_TRAVEL_M = 3, 2.0
# Seeds of the clicks on a second frame, and of those that the reviewer makes.
_SECOND, _FIXED = 20190612, 20190613


@dataclass(frozen=True)
class Pass:
    """A stored vehicle with its truth, and what becomes of its measurements."""

    vehicle: Vehicle
    truth: PassTruth
    fps: int
    #: Which video, and which vehicle of it: the same in every database, as ids are not.
    place: tuple[int, int]
    fate: DemoFate = "waits"


def with_fates(passes: Sequence[Pass], *, faults: bool) -> list[Pass]:
    """Two of three are accepted; with `faults` the next one is fixed, and the one after it has the slip."""
    accepted: list[DemoFate] = ["accepted"] * (len(passes) * 2 // 3)
    after: list[DemoFate] = ["fixed", "slipped"] if faults else []
    rest: list[DemoFate] = ["waits"] * len(passes)
    fates = accepted + after + rest
    return [replace(one, fate=fate) for one, fate in zip(passes, fates, strict=False)]


def measure(session: Session, passes: list[Pass], *, actor: int) -> dict[int, list[Measurement]]:
    """Measure each vehicle as far as its targets are in sight; the measurements by vehicle id."""
    rng = np.random.default_rng(20190611)
    stored: dict[int, list[Measurement]] = {}
    for index, vehicle_pass in enumerate(passes):
        again = np.random.default_rng([_SECOND, *vehicle_pass.place])
        slip = vehicle_pass.fate == "slipped"
        for clicks in _clicks(vehicle_pass.truth, rng, slip=slip):
            if clicks.target == "taillight" and index % _SECOND_EVERY == 0 and not slip:
                clicks = replace(
                    clicks, more_frames=_second(vehicle_pass, clicks.frame, clicks.target, again)
                )
            key = str(uuid5(_NAMESPACE, f"{vehicle_pass.vehicle.id} {clicks.target}"))
            made = store_measurement(session, vehicle_pass.vehicle.id, key, clicks, actor=actor)
            stored.setdefault(vehicle_pass.vehicle.id, []).append(made)
    return stored


def _clicks(truth: PassTruth, rng: np.random.Generator, slip: bool) -> Iterator[Clicks]:
    for target in TARGETS:
        found = sight_of(truth, target)
        if found is None:
            continue
        frame, contact, point = found
        below = _SLIP_PX if slip and target == "taillight" else 0.0
        yield Clicks(
            target=target,
            frame=frame,
            contact=scatter_click((contact[0], contact[1] + below), rng),
            target_point=scatter_click(point, rng),
        )


def _second(seen: Pass, first: int, target: str, rng: np.random.Generator) -> tuple[ClickedFrame, ...]:
    """The same two points two metres further on or back; none where no frame shows them."""
    contact_name = next(frame.contact for frame in seen.truth.frames if frame.frame == first)
    apart = round(_SECOND_TRAVEL_M / seen.truth.speed_mps * seen.fps)
    for frame in seen.truth.frames:
        shown = contact_name in frame.pixels and frame.shows(target)
        if shown and abs(frame.frame - first) == apart and contact_name is not None:
            contact, point = (
                scatter_click(frame.pixels[contact_name], rng),
                scatter_click(frame.pixels[target], rng),
            )
            return (ClickedFrame(frame=frame.frame, contact=contact, target_point=point),)
    return ()


def sight_of(truth: PassTruth, target: str) -> tuple[int, Point, Point] | None:
    """(frame, contact, target) in the frame that shows both best, uncovered; None if none does."""
    best = truth.best_frames.get(target, truth.best_frame)
    for one in sorted(truth.frames, key=lambda seen: abs(seen.frame - best)):
        if one.contact is not None and one.shows(target):
            return one.frame, one.pixels[one.contact], one.pixels[target]
    return None


def scatter_click(point: Point, rng: np.random.Generator, noise_px: float = CLICK_NOISE_PX) -> Point:
    """A click beside a point."""
    x, y = rng.normal(0.0, noise_px, 2)
    return round(point[0] + float(x), 2), round(point[1] + float(y), 2)


def judge(session: Session, passes: list[Pass], stored: dict[int, list[Measurement]], *, actor: int) -> None:
    """The reviewer's verdicts, as each vehicle's fate says."""
    for vehicle_pass in passes:
        for measurement in stored.get(vehicle_pass.vehicle.id, []):
            seen = measurement.revision
            if vehicle_pass.fate == "accepted":
                add_review(session, measurement.id, seen_revision=seen, verdict="accepted", actor=actor)
            elif vehicle_pass.fate == "slipped" and measurement.values.target == "taillight":
                add_review(
                    session,
                    measurement.id,
                    seen_revision=seen,
                    verdict="rejected",
                    reason=REJECTED,
                    actor=actor,
                )
            elif vehicle_pass.fate == "fixed" and measurement.values.target == "roof":
                _fix(session, measurement, vehicle_pass, actor)


def _fix(session: Session, measurement: Measurement, seen: Pass, actor: int) -> None:
    found = sight_of(seen.truth, measurement.values.target)
    assert found is not None
    rng = np.random.default_rng([_FIXED, *seen.place])
    review(
        session,
        measurement.id,
        revision=measurement.revision,
        verdict="fixed",
        reason="Clicked again at higher zoom.",
        frame=None,
        contact=scatter_click(found[1], rng),
        target_point=scatter_click(found[2], rng),
        actor=actor,
    )
