"""The table of repeats in an export: what repeatability and reproducibility are computed from."""

from sightline.infra.csv_package.columns import columns_for, columns_within, flag, key, moment
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.csv import INSET, POINTS, POSE, WHERE
from sightline.measurements.records import Measurement, MeasurementValues

REPEATS: Table[Measurement] = Table(
    "repeats",
    "Measurements clicked again without seeing the first clicks, to know how well people click. They count "
    "for no result. Withdrawn ones are kept and marked.",
    (
        key("id", "repeat"),
        key("measurement_id", "measurement that was clicked again", lambda m: m.repeat_of),
        *WHERE,
        *POINTS,
        *POSE,
        *INSET,
        *columns_within("values", *columns_for(MeasurementValues, "height_m u_height_m status reason")),
        *columns_for(Measurement, "created_by_id"),
        moment("created_at", "when it was stored"),
        flag("withdrawn", "true if the repeat was withdrawn", required=True),
        out_of_date("recording's road pose"),
    ),
    primary=("id",),
    foreign=ids_of(
        measurement_id="measurements", vehicle_id="vehicles", recording_id="recordings", pose_id="poses"
    ),
)
