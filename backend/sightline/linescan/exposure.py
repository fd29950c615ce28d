"""What the pixels and the exposure of a line camera make of a passing vehicle: blur, shape, light.

Douxchamps et al., section II, take large rectangular pixels and binning for the light that a short line
leaves, and section V finds that the large difference between both resolutions turns a vertical misalignment
into an error of the speed where features are slanted. Both are planned here, of the geometry alone.
"""

from dataclasses import dataclass

from sightline.enums import ExposureHint
from sightline.errors import BadInput

#: A common pixel and a common exposure, for the light of a line to be compared with.
COMMON_PIXEL_UM, COMMON_EXPOSURE_US = 5.0, 1000.0
_LITTLE_LIGHT = 0.1
_WIDE, _TALL = 2.0, 4.0


@dataclass(frozen=True)
class LineCamera:
    """A line camera and how it sees vehicles; `pixel_width_um` along the travel, `pixel_height_um` along the
    line, both after binning. `exposure_us`: None for the whole time of a line.
    """

    pixel_width_um: float
    pixel_height_um: float
    focal_mm: float
    distance_m: float
    exposure_us: float | None = None


@dataclass(frozen=True)
class ExposurePlan:
    """What a line shows of a vehicle, metres on its side.

    `blur_m`: how far it travels while a line is exposed; `pixel_width_m`, `pixel_height_m`: what a pixel
    covers; `smear_m`: over how much an upright edge is spread, both together. `shape`: a pixel's height over
    what the vehicle travels from line to line. `row_error`: share by which the speed is off where a feature
    slanted by 45 degrees meets a row of misalignment. `light`: of one line, over that of a pixel of 5 um
    square exposed for 1 ms behind the same aperture. `hints`: what to beware of.
    """

    exposure_us: float
    blur_m: float
    pixel_width_m: float
    pixel_height_m: float
    smear_m: float
    shape: float
    row_error: float
    light: float
    hints: tuple[ExposureHint, ...]


def plan_exposure(
    camera: LineCamera, speed_mps: float, line_rate_hz: float, baseline_m: float
) -> ExposurePlan:
    """The plan for a vehicle of this speed. Raises BadInput for a camera that cannot be, or an exposure
    that is longer than a line.

    Own derivation: a pinhole lens, pixel on the vehicle = pixel distance / focal length; blur = speed times
    exposure; a row of misalignment moves a feature of 45 degrees by a row, which is taken for travel.
    """
    _require(camera)
    line_us = 1e6 / line_rate_hz
    exposure_us = line_us if camera.exposure_us is None else camera.exposure_us
    if exposure_us > line_us * (1 + 1e-9):
        raise BadInput(
            "planning-exposure-too-long", exposure_us=f"{exposure_us:.4g}", line_us=f"{line_us:.4g}"
        )
    width_m, height_m = (
        1e-3 * size_um * camera.distance_m / camera.focal_mm
        for size_um in (camera.pixel_width_um, camera.pixel_height_um)
    )
    blur_m, line_m = 1e-6 * exposure_us * speed_mps, speed_mps / line_rate_hz
    area = camera.pixel_width_um * camera.pixel_height_um / COMMON_PIXEL_UM**2
    shape, light = height_m / line_m, area * exposure_us / COMMON_EXPOSURE_US
    return ExposurePlan(
        exposure_us=exposure_us,
        blur_m=blur_m,
        pixel_width_m=width_m,
        pixel_height_m=height_m,
        smear_m=width_m + blur_m,
        shape=shape,
        row_error=height_m / baseline_m,
        light=light,
        hints=_hints(light, width_m / line_m, shape),
    )


def _require(camera: LineCamera) -> None:
    limits = {
        "pixel_width_um": 1000.0,
        "pixel_height_um": 1000.0,
        "focal_mm": 2000.0,
        "distance_m": 1000.0,
    }
    values: dict[str, float | None] = vars(camera)
    for name, most in {**limits, "exposure_us": 1e6}.items():
        value = values[name]
        if value is not None and not 0 < value <= most:
            raise BadInput("planning-camera-cannot-be", name=name, value=f"{value:.6g}", most=f"{most:g}")


def _hints(light: float, width: float, shape: float) -> tuple[ExposureHint, ...]:
    """Too little light; pixels wider, or higher, than what is travelled from line to line can use."""
    hints: dict[ExposureHint, bool] = {
        "dark": light < _LITTLE_LIGHT,
        "wide": width > _WIDE,
        "tall": shape > _TALL,
    }
    return tuple(hint for hint, holds in hints.items() if holds)
