"""The table of repeats in an export: what repeatability and reproducibility are computed from."""

from __future__ import annotations

from collections.abc import Sequence

from sightline.infra.csv_package.schema import Cell, Column, Table, when
from sightline.measurements.records import Measurement


def _px(name: str, meaning: str) -> Column:
    return Column(
        name, "number", f"{meaning}; (0, 0) is the centre of the top-left pixel", "px", required=True
    )


def _m(name: str, meaning: str) -> Column:
    return Column(name, "number", meaning, "m")


REPEATS = Table(
    "repeats",
    "Measurements clicked again without seeing the first clicks, to know how well people click. They count "
    "for no result. Withdrawn ones are kept and marked.",
    (
        Column("id", "integer", "repeat", required=True),
        Column("measurement_id", "integer", "measurement that was clicked again", required=True),
        Column("vehicle_id", "integer", "vehicle that was measured", required=True),
        Column("recording_id", "integer", "recording in which the points were clicked", required=True),
        Column("target", "string", "what was measured", required=True),
        Column("frame", "integer", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
        Column("pts", "integer", "presentation time stamp of that frame, in the stream's own time base"),
        Column("time_s", "number", "time of that frame from the start of the stream", "s"),
        Column("frame_crc32", "integer", "CRC-32 of the decoded luma of that frame"),
        _px("contact_x_px", "where the tyre meets the road, x to the right"),
        _px("contact_y_px", "where the tyre meets the road, y down"),
        _px("target_x_px", "the target point, x to the right"),
        _px("target_y_px", "the target point, y down"),
        Column(
            "sigma_px", "number", "standard uncertainty of each coordinate of each click", "px", minimum=0
        ),
        Column("pose_id", "integer", "road pose used", required=True),
        _m("inset_m", "how far the target lies behind the vertical plane through the contact"),
        _m("u_inset_m", "standard uncertainty of the inset (k = 1)"),
        _m("height_m", "height of the target above the road, corrected for the inset"),
        _m("u_height_m", "standard uncertainty of height_m (k = 1)"),
        Column("status", "string", "whether there is a height", required=True),
        Column("reason", "string", "why there is no height"),
        Column("created_by_id", "integer", "who clicked"),
        Column("created_at", "datetime", "when it was stored (ISO 8601, UTC)"),
        Column("withdrawn", "boolean", "true where the repeat was taken back", required=True),
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


def repeat_rows(repeats: Sequence[Measurement]) -> list[dict[str, Cell]]:
    """Rows by id."""
    return [
        {
            "id": one.id,
            "measurement_id": one.repeat_of,
            "vehicle_id": one.vehicle_id,
            "recording_id": one.recording_id,
            "target": one.values.target,
            "frame": one.values.frame,
            "pts": one.values.pts,
            "time_s": one.values.time_s,
            "frame_crc32": one.values.crc32,
            "contact_x_px": one.values.contact[0],
            "contact_y_px": one.values.contact[1],
            "target_x_px": one.values.target_point[0],
            "target_y_px": one.values.target_point[1],
            "sigma_px": one.values.sigma_px,
            "pose_id": one.values.pose_id,
            "inset_m": one.values.inset_m,
            "u_inset_m": one.values.u_inset_m,
            "height_m": one.values.height_m,
            "u_height_m": one.values.u_height_m,
            "status": one.values.status,
            "reason": one.values.reason,
            "created_by_id": None if one.created_by is None else one.created_by.id,
            "created_at": when(one.created_at),
            "withdrawn": one.withdrawn,
        }
        for one in sorted(repeats, key=lambda repeat: repeat.id)
    ]
