"""The table of repeats in an export: what repeatability and reproducibility are computed from."""

from sightline.infra.csv_package.columns import (
    columns_within,
    flag,
    integer,
    key,
    metres,
    moment,
    person,
    text,
)
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.csv import FRAME, PASS, POINTS, POSE, REASON
from sightline.measurements.records import Measurement

REPEATS: Table[Measurement] = Table(
    "repeats",
    "Measurements clicked again without seeing the first clicks, to know how well people click. They count "
    "for no result. Withdrawn ones are kept and marked.",
    (
        key("id", "repeat"),
        key("measurement_id", "measurement that was clicked again", lambda m: m.repeat_of),
        *PASS,
        *columns_within("values", text("target", "what was measured", required=True)),
        *FRAME,
        *columns_within("values", integer("frame_crc32", "CRC-32 of the decoded luma of that frame")),
        *POINTS,
        *POSE,
        *columns_within(
            "values",
            metres("inset_m", "inset: distance from the vertical plane through the contact to the target"),
            metres("u_inset_m", "standard uncertainty of the inset (k = 1)"),
            metres("height_m", "height of the target above the road, corrected for the inset"),
            metres("u_height_m", "standard uncertainty of height_m (k = 1)"),
            text("status", "whether there is a height", required=True),
        ),
        *REASON,
        person("created_by_id", "column-measurements-created-by-id"),
        moment("created_at", "when it was stored"),
        flag("withdrawn", "true if the repeat was withdrawn", required=True),
        out_of_date("recording's road pose"),
    ),
    primary=("id",),
    foreign=ids_of(
        measurement_id="measurements",
        vehicle_id="vehicles",
        recording_id="recordings",
        pose_id="poses",
        created_by_id="people",
    ),
)
