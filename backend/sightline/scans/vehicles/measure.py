"""Measuring a scanned vehicle: its pictures from the stored strips, its motion by either method."""

from __future__ import annotations

from dataclasses import replace

from sightline.enums import ScanMethod
from sightline.linescan.by_hand import passage_at
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Motion, Passage, Rig
from sightline.media.strips.notes import lost_lines
from sightline.media.strips.stored_reader import StripReader

Readers = tuple[StripReader, StripReader]


def measured(passage: Passage, rig: Rig, method: ScanMethod, readers: Readers) -> Motion:
    """The motion of a vehicle; one during which lines were lost has its reason."""
    return MEASURE[method](without_losses(passage, readers), rig)


def measured_at(crossings: Crossings, rig: Rig, method: ScanMethod, readers: Readers) -> Motion:
    """The motion of the vehicle between these crossings, its pictures read from the strips."""
    first, second = readers
    passage = passage_at(crossings, rig, first.rows, (first.read, second.read))
    return measured(passage, rig, method, readers)


def without_losses(passage: Passage, readers: Readers) -> Passage:
    """The passage, with a reason where the recorder lost lines while the vehicle passed."""
    windows = ((passage.start_1, passage.first), (passage.start_2, passage.second))
    lost = [
        (camera, lost_lines(reader.notes.dropped, start, start + len(picture)))
        for camera, (reader, (start, picture)) in enumerate(zip(readers, windows, strict=True), 1)
    ]
    said = [f"{count} lines of camera {camera}" for camera, count in lost if count]
    if not said or passage.reason:
        return passage
    return replace(passage, reason=f"The recorder lost {' and '.join(said)} while the vehicle passed.")
