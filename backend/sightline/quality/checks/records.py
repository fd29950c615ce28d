"""Two tyre contacts of one vehicle."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import Point
from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class WheelPair:
    """Both tyre contacts of a vehicle on one frame; `pose_id` is the recording's pose in force."""

    id: int
    vehicle_id: int
    vehicle_number: int
    recording_id: int
    frame: int
    pts: int
    time_s: float
    frame_crc32: int
    first: Point
    second: Point
    withdrawn: bool
    pose_id: int | None
    created_by: Who | None
    created_at: datetime
