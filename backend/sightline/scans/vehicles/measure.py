"""Measuring a scanned vehicle: its pictures from the stored strips, its motion by either method."""

from dataclasses import replace
from math import sqrt

from sightline.enums import ScanMethod
from sightline.linescan.budget import DISAGREE_OVER_U, u_end_of
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
    """The doubt about found boundaries, m, of front and rear: as the budget had it, but no more than both had
    where the cameras disagreed about that end; half each where a budget does not tell.
    """
    motion = earlier if isinstance(earlier, Motion) else motion_of(earlier)
    both_m = motion.u_boundaries_m
    if motion.method == "paper" or not motion.budget:
        return both_m / sqrt(2), both_m / sqrt(2)
    front_m, rear_m = u_end_of(motion.budget, "front"), u_end_of(motion.budget, "rear")
    most_m = DISAGREE_OVER_U * both_m
    return both_m if front_m > most_m else front_m, both_m if rear_m > most_m else rear_m


def measured_again(before: ScanMeasurement, rig: Rig, method: ScanMethod, readers: Readers) -> Motion:
    """The motion between boundaries that stand, in the lane that a person chose, if one did."""
    values, lane = before.values, lane_by_person(before)
    return measured_at(crossings_of(values), rig, method, readers, lane, values)
