"""Lines that the recorder lost while a vehicle passed: apart from what is stored, so that a command which
stores nothing starts without a database's library.
"""

from collections.abc import Sequence

from sightline.linescan.faults import lines_lost
from sightline.linescan.parts import Passage
from sightline.media.strips.notes import Dropped, lost_lines
from sightline.messages.said import Said


def without_losses(passage: Passage, dropped: Sequence[Sequence[Dropped]]) -> Passage:
    """The passage, with a reason where the recorder lost lines of either camera while the vehicle passed."""
    windows = ((passage.start_1, passage.first), (passage.start_2, passage.second))
    lost = [
        (camera, lost_lines(gaps, start, start + len(picture)))
        for camera, (gaps, (start, picture)) in enumerate(zip(dropped, windows, strict=True), 1)
    ]
    return lines_lost(passage, [Said("scan-lines-of-camera", count=n, camera=one) for one, n in lost if n])
