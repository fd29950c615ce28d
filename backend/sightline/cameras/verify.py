"""Holding the cameras of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS
from sightline.cameras.csv import CAMERAS
from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_columns, read_rows
from sightline.infra.csv_package.schema import safe_text
from sightline.infra.csv_package.verify import says


def check_cameras(files: Files, cameras: Mapping[int, Mapping[str, Any]]) -> None:
    """Cameras are what their events made of them, by number, and calibrations name them so.

    Raises Damaged.
    """
    rows = {int(row["id"]): row for row in read_rows(files, CAMERAS.path)}
    for number in sorted({*rows, *cameras}):
        made = cameras.get(number)
        said = made and {**dict.fromkeys(CAMERAS.header), **made, "id": number}
        if not said or number not in rows or not says(CAMERAS, rows[number], said):
            raise Damaged("cameras-cameras-csv-not-what-audit", id=number)
    for id_, camera, name in read_columns(files, CALIBRATIONS.path, ("id", "camera_id", "camera_name")):
        if name != safe_text(cameras[int(camera)]["name"]):
            raise Damaged("cameras-calibration-of-another-camera", id=id_)
