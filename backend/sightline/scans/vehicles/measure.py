"""Measuring a scanned vehicle: its pictures from the stored strips, its motion by either method."""

from dataclasses import replace
from math import hypot

from sightline.enums import ScanMethod
from sightline.linescan.by_hand import passage_at
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Motion, Passage, Rig, rear_seen
from sightline.linescan.rig import at_lane, lane_named
from sightline.media.strips.stored_reader import StripReader
from sightline.scans.losses import without_losses
from sightline.scans.records import ScanMeasurement, ScanValues
from sightline.scans.vehicles.motion import crossings_of, lane_by_person, motion_of

Readers = tuple[StripReader, StripReader]


def measure_passage(passage: Passage, rig: Rig, method: ScanMethod, readers: Readers) -> Motion:
    """The motion of a vehicle; one during which lines were lost has its reason."""
    return MEASURE[method](without_losses(passage, (readers[0].notes.dropped, readers[1].notes.dropped)), rig)


def measured_at(
    crossings: Crossings,
    rig: Rig,
    method: ScanMethod,
    readers: Readers,
    lane: str | None = None,
    earlier: Motion | ScanValues | None = None,
) -> Motion:
    """The motion of the vehicle between these crossings, its pictures read from the strips.

    `lane`: what a person said; a lane that the rig does not have is not believed. `earlier`: what was said of
    these boundaries before: their doubt stays, and a rear that was not seen still is not.
    """
    first, second = readers
    passage = passage_at(crossings, rig, first.rows, (first.read, second.read), first.bits)
    if earlier is not None:
        reason = None if rear_seen(earlier.reason) else earlier.reason
        passage = replace(passage, u_ends_m=_u_ends(earlier), reason=reason)
    if lane_named(rig, lane) is None:
        return measure_passage(passage, rig, method, readers)
    motion = measure_passage(passage, replace(at_lane(rig, lane), lanes=()), method, readers)
    return replace(motion, lane=lane, lane_by="person")


def _u_ends(earlier: Motion | ScanValues) -> tuple[float, float]:
    """The doubt about found boundaries, m, by front and rear as the budget had them; half each without."""
    motion = earlier if isinstance(earlier, Motion) else motion_of(earlier)
    of_length = {one.source: one.u_length_m for one in motion.budget}
    front, rear = of_length.get("front", 1.0), of_length.get("rear", 1.0)
    share = motion.u_boundaries_m / hypot(front, rear)
    return share * front, share * rear


def measured_again(before: ScanMeasurement, rig: Rig, method: ScanMethod, readers: Readers) -> Motion:
    """The motion between boundaries that stand, in the lane that a person chose, if one did."""
    values, lane = before.values, lane_by_person(before)
    return measured_at(crossings_of(values), rig, method, readers, lane, values)
