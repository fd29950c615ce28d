"""The table of the frames that were clicked on, in the package."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sightline.infra.csv_package.columns import integer, key, number
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.media.video.frame_table import FrameTable


@dataclass(frozen=True, slots=True)
class ClickedFrame:
    """A frame of a recording, as its frame table has it."""

    recording_id: int
    frame: int
    pts: int
    time_s: float
    crc32: int


def clicked_frames(recording_id: int, table: FrameTable, frames: Iterable[int]) -> Iterator[ClickedFrame]:
    """Those of these frame numbers that a recording has."""
    for n in frames:
        if n < len(table):
            yield ClickedFrame(
                recording_id=recording_id,
                frame=int(n),
                pts=int(table.pts[n]),
                time_s=float(table.time_s[n]),
                crc32=int(table.crc32[n]),
            )


FRAMES: Table[ClickedFrame] = Table(
    "frames",
    "The frames that were clicked on, so that each can be found again in the video and proved unchanged.",
    (
        key("recording_id", "recording"),
        integer("frame", "the n-th decoded frame, from 0", required=True, minimum=0),
        integer("pts", "presentation time stamp in the stream's time base"),
        number("time_s", "time since the first frame; of filming, where the recording states filmed_hz", "s"),
        integer("crc32", "CRC-32 of the decoded luma", required=True),
    ),
    primary=("recording_id", "frame"),
    foreign=ids_of(recording_id="recordings"),
)
