"""The table of repeats in an export: what repeatability and reproducibility are computed from."""

from __future__ import annotations

from sightline.infra.csv_package.columns import (
    flag,
    integer,
    key,
    metres,
    moment,
    person,
    text,
)
from sightline.infra.csv_package.schema import Table
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.csv import FRAME, PASS, POINTS, POSE, REASON
from sightline.measurements.records import Measurement

REPEATS: Table[Measurement] = Table(
    "repeats",
    "Measurements clicked again without seeing the first clicks, to know how well people click. They count "
    "for no result. Withdrawn ones are kept and marked.",
    (
        key("id", "repeat", lambda m: m.id),
        key("measurement_id", "measurement that was clicked again", lambda m: m.repeat_of),
        *PASS,
        text("target", "what was measured", lambda m: m.values.target, required=True),
        *FRAME,
        integer("frame_crc32", "CRC-32 of the decoded luma of that frame", lambda m: m.values.frame_crc32),
        *POINTS,
        *POSE,
        metres(
            "inset_m",
            "inset: distance from the vertical plane through the contact to the target",
            lambda m: m.values.inset_m,
        ),
        metres("u_inset_m", "standard uncertainty of the inset (k = 1)", lambda m: m.values.u_inset_m),
        metres(
            "height_m",
            "height of the target above the road, corrected for the inset",
            lambda m: m.values.height_m,
        ),
        metres("u_height_m", "standard uncertainty of height_m (k = 1)", lambda m: m.values.u_height_m),
        text("status", "whether there is a height", lambda m: m.values.status, required=True),
        *REASON,
        person("created_by_id", "who clicked the points", lambda m: m.created_by),
        moment("created_at", "when it was stored", lambda m: m.created_at),
        flag("withdrawn", "true if the repeat was withdrawn", lambda m: m.withdrawn, required=True),
        out_of_date("recording's road pose", lambda m: m.out_of_date),
    ),
    primary=("id",),
    foreign=(
        (("measurement_id",), "measurements", ("id",)),
        (("vehicle_id",), "vehicles", ("id",)),
        (("recording_id",), "recordings", ("id",)),
        (("pose_id",), "poses", ("id",)),
        (("created_by_id",), "people", ("id",)),
    ),
)
