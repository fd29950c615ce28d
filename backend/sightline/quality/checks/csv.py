"""The table of both tyre contacts in an export: what the direction of travel was checked with."""

from sightline.infra.csv_package.columns import integer, key, moment, number, person, pixel
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.quality.checks.records import WheelPair

WHEEL_PAIRS: Table[WheelPair] = Table(
    "wheel_pairs",
    "Where both tyres of a vehicle touch the road on one frame: the direction of travel, against which the "
    "road's X axis is checked. The pair that counts of each vehicle.",
    (
        key("id", "pair of tyre contacts"),
        key("vehicle_id", "vehicle whose tyres were clicked"),
        key("recording_id", "recording in which they were clicked"),
        integer("frame", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
        integer("pts", "presentation time stamp of that frame, in the stream's own time base"),
        number("time_s", "time of that frame from the start of the stream", "s"),
        integer("frame_crc32", "CRC-32 of the decoded luma of that frame"),
        pixel("first_x_px", "x where one tyre touches the road", lambda w: w.first[0]),
        pixel("first_y_px", "y where one tyre touches the road", lambda w: w.first[1]),
        pixel(
            "second_x_px", "x where the other tyre of the same side touches the road", lambda w: w.second[0]
        ),
        pixel(
            "second_y_px", "y where the other tyre of the same side touches the road", lambda w: w.second[1]
        ),
        person("created_by_id", "who clicked the points"),
        moment("created_at", "when it was stored"),
    ),
    primary=("id",),
    foreign=ids_of(vehicle_id="vehicles", recording_id="recordings"),
)
