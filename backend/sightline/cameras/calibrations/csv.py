"""The table of calibrations in the package."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import get_args

from sightline.cameras.calibrations.records import Calibration
from sightline.enums import CalibrationSource, LensModel
from sightline.infra.csv_package.columns import (
    columns_within,
    flag,
    integer,
    key,
    moment,
    number,
    person,
    text,
)
from sightline.infra.csv_package.schema import Cell, Column, Table


def calibration_path(calibration_id: int) -> str:
    """Where a calibration is, as the command line reads it."""
    return f"calibrations/calibration-{calibration_id}.json"


@dataclass(frozen=True, slots=True)
class NamedCalibration:
    """A calibration and the name of its camera."""

    calibration: Calibration
    camera_name: str | None


def _document_getter(name: str) -> Callable[[NamedCalibration], Cell]:
    """What the calibration's document says."""

    def of(named: NamedCalibration) -> Cell:
        value: Cell = named.calibration.document.get(name)
        return value

    return of


def _distortion(named: NamedCalibration) -> str:
    return " ".join(repr(float(value)) for value in named.calibration.document["distortion"])


def _pixels(name: str, meaning: str) -> Column[NamedCalibration]:
    return number(name, meaning, "px", _document_getter(name), required=True)


CALIBRATIONS: Table[NamedCalibration] = Table(
    "calibrations",
    "Lens and camera matrix behind the poses; the whole of each is in calibrations/calibration-N.json.",
    (
        *columns_within("calibration", key("id", "calibration"), key("camera_id", "camera it belongs to")),
        text("camera_name", "name of the camera"),
        *columns_within(
            "calibration", text("source", "where it comes from", enum=get_args(CalibrationSource))
        ),
        text("model", "lens model", _document_getter("model"), required=True, enum=get_args(LensModel)),
        integer("width_px", "width of the images", _document_getter("width_px"), unit="px", required=True),
        integer("height_px", "height of the images", _document_getter("height_px"), unit="px", required=True),
        _pixels("fx_px", "focal length along x"),
        _pixels("fy_px", "focal length along y"),
        _pixels("cx_px", "principal point, x"),
        _pixels("cy_px", "principal point, y"),
        text("distortion", "distortion coefficients in OpenCV's order, separated by blanks", _distortion),
        number("rms_px", "root of the mean squared point distance", "px", _document_getter("rms_px")),
        *columns_within("calibration", flag("trusted", "false where the program warned against using it")),
        text(
            "document",
            "the calibration as a file of this package (sightline-camera-1)",
            lambda c: calibration_path(c.calibration.id),
            required=True,
        ),
        *columns_within(
            "calibration", person("created_by_id", "who made it"), moment("created_at", "when it was made")
        ),
    ),
    primary=("id",),
)
