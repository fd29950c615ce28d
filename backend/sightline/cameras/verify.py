"""Holding the cameras of a package against the audit chain."""

from sightline.cameras.calibrations.csv import CALIBRATIONS
from sightline.cameras.csv import CAMERAS
from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.replay import Replay, Replayed

_NOTHING = dict.fromkeys(CAMERAS.header)
REPLAYED = Replayed(CAMERAS, "camera", cells=lambda told: {**_NOTHING, **told})


def check_cameras(files: Files, replay: Replay) -> None:
    """Cameras are what their events made of them, and calibrations name them so. Raises Damaged."""
    names = {row["id"]: row["name"] for row in replay.hold(files, REPLAYED)}
    for id_, camera, name in read_columns(files, CALIBRATIONS.key, ("id", "camera_id", "camera_name")):
        if name != names.get(camera):
            raise Damaged("cameras-calibration-camera-changed", id=id_)
