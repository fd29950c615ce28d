"""Who passes a pair of line-scan cameras, and when: the rig as it truly is, vehicles, motions, their truth.

Times are seconds of the recording; line n is exposed around n / line rate. Everything is a frozen dataclass
of plain numbers. Nothing of the line-scan room is used here: its results are judged by these values.
"""

from dataclasses import dataclass, replace

import numpy as np

from tests.simulation.camera import Array
from tests.simulation.models import MODELS, Model
from tests.simulation.scene import PAINTS, Vehicle
from tests.simulation.shape import Shape, shape_of

RESTART_MPS2 = 1.5


@dataclass(frozen=True)
class ScanSite:
    """The rig and the weather as they truly are. `misalignment_px`: row in strip 2 minus row in strip 1.

    `opening_m`: by how much the baseline is longer at the far lane, where the scanning planes open.
    `plane_m`: from the cameras' centres to the near lane's side plane; what lies behind that plane is then
    seen under the angle that it has. None: vehicles are flat, all of them on the plane.
    """

    rows: int = 256
    baseline_m: float = 0.593
    line_rate_hz: float = 4882.8
    field_m: float = 2.4
    top_m: float = 2.22
    blur_m: float = 0.004
    read_noise_dn: float = 2.0
    shot_dn2_per_dn: float = 0.02
    row_gain: float = 0.01
    gain_2: float = 1.04
    offset_2_dn: float = 3.0
    drift: float = 0.08
    drift_period_s: float = 40.0
    misalignment_px: float = 0.0
    exposure: float = 0.86
    flicker: float = 0.0
    flicker_hz: float = 100.0
    rain_per_s: float = 0.0
    shadow_m: float = 0.27
    plane_m: float | None = None
    opening_m: float = 0.0
    seed: int = 1


@dataclass(frozen=True)
class Halt:
    """The vehicle stops with its front `at_m` beyond the first camera and waits.

    `creeps`: from there on by so many metres (below 0: back), and how many seconds it waits then.
    """

    at_m: float
    wait_s: float
    braking_mps2: float = 3.0
    creeps: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Photograph:
    """What covers a vehicle's side in the place of its paint: a part of a picture file, read as grey.

    `left_px`, `top_px`: the part's corner; `px_per_m`: its scale on the vehicle. Beyond its rim it is
    continued by its mirror image.
    """

    path: str
    left_px: int
    top_px: int
    px_per_m: float


@dataclass(frozen=True)
class ScanVehicle:
    """One vehicle; speed and acceleration hold when its front reaches the first camera, at `front_s`.

    `far`: drives the farther lane, smaller in the picture and behind whatever is near; `against`: the
    other way, so that it reaches camera 2 first; `skin`: what its side shows, None: as it is drawn.
    """

    vehicle: Vehicle
    front_s: float
    speed_mps: float
    acceleration_mps2: float
    far: bool = False
    against: bool = False
    halt: Halt | None = None
    skin: Photograph | None = None

    @property
    def shape(self) -> Shape:
        return shape_of(self.vehicle)

    @property
    def length_m(self) -> float:
        return self.vehicle.model.length_m

    @property
    def wheelbase_m(self) -> float:
        return self.vehicle.model.wheelbase_m

    def travelled_m(self, time_s: Array) -> Array:
        """How far beyond the camera it reaches first the front is at `time_s`; goes back in creeps alone."""
        tau = np.asarray(time_s, float) - self.front_s
        if self.halt is not None:
            return _with_halt(tau, self.speed_mps, self.halt)
        v, a = self.speed_mps, self.acceleration_mps2
        if a < 0:
            tau = np.minimum(tau, -v / a)
        elif a > 0:
            tau = np.maximum(tau, -v / a)
        return np.asarray(v * tau + a / 2 * tau**2)

    def time_s(self, travelled_m: float) -> float:
        """When the front is that far beyond the first camera (no halt): the quadratic's stable root."""
        v, a = self.speed_mps, self.acceleration_mps2
        return self.front_s + 2 * travelled_m / (v + float(np.sqrt(v * v + 2 * a * travelled_m)))

    def clear_s(self, baseline_m: float) -> float:
        """When its rear has left both cameras."""
        if self.halt is None:
            return self.time_s(self.length_m + baseline_m)
        far = self.front_s + 600.0
        grid = np.arange(self.front_s, far, 0.01)
        return float(grid[np.argmax(self.travelled_m(grid) >= self.length_m + baseline_m)])


def _with_halt(tau: Array, speed: float, halt: Halt) -> Array:
    """Constant speed, braking to a stop, a wait, creeps with a wait after each, and away again."""
    brakes_at = (halt.at_m - speed**2 / (2 * halt.braking_mps2)) / speed
    stops_at = brakes_at + speed / halt.braking_mps2
    leaves_at = stops_at + halt.wait_s
    into = np.clip(tau - brakes_at, 0, stops_at - brakes_at)
    crept = np.zeros(np.shape(tau))
    for by_m, wait_s in halt.creeps:
        # faster through the first half of the way, slower through the second
        half_s = float(np.sqrt(abs(by_m) / RESTART_MPS2))
        share = np.clip((tau - leaves_at) / half_s, 0, 2)
        crept += by_m * np.where(share < 1, share**2, 2 - (2 - share) ** 2) / 2
        leaves_at += 2 * half_s + wait_s
    out = np.maximum(tau - leaves_at, 0)
    cruise = speed * np.minimum(tau, brakes_at) + crept
    return np.asarray(cruise + speed * into - halt.braking_mps2 / 2 * into**2 + RESTART_MPS2 / 2 * out**2)


@dataclass(frozen=True)
class ScanTruth:
    """What is true of one vehicle; lines are fractional, wheels' lines are where the hubs cross camera 1.

    The gaps run from the vehicle before: rear to this front at camera 1, and the distance between the same
    two points when this front reaches camera 1. None for the first, and beside a vehicle that stops.
    """

    vehicle: ScanVehicle
    front_line_1: float
    rear_line_1: float
    front_line_2: float
    rear_line_2: float
    wheel_lines_1: tuple[float, float]
    time_gap_s: float | None
    distance_gap_m: float | None


def baseline_at(site: ScanSite, car: ScanVehicle) -> float:
    """What lies between both scanning planes in a vehicle's lane."""
    return site.baseline_m + (site.opening_m if car.far else 0.0)


def truths(site: ScanSite, vehicles: tuple[ScanVehicle, ...]) -> tuple[ScanTruth, ...]:
    """The truth of every vehicle that does not halt, in order of arrival."""
    out: list[ScanTruth] = []
    before: ScanVehicle | None = None
    for car in sorted(vehicles, key=lambda one: one.front_s):
        if car.halt is None:
            out.append(_truth(site, car, before))
        before = car
    return tuple(out)


def _truth(site: ScanSite, car: ScanVehicle, before: ScanVehicle | None) -> ScanTruth:
    rate, length, baseline = site.line_rate_hz, car.length_m, baseline_at(site, car)
    camera_1, camera_2 = (baseline, 0.0) if car.against else (0.0, baseline)
    hubs = [camera_1 + length - axle for axle in reversed(car.shape.axles)]
    gap_s = gap_m = None
    if before is not None and before.halt is None and not (before.against or car.against):
        gap_s = car.front_s - before.time_s(before.length_m)
        gap_m = float(before.travelled_m(np.array(car.front_s))) - before.length_m
    return ScanTruth(
        vehicle=car,
        front_line_1=car.time_s(camera_1) * rate,
        rear_line_1=car.time_s(camera_1 + length) * rate,
        front_line_2=car.time_s(camera_2) * rate,
        rear_line_2=car.time_s(camera_2 + length) * rate,
        wheel_lines_1=(car.time_s(hubs[0]) * rate, car.time_s(hubs[1]) * rate),
        time_gap_s=gap_s,
        distance_gap_m=gap_m,
    )


def scan_body(number: int, model: Model, rng: np.random.Generator) -> Vehicle:
    """A body to paint; in a strip the front comes first, so writing is drawn as on a vehicle heading left."""
    blue, green, red = PAINTS[number * 5 % len(PAINTS)]
    tone = float(rng.uniform(0.92, 1.05))
    return Vehicle(
        number=number,
        model=model,
        year=int(rng.integers(model.year_from, model.year_to + 1)),
        paint=(blue * tone, green * tone, red * tone),
        lane="near",
        direction=-1,
        side_plane_m=0.0,
        speed_mps=0.0,
        first_frame=0,
        last_frame=0,
        front_start_m=0.0,
        roof_height_m=model.height_m,
        eye_height_m=model.eye_height_m,
        eye_inset_m=0.4,
        driver_side="near",
        tail_lamp_m=model.tail_lamp_m,
        seed=int(rng.integers(1 << 30)),
    )


def _stretched(model: Model, rng: np.random.Generator) -> Model:
    gain = float(rng.uniform(0.91, 1.088))
    return replace(model, length_m=model.length_m * gain, wheelbase_m=model.wheelbase_m * gain)


def traffic(
    seed: int,
    count: int,
    speeds_mps: tuple[float, float] = (8.0, 36.0),
    accelerations_mps2: tuple[float, float] = (-1.5, 1.5),
    gaps_s: tuple[float, float] = (0.4, 1.2),
    start_s: float = 0.3,
    stretch: bool = True,
    baseline_m: float = 0.593,
) -> tuple[ScanVehicle, ...]:
    """Vehicles with everything drawn evenly from ranges, each clear of the one before.

    `stretch` varies the catalogue's lengths from 3.5 to 8 m; without it, lengths are the catalogue's.
    """
    rng = np.random.default_rng((seed, 77))
    out: list[ScanVehicle] = []
    clear = start_s
    for number in range(1, count + 1):
        model = MODELS[int(rng.integers(len(MODELS)))]
        body = scan_body(number, _stretched(model, rng) if stretch else model, rng)
        front = clear + float(rng.uniform(*gaps_s))
        car = ScanVehicle(
            body, front, float(rng.uniform(*speeds_mps)), float(rng.uniform(*accelerations_mps2))
        )
        out.append(car)
        clear = car.clear_s(baseline_m)
    return tuple(out)


def demo_traffic() -> tuple[ScanVehicle, ...]:
    """Every model of the catalogue once, 15 vehicles in some 25 s, at the speeds of a road in town.

    The road is empty for the first 4 s, in which a rod is held up.
    """
    rng = np.random.default_rng(20070507)
    order = (3, 0, 8, 11, 5, 13, 1, 9, 6, 2, 12, 4, 14, 7, 10)
    out: list[ScanVehicle] = []
    clear = 4.0
    for number, index in enumerate(order, 1):
        body = scan_body(number, MODELS[index], rng)
        front = clear + float(rng.uniform(0.7, 1.9))
        speed = float(np.clip(rng.normal(14.5, 2.2), 9.0, 20.0))
        car = ScanVehicle(body, round(front, 4), round(speed, 3), round(float(rng.uniform(-1.2, 1.2)), 3))
        out.append(car)
        clear = car.clear_s(0.593)
    return tuple(out)
