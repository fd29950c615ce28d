"""Holding the calibrations of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.cameras.calibrations.csv import CALIBRATIONS, calibration_path
from sightline.infra.csv_package.files import Files
from sightline.infra.csv_package.verify import check_records


def check_calibrations(files: Files, contents: Mapping[int, str]) -> None:
    """Calibrations are those whose content the chain vouches for (hash by number). Raises Damaged."""
    check_records(files, "calibration", CALIBRATIONS, calibration_path, contents, _values)


def _values(record: Mapping[str, Any]) -> Mapping[str, Any]:
    document = record["document"]
    distortion = " ".join(repr(float(one)) for one in document.get("distortion", ()))
    return {**document, **(document.get("board") or {}), **record, "distortion": distortion}
