"""The table of cameras in the package."""

from __future__ import annotations

from sightline.cameras.records import Camera
from sightline.infra.csv_package.columns import integer, key, text
from sightline.infra.csv_package.schema import Table

CAMERAS: Table[Camera] = Table(
    "cameras",
    "The cameras: each a body and lens at one setting.",
    (
        key("id", "camera", lambda c: c.id),
        text("name", "name of the camera", lambda c: c.name, required=True),
        text("lens", "its lens", lambda c: c.lens),
        text("zoom", "how the lens was zoomed", lambda c: c.zoom),
        text("focus", "how it was focused", lambda c: c.focus),
        text(
            "taken_from",
            "survey and camera that it was taken from with its calibration, if it was",
            lambda c: c.taken_from,
        ),
        text("notes", "remarks", lambda c: c.notes),
        integer(
            "current_calibration_id",
            "calibration that new road poses use",
            lambda c: c.current_calibration_id,
        ),
    ),
    primary=("id",),
)
