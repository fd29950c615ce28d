"""What one vehicle looks like to a line camera: running sums along the body, so that exposures are exact.

Textures are (along, rows) with `along` counted from the front backwards. A line is the mean over what passed
during its exposure, so it is the difference of a running sum at two places.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import cv2
import numpy as np

from tests.simulation.camera import Array, Floats
from tests.simulation.insides import driver_plate, spoke_count, wheel_plates
from tests.simulation.light import DAY
from tests.simulation.paint import Plate, Stencil, body_outline, glass_area
from tests.simulation.scan_traffic import Photograph, ScanSite, ScanVehicle
from tests.simulation.shape import Shape
from tests.simulation.sideart import side_plate

ART_PPM = 200.0
FINER = 2
PPM = ART_PPM * FINER
MARGIN_M = 0.6
TURNS = 16
HOUSING_DN = 26.0
FAR_SCALE = 0.62
EYE_M = 1.2
# rows of the texture are cut into so many to find the outline in them; an end is looked for so far to either
# side of it, where it runs back by less than so much a metre of height
_PARTS, _NEAR_END_M, _STEEP = 8, 0.03, 1.5
# no shadow falls higher
_SHADE_M = 0.45
_GREY = np.array([0.114, 0.587, 0.299], np.float32)


@dataclass(frozen=True, eq=False)
class Ribbon:
    """Running sums (n + 1, rows) of own light and of how much of the road behind comes through.

    `start_m`: body coordinate (metres behind the front) of the first sample's near edge.
    """

    light: Array
    through: Array
    start_m: float

    def mean(self, from_m: Array, to_m: Array) -> tuple[Floats, Floats]:
        """(lines, rows) light and transmission, averaged from one body coordinate to another."""
        lo, hi = (self._places(one) for one in (from_m, to_m))
        width = np.maximum((to_m - from_m) * PPM, 1e-9)[:, None]
        light = (_smooth_at(self.light, hi) - _smooth_at(self.light, lo)) / width
        # what lies outside the sums is plain road
        outside = width[:, 0] - (hi - lo)
        through = (_smooth_at(self.through, hi) - _smooth_at(self.through, lo) + outside[:, None]) / width
        return light.astype(np.float32), through.astype(np.float32)

    def _places(self, coordinate_m: Array) -> Array:
        return np.asarray(np.clip((coordinate_m - self.start_m) * PPM, 0, len(self.light) - 1))


def _at(sums: Array, place: Array) -> Array:
    low = np.minimum(place.astype(int), len(sums) - 2)
    part = (place - low)[:, None]
    return np.asarray(sums[low] * (1 - part) + sums[low + 1] * part)


def _smooth_at(sums: Array, place: Array) -> Array:
    """Running sums of a texture that is interpolated between its samples' middles, not one of upright bars:
    their quadratic B-spline. A slow vehicle's lines are finer than the samples, and would show the bars.
    """
    middle = np.clip(np.rint(place).astype(int), 1, len(sums) - 2)
    part = (place - middle)[:, None]
    out = sums[middle] * (0.75 - part**2)
    out += sums[middle - 1] * ((0.5 - part) ** 2 / 2)
    out += sums[middle + 1] * ((0.5 + part) ** 2 / 2)
    return np.asarray(out)


@dataclass(frozen=True, eq=False)
class Wheel:
    """A wheel at TURNS angles from one spoke to the next: running sums (TURNS, n + 1, rows of the band)."""

    light: Array
    cover: Array
    hub_m: float
    half_m: float
    radius_m: float
    step_rad: float
    row_0: int


@dataclass(frozen=True, eq=False)
class Body:
    """All that one camera sees of one vehicle."""

    ribbon: Ribbon
    wheels: tuple[Wheel, ...]


def row_edges_m(site: ScanSite, camera: int) -> Array:
    """Heights (rows + 1,) of the rows' edges on the near lane's plane, from the top downwards."""
    shift = site.misalignment_px if camera == 2 else 0.0
    return site.top_m - (np.arange(site.rows + 1) - shift) * site.field_m / site.rows


def _edges(site: ScanSite, camera: int, far: bool) -> Array:
    edges = row_edges_m(site, camera)
    return EYE_M + (edges - EYE_M) / FAR_SCALE if far else edges


def _to_rows(picture: Floats, top_m: float, ppm: float, edges_m: Array) -> Floats:
    """Box means (rows, w) of a picture (h, w) between row edges; what lies beyond the picture is 0."""
    sums = np.zeros((len(picture) + 1, picture.shape[1]))
    for row, above, below in zip(
        picture, sums, sums[1:], strict=False
    ):  # NumPy's own takes four times as long
        np.add(above, row, out=below)
    place = np.clip((top_m - edges_m) * ppm, 0, len(picture))
    values = _at(sums, place)
    return np.asarray(np.diff(values, axis=0) / (ppm * -np.diff(edges_m))[:, None], np.float32)


def _grey(plate: Plate) -> tuple[Floats, Floats]:
    """Premultiplied grey and coverage (h, w) of a texture."""
    rgba = np.asarray(plate.rgba, np.float32)
    return rgba[..., :3] @ _GREY, rgba[..., 3] / 255


def _over(base: tuple[Floats, Floats], plate: Plate, left_m: float, top_m: float, mask: Floats) -> None:
    """Lays a texture BEHIND what is there, in place, where `mask` lets it."""
    light, cover = _grey(plate)
    x, y = round((plate.left_m - left_m) * ART_PPM), round((top_m - plate.top_m) * ART_PPM)
    x0, y0 = max(x, 0), max(y, 0)
    x1, y1 = min(x + light.shape[1], base[0].shape[1]), min(y + light.shape[0], base[0].shape[0])
    if x1 <= x0 or y1 <= y0:
        return
    at, of = np.s_[y0:y1, x0:x1], np.s_[y0 - y : y1 - y, x0 - x : x1 - x]
    room = (1 - base[1][at]) * mask[at]
    base[0][at] += room * light[of]
    base[1][at] += room * cover[of]


@lru_cache(maxsize=2)
def _photograph(path: str) -> Floats:
    picture = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
    if picture is None:
        raise FileNotFoundError(path)
    return np.asarray(picture, np.float32)


def _skin(of: Photograph, size: tuple[int, ...]) -> Floats:
    """The photograph's part (h, w), ART_PPM pixels a metre."""
    step = of.px_per_m / ART_PPM
    x, y = np.meshgrid(
        of.left_px + step * np.arange(size[1]), of.top_px + step * np.arange(size[0]), indexing="xy"
    )
    picture = _photograph(of.path)
    flat = x.astype(np.float32), y.astype(np.float32)
    return np.asarray(cv2.remap(picture, *flat, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT), np.float32)


@lru_cache(maxsize=6)
def _side(
    shape: Shape, plane_m: float | None, skin: Photograph | None = None
) -> tuple[Floats, Floats, float, float]:
    """The still part of the near side: light, coverage (h, w; l forward), left edge, top edge."""
    plate = side_plate(shape, DAY, ART_PPM, EYE_M, 3.0, 0.0)
    light, cover = _at_outline(shape, plate)
    stencil = Stencil(-0.08, shape.length_m + 0.08, 0.0, shape.vehicle.roof_height_m + 0.06, ART_PPM)
    driver, glass = driver_plate(shape, DAY, ART_PPM), glass_area(shape, stencil)
    if plane_m is not None:
        seen = _as_seen(shape.inset, light.shape, plate.left_m, plate.top_m, plane_m)
        light, cover, glass = (seen(part) for part in (light, cover, glass))
        inset_m = shape.vehicle.eye_inset_m
        deep = _as_seen(
            lambda along, _z: np.full_like(along, inset_m),
            driver.rgba.shape[:2],
            driver.left_m,
            driver.top_m,
            plane_m,
        )
        driver = replace(driver, rgba=deep(np.asarray(driver.rgba, np.float32)))
    _over((light, cover), driver, plate.left_m, plate.top_m, glass)
    body = stencil.area(body_outline(shape))
    for axle in shape.axles:
        arch = stencil.disc((axle, shape.radius_m + 0.005), shape.radius_m + 0.045) * body
        light += (1 - cover) * arch * HOUSING_DN
        cover += (1 - cover) * arch
    if skin is not None:
        light = cover * _skin(skin, cover.shape)
    return _finer(light), _finer(cover), plate.left_m, plate.top_m


def outline_ends(shape: Shape, z: Array) -> tuple[Array, Array]:
    """Rearmost and foremost l (n,) of the painted body at heights `z` (n,); NaN beside it."""
    outline = body_outline(shape)
    rear, front = np.full(z.shape, np.nan), np.full(z.shape, np.nan)
    for (l0, z0), (l1, z1) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        if z0 == z1:
            continue
        part = (z - z0) / (z1 - z0)
        at = np.where((part >= 0) & (part <= 1), l0 + part * (l1 - l0), np.nan)
        rear, front = np.fmin(rear, at), np.fmax(front, at)
    return rear, front


def _at_outline(shape: Shape, plate: Plate) -> tuple[Floats, Floats]:
    """Light and coverage (h, w) of the side, each row of which begins and ends where the outline does.

    What is filled is filled in whole pixels of the stencil, edges included, and lamps are laid over a border
    that is half covered already: the drawn ends lie up to 3 mm outside.
    """
    light, cover = _grey(plate)
    left_m, columns = plate.left_m, np.arange(cover.shape[1])
    along = left_m + (columns + 0.5) / ART_PPM
    fine = plate.top_m - (np.arange(len(cover) * _PARTS) + 0.5) / (ART_PPM * _PARTS)
    true = [one.reshape(-1, _PARTS).mean(axis=1) for one in outline_ends(shape, fine)]
    rear = -_drawn_too_far(cover[:, ::-1], -along[-1] - 0.5 / ART_PPM, -true[0])
    front = _drawn_too_far(cover, left_m, true[1])
    # from one end to the other in proportion, beyond them as at them
    share = np.clip(along / shape.length_m, 0, 1)[None]
    places = columns + (rear[:, None] * (1 - share) + front[:, None] * share) * ART_PPM
    low = np.clip(places.astype(int), 0, len(columns) - 2)
    part = np.clip(places - low, 0, 1).astype(np.float32)
    first, second = (
        np.take_along_axis(one, low, axis=1) * (1 - part) + np.take_along_axis(one, low + 1, axis=1) * part
        for one in (light, cover)
    )
    return first, second


def _drawn_too_far(cover: Floats, left_m: float, true_m: Array) -> Array:
    """By how much (h,) each row of a coverage (h, w) ends too far to the right: metres.

    The end is where as much is covered outside as is open inside. Where the outline `true_m` (h,) is flat or
    what it borders is see-through, as in the nearest row above or below where it is not.
    """
    known = np.isfinite(true_m)
    first = np.rint((np.where(known, true_m, 0.0) - left_m - _NEAR_END_M) * ART_PPM).astype(int)
    places = first[:, None] + np.arange(round(2 * _NEAR_END_M * ART_PPM))
    near = np.take_along_axis(cover, np.clip(places, 0, cover.shape[1] - 1), axis=1)
    too_far = left_m + (first + near.sum(axis=1)) / ART_PPM - true_m
    steep = np.abs(np.gradient(true_m)) * ART_PPM < _STEEP
    good = known & steep & (near[:, :2].min(axis=1) > 0.99) & (near[:, -2:].max(axis=1) < 0.01)
    rows = np.arange(len(cover))
    return np.asarray(np.interp(rows, rows[good], too_far[good]))


def _as_seen(
    inset: Callable[[Array, Array], Array], size: tuple[int, ...], left_m: float, top_m: float, plane_m: float
) -> Callable[[Floats], Floats]:
    """Moves a texture's rows to where a camera EYE_M high, `plane_m` from the side plane, sees them on it.

    `inset`: how far the skin at (l, z) lies behind the plane; what is at z is seen at
    EYE_M + (z - EYE_M) plane / (plane + inset), which is solved for z by iteration.
    """
    along, seen = np.meshgrid(
        left_m + (np.arange(size[1]) + 0.5) / ART_PPM, top_m - (np.arange(size[0]) + 0.5) / ART_PPM
    )
    z = seen
    for _ in range(4):
        z = EYE_M + (seen - EYE_M) * (plane_m + inset(along, z)) / plane_m
    x = np.tile(np.arange(size[1], dtype=np.float32), (size[0], 1))
    y = ((top_m - z) * ART_PPM - 0.5).astype(np.float32)
    return lambda picture: np.asarray(cv2.remap(picture, x, y, cv2.INTER_LINEAR), np.float32)


def _finer(picture: Floats) -> Floats:
    """FINER times as many columns: lines are finer than rows."""
    size = (picture.shape[1] * FINER, picture.shape[0])
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_LINEAR), np.float32)


def _blurred(picture: Floats, site: ScanSite) -> Floats:
    along, up = site.blur_m * PPM, site.blur_m * ART_PPM
    return np.asarray(cv2.GaussianBlur(picture, (0, 0), sigmaX=along, sigmaY=up), np.float32)


def _shadow(shape: Shape, site: ScanSite, along_m: Array, z: Array) -> Floats:
    """How much of the road's light is left (h, w): shade ahead, below and behind, soft at its ends."""
    out, low = np.ones((len(z), len(along_m)), np.float32), z < _SHADE_M
    behind_front, z = along_m[None], z[low]
    soft = 0.03
    inside = np.clip((behind_front + site.shadow_m) / soft + 0.5, 0, 1)
    inside = inside * np.clip((shape.length_m + 0.08 - behind_front) / soft + 0.5, 0, 1)
    middle = np.abs(behind_front - shape.length_m / 2) < shape.length_m / 2 - 0.25
    on_road = 0.55 * np.clip((0.13 - z) / 0.02 + 0.5, 0, 1)[:, None] * inside
    below = 0.5 * np.clip((0.42 - z) / 0.02, 0, 1)[:, None] * middle
    out[low] = 1 - np.maximum(on_road, below)
    return out


def ribbon_of(car: ScanVehicle, site: ScanSite, camera: int) -> Ribbon:
    """The body's running sums as one camera sees it, optical blur included."""
    shape, edges = car.shape, _edges(site, camera, car.far)
    light, cover, left_m, top_m = _side(shape, site.plane_m, car.skin)
    pad = round(MARGIN_M * PPM)
    # flipped: from here on columns run from the front backwards
    light, cover = (np.pad(part[:, ::-1], ((0, 0), (pad, pad))) for part in (light, cover))
    front = left_m + (light.shape[1] - 2 * pad) / PPM - shape.length_m
    start_m = -front - pad / PPM
    foot = round(0.25 * ART_PPM)
    light, cover = (np.pad(part, ((0, foot), (0, 0))) for part in (light, cover))
    along = start_m + (np.arange(light.shape[1]) + 0.5) / PPM
    z = top_m - (np.arange(light.shape[0]) + 0.5) / ART_PPM
    through = (1 - cover) * _shadow(shape, site, along, z)
    rows_light = _to_rows(_blurred(light, site), top_m, ART_PPM, edges)
    rows_through = 1 - _to_rows(1 - _blurred(np.asarray(through, np.float32), site), top_m, ART_PPM, edges)
    return Ribbon(_sums(rows_light), _sums(rows_through), start_m)


def _sums(rows: Floats) -> Array:
    """(rows, w) to running sums (w + 1, rows)."""
    sums = np.zeros((rows.shape[1] + 1, len(rows)))
    np.cumsum(rows, 1, dtype=np.float64, out=sums.T[:, 1:])
    return sums


@lru_cache(maxsize=6)
def _turning(shape: Shape) -> tuple[Plate, ...]:
    return wheel_plates(shape, DAY, ART_PPM, TURNS, 0.0)


def wheels_of(car: ScanVehicle, site: ScanSite, camera: int) -> tuple[Wheel, ...]:
    """Both wheels as one camera sees them."""
    shape, edges = car.shape, _edges(site, camera, car.far)
    centre = shape.radius_m
    lights: list[Array] = []
    covers: list[Array] = []
    for plate in _turning(shape):
        for part, kept in zip(_grey(plate), (lights, covers), strict=True):
            soft = _blurred(_finer(part), site)
            kept.append(_sums(_to_rows(soft, plate.top_m + centre, ART_PPM, edges)[:, ::-1]))
    light, cover = np.stack(lights).astype(np.float32), np.stack(covers).astype(np.float32)
    used = np.flatnonzero(cover[0, -1] > 0)
    if not len(used):
        return ()
    band = slice(int(used[0]), int(used[-1]) + 1)
    half = (light.shape[1] - 1) / (2 * PPM)
    step = 2 * np.pi / spoke_count(shape) / TURNS
    return tuple(
        Wheel(
            light=light[..., band],
            cover=cover[..., band],
            hub_m=shape.length_m - axle,
            half_m=half,
            radius_m=centre,
            step_rad=step,
            row_0=band.start,
        )
        for axle in shape.axles
    )


def body_of(car: ScanVehicle, site: ScanSite, camera: int) -> Body:
    """What camera 1 or 2 sees of a vehicle, whatever its motion."""
    still = replace(car, front_s=0.0, speed_mps=1.0, acceleration_mps2=0.0, against=False, halt=None)
    sees = ScanSite(
        site.rows,
        field_m=site.field_m,
        top_m=site.top_m,
        blur_m=site.blur_m,
        misalignment_px=site.misalignment_px if camera == 2 else 0.0,
        shadow_m=site.shadow_m,
        plane_m=site.plane_m,
    )
    return _body(still, sees, camera)


@lru_cache(maxsize=4)
def _body(car: ScanVehicle, site: ScanSite, camera: int) -> Body:
    return Body(ribbon_of(car, site, camera), wheels_of(car, site, camera))
