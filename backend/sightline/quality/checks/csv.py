"""The table of both tyre contacts in an export: what the direction of travel was checked with."""

from __future__ import annotations

from collections.abc import Sequence

from sightline.infra.csv_package.schema import Cell, Column, Table, when
from sightline.quality.checks.records import WheelPair


def _click(name: str, meaning: str) -> Column:
    words = f"{meaning} touches the road; (0, 0) is the centre of the top-left pixel"
    return Column(name, "number", words, "px", required=True)


WHEEL_PAIRS = Table(
    "wheel_pairs",
    "Where both tyres of a vehicle touch the road on one frame: the direction of travel, against which the "
    "road's X axis is checked. The pair that counts of each vehicle.",
    (
        Column("id", "integer", "pair of tyre contacts", required=True),
        Column("vehicle_id", "integer", "vehicle whose tyres were clicked", required=True),
        Column("recording_id", "integer", "recording in which they were clicked", required=True),
        Column("frame", "integer", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
        Column("pts", "integer", "presentation time stamp of that frame, in the stream's own time base"),
        Column("time_s", "number", "time of that frame from the start of the stream", "s"),
        Column("frame_crc32", "integer", "CRC-32 of the decoded luma of that frame"),
        _click("first_x_px", "x where one tyre"),
        _click("first_y_px", "y where one tyre"),
        _click("second_x_px", "x where the other tyre of the same side"),
        _click("second_y_px", "y where the other tyre of the same side"),
        Column("created_by_id", "integer", "who clicked"),
        Column("created_at", "datetime", "when it was stored (ISO 8601, UTC)"),
    ),
    primary=("id",),
    foreign=(
        (("vehicle_id",), "vehicles", ("id",)),
        (("recording_id",), "recordings", ("id",)),
        (("created_by_id",), "people", ("id",)),
    ),
)


def wheel_pair_rows(pairs: Sequence[WheelPair]) -> list[dict[str, Cell]]:
    """Rows by id."""
    return [
        {
            "id": one.id,
            "vehicle_id": one.vehicle_id,
            "recording_id": one.recording_id,
            "frame": one.frame,
            "pts": one.pts,
            "time_s": one.time_s,
            "frame_crc32": one.crc32,
            "first_x_px": one.first[0],
            "first_y_px": one.first[1],
            "second_x_px": one.second[0],
            "second_y_px": one.second[1],
            "created_by_id": None if one.created_by is None else one.created_by.id,
            "created_at": when(one.created_at),
        }
        for one in sorted(pairs, key=lambda pair: pair.id)
    ]
