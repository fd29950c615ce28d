"""The table of cameras in the package."""

from sightline.cameras.records import Camera
from sightline.infra.csv_package.columns import integer, key, text
from sightline.infra.csv_package.schema import Table

CAMERAS: Table[Camera] = Table(
    "cameras",
    "The cameras: each a body and lens at one setting.",
    (
        key("id", "camera"),
        text("name", "name of the camera", required=True),
        text("lens", "its lens"),
        text("zoom", "how the lens was zoomed"),
        text("focus", "how it was focused"),
        text("taken_from", "survey and camera that it was taken from with its calibration, if it was"),
        text("notes", "remarks"),
        integer("current_calibration_id", "calibration that new road poses use"),
    ),
    primary=("id",),
)
