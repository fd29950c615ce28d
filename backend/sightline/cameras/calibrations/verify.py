"""Holding the calibrations of a package against the audit chain."""

from collections.abc import Mapping
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS, calibration_path
from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.forms import read_json
from sightline.infra.csv_package.replay import Replay
from sightline.infra.csv_package.schema import record_path
from sightline.infra.csv_package.verify import check_records


def check_calibrations(files: Files, replay: Replay) -> None:
    """Calibrations and the images they are made of are those that the chain vouches for. Raises Damaged."""
    made = {number: told for number, told in replay.of("calibration").items() if "content_sha256" in told}
    contents = {number: told["content_sha256"] for number, told in made.items()}
    check_records(files, "calibration", CALIBRATIONS, calibration_path, contents, _values)
    added = {str(number): told.get("media_key") for number, told in replay.of("calibration_image").items()}
    for number, told in made.items():
        views = read_json(files, record_path("calibration", number))["views"]
        named = {str(view["image_id"]) for view in views if view.get("image_id") is not None}
        images = told["images"]
        if named != set(images) or any(added.get(one) != key for one, key in images.items()):
            raise Damaged("cameras-calibration-images-changed", id=number)


def _values(record: Mapping[str, Any]) -> Mapping[str, Any]:
    document = record["document"]
    distortion = " ".join(repr(float(one)) for one in document.get("distortion", ()))
    return {**document, **(document.get("board") or {}), **record, "distortion": distortion}
