"""The table of repeats in an export: what repeatability and reproducibility are computed from."""

from __future__ import annotations

from sightline.infra.csv_package.columns import (
    flag,
    integer,
    key,
    metres,
    moment,
    number,
    person,
    pixel,
    text,
)
from sightline.infra.csv_package.schema import Table
from sightline.measurements.records import Measurement

REPEATS: Table[Measurement] = Table(
    "repeats",
    "Measurements clicked again without seeing the first clicks, to know how well people click. They count "
    "for no result. Withdrawn ones are kept and marked.",
    (
        key("id", "repeat", lambda m: m.id),
        key("measurement_id", "measurement that was clicked again", lambda m: m.repeat_of),
        key("vehicle_id", "vehicle that was measured", lambda m: m.vehicle_id),
        key("recording_id", "recording in which the points were clicked", lambda m: m.recording_id),
        text("target", "what was measured", lambda m: m.values.target, required=True),
        integer(
            "frame",
            "frame number: the n-th decoded frame, from 0",
            lambda m: m.values.frame,
            required=True,
            minimum=0,
        ),
        integer(
            "pts",
            "presentation time stamp of that frame, in the stream's own time base",
            lambda m: m.values.pts,
        ),
        number("time_s", "time of that frame from the start of the stream", "s", lambda m: m.values.time_s),
        integer("frame_crc32", "CRC-32 of the decoded luma of that frame", lambda m: m.values.frame_crc32),
        pixel("contact_x_px", "where the tyre meets the road, x to the right", lambda m: m.values.contact[0]),
        pixel("contact_y_px", "where the tyre meets the road, y down", lambda m: m.values.contact[1]),
        pixel("target_x_px", "the target point, x to the right", lambda m: m.values.target_point[0]),
        pixel("target_y_px", "the target point, y down", lambda m: m.values.target_point[1]),
        number(
            "sigma_px",
            "standard uncertainty of each coordinate of each click",
            "px",
            lambda m: m.values.sigma_px,
            minimum=0,
        ),
        key("pose_id", "road pose used", lambda m: m.values.pose_id),
        metres(
            "inset_m",
            "how far the target lies behind the vertical plane through the contact",
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
        text("reason", "why there is no height", lambda m: m.values.reason),
        person("created_by_id", "who clicked", lambda m: m.created_by),
        moment("created_at", "when it was stored", lambda m: m.created_at),
        flag("withdrawn", "true where the repeat was taken back", lambda m: m.withdrawn, required=True),
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
