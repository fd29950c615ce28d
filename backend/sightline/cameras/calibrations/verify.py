"""Holding the calibrations of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS, calibration_path
from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.forms import read_json
from sightline.infra.csv_package.schema import record_path
from sightline.infra.csv_package.verify import check_records


@dataclass(eq=False)
class CalibrationEvents:
    """What the events say: `contents` the hash of each calibration, `images` the stored files that it
    was made of, `added` the file of each image as it came; all by number.
    """

    contents: dict[int, str] = field(default_factory=dict)
    images: dict[int, dict[str, str]] = field(default_factory=dict)
    added: dict[str, str] = field(default_factory=dict)

    def add(self, number: int, after: Mapping[str, Any]) -> None:
        """An event of a calibration."""
        if "content_sha256" in after:
            self.contents[number], self.images[number] = after["content_sha256"], after["images"]

    def add_image(self, number: int, after: Mapping[str, Any]) -> None:
        """An event of a calibration image."""
        if "media_key" in after:
            self.added[str(number)] = after["media_key"]


def check_calibrations(files: Files, events: CalibrationEvents) -> None:
    """Calibrations are those whose content the chain vouches for, made of images that the chain knows.

    Raises Damaged.
    """
    check_records(files, "calibration", CALIBRATIONS, calibration_path, events.contents, _values)
    for number, images in events.images.items():
        views = read_json(files, record_path("calibration", number))["views"]
        named = {str(view["image_id"]) for view in views if view.get("image_id") is not None}
        if named != set(images) or any(events.added.get(one) != key for one, key in images.items()):
            raise Damaged("cameras-calibration-of-other-images", id=number)


def _values(record: Mapping[str, Any]) -> Mapping[str, Any]:
    document = record["document"]
    distortion = " ".join(repr(float(one)) for one in document.get("distortion", ()))
    return {**document, **(document.get("board") or {}), **record, "distortion": distortion}
