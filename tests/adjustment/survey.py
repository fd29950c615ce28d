"""A survey drawn from the definitions: a camera, a board that is off, vehicles that drive by and what is
known of them.

It shares no code with sightline.adjustment or sightline.geometry: pictures by the formulas of
tests/geometry/simulate, turns by SciPy, the prior covariance by differences of its own pictures.
"""

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.spatial.transform import Rotation

from tests.geometry.simulate import Lens, Scene, bend

SQUARE, COLUMNS, ROWS, TOP = 0.1, 6, 4, 0.9
CORNER = np.array([0.0, 0.0, TOP])


@dataclass(frozen=True)
class Truth:
    """The road pose as it is, in the form of the pose file."""

    lens: Lens
    rotation: np.ndarray
    translation: np.ndarray

    def see(self, points):
        """Pixels (N, 2) of road points (N, 3)."""
        return pixels(self.lens, np.asarray(points) @ self.rotation.T + self.translation)


def pixels(lens, at_cam):
    a, b = bend(lens, at_cam[:, 0] / at_cam[:, 2], at_cam[:, 1] / at_cam[:, 2])
    return np.stack([lens.f * a + lens.cx, lens.f * b + lens.cy], axis=1)


def truth_at(distance=6.4, height=1.5, lens=None, board=4.0):
    """A camera `height` above the road and `distance` from the wheel track; the origin below the board, which
    stands `board` in front of the camera.
    """
    scene = Scene(lens or Lens(), (0.25, -board, height), 0.0, 6.0, 0.4)
    rotation, translation = scene.pose_arrays()
    return Truth(scene.lens, rotation, translation)


@dataclass(frozen=True)
class BoardBudget:
    """What the board may be off by, standard uncertainties."""

    lean: float = 0.005
    height: float = 0.003
    square: float = 0.0001
    noise_px: float = 0.03  # of the mean corner
    lens: tuple = (0.4, 0.4, 0.5, 0.5, 1e-3, 1e-3, 1e-4, 1e-4, 1e-3)


def prior_covariance(truth, budget):
    """Joint covariance of lens (fx fy cx cy k1 k2 p1 p2 k3) and pose from one board view, by differences."""
    grid = np.array([(j * SQUARE, 0.0, TOP - i * SQUARE) for i in range(ROWS) for j in range(COLUMNS)])

    def seen(x):
        return moved(truth, x).reshape(-1)

    def moved(at, x):
        camera = grid @ at.rotation.T + at.translation
        camera = camera @ Rotation.from_rotvec(x[9:12]).as_matrix().T + x[12:15]
        k = np.array(at.lens.k) + x[4:9]
        a, b = bend(replace(at.lens, k=tuple(k)), camera[:, 0] / camera[:, 2], camera[:, 1] / camera[:, 2])
        return np.stack(
            [(at.lens.f + x[0]) * a + at.lens.cx + x[2], (at.lens.f + x[1]) * b + at.lens.cy + x[3]]
        )

    step = np.array([1e-3] * 4 + [1e-5] * 5 + [1e-6] * 6)
    jacobian = np.stack(
        [(seen(row) - seen(-row)) / (2 * s) for row, s in zip(np.diag(step), step, strict=True)], axis=1
    )
    by_lens, by_pose = jacobian[:, :9], jacobian[:, 9:]
    inverse = np.linalg.inv(by_pose.T @ by_pose)
    answer = -inverse @ by_pose.T @ by_lens
    of_lens = np.diag(np.square(budget.lens))
    whole = np.zeros((15, 15))
    whole[:9, :9] = of_lens
    whole[9:, :9] = answer @ of_lens
    whole[:9, 9:] = whole[9:, :9].T
    whole[9:, 9:] = budget.noise_px**2 * inverse + answer @ of_lens @ answer.T
    return whole


def told_pose(truth, budget, covariance, rng, lean=None):
    """The pose file of somebody whose board and lens are off by draws of what is stated.

    `lean`: the board's lean as it was, instead of a draw.
    """
    leans = rng.normal(0, budget.lean, 2)
    if lean is not None:
        leans[0] = lean
    turn = Rotation.from_euler("XY", -leans).as_matrix()
    rise = rng.normal(0, budget.height)
    scale = 1.0 + rng.normal(0, budget.square) / SQUARE
    # the road as told: turned about the corner, shifted along Z, the whole scene scaled about the corner
    rotation = truth.rotation @ turn
    corner = truth.rotation @ CORNER + truth.translation
    translation = (corner - rotation @ CORNER + truth.rotation[:, 2] * rise) + corner * (scale - 1.0)
    off = (
        rng.multivariate_normal(np.zeros(15), covariance, method="eigh")
        if covariance is not None
        else np.zeros(15)
    )
    spun = Rotation.from_rotvec(off[9:12]).as_matrix()
    lens = truth.lens
    camera = {
        "format": "sightline-camera-1", "name": "drawn", "width_px": lens.width, "height_px": lens.height,
        "model": "brown", "fx_px": lens.f + off[0], "fy_px": lens.f + off[1], "cx_px": lens.cx + off[2],
        "cy_px": lens.cy + off[3], "distortion": list(np.array(lens.k) + off[4:9]), "rms_px": 0.1,
        "parameters": ["fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3"],
        "covariance": None if covariance is None else covariance[:9, :9].tolist(), "views": [],
    }  # fmt: skip
    return {
        "format": "sightline-pose-1",
        "camera": camera,
        "cam_from_road": {
            "rotation": (spun @ rotation).tolist(),
            "translation_m": (spun @ translation + off[12:15]).tolist(),
        },
        "parameters": [*camera["parameters"], "rx", "ry", "rz", "tx", "ty", "tz"],
        "covariance": None if covariance is None else covariance.tolist(),
        "board": {
            "columns": COLUMNS, "rows": ROWS, "square_m": SQUARE, "reference": "top",
            "reference_height_m": TOP, "u_reference_height_m": budget.height, "u_lean_rad": budget.lean,
            "distance_m": 4.0, "u_square_m": budget.square,
        },
        "frames_used": 30,
        "rms_px": 0.1,
    }  # fmt: skip


@dataclass(frozen=True)
class Fleet:
    """What drives by, what is known of it and how it is seen."""

    vehicles: int = 50
    frames: int = 8
    sigma_px: float = 0.5
    u_wheelbase: float | None = 0.01
    u_roof: float | None = None
    u_common: float = 0.005
    wrong_share: float = 0.0
    roof: float = 1.5  # mean
    lateral: tuple = (5.4, 7.4)  # of the near wheels, from the camera's foot
    board: float = 4.0
    blunder_share: float = 0.0
    real_sigma_px: float | None = None
    extra: dict = field(default_factory=dict)


def passes(truth, fleet, rng):
    """Rows of passes.csv as dicts; `wrong` names the vehicles of which another model's sizes are told."""
    common = rng.normal(0, fleet.u_common, 2)
    # of an assumed inset half the variance is that of its mean (DECISIONS.md, 31)
    mean_inset = 0.3 + 0.5**0.5 * rng.spawn(1)[0].normal(0, 0.1)
    rows, wrong = [], []
    for index in range(fleet.vehicles):
        wheelbase, roof = rng.normal(2.65, 0.15), rng.normal(fleet.roof, 0.08)
        inset, ahead = rng.normal(mean_inset, 0.5**0.5 * 0.1), rng.uniform(0.3, 0.6) * wheelbase
        way = rng.choice([-1.0, 1.0])
        heading = rng.normal(0, 0.005)
        across = rng.uniform(*fleet.lateral) - fleet.board
        forward = np.array([np.cos(heading), np.sin(heading), 0.0])
        behind = np.array([-np.sin(heading), np.cos(heading), 0.0])
        rear = 0.25 - way * 0.5 * wheelbase + np.linspace(-1.4, 1.4, fleet.frames)
        base = np.array([0.0, across, 0.0]) + rear[:, None] * forward
        seen = {
            "rear_tyre": base,
            "front_tyre": base + way * wheelbase * forward,
            "roof": base + way * ahead * forward + inset * behind + [0, 0, roof],
        }
        told = {}
        bad = rng.random() < fleet.wrong_share
        error = rng.choice([-1, 1], 2) * rng.uniform(0.04, 0.25, 2) if bad else np.zeros(2)
        if fleet.u_wheelbase is not None:
            known = wheelbase + common[0] + rng.normal(0, fleet.u_wheelbase) + error[0]
            told |= {"wheelbase_m": known, "u_wheelbase_m": fleet.u_wheelbase}
        if fleet.u_roof is not None:
            known = roof + common[1] + rng.normal(0, fleet.u_roof) + 0.5 * error[1]
            told |= {"roof_m": known, "u_roof_m": fleet.u_roof, "roof_inset_m": 0.3, "u_roof_inset_m": 0.1}
        if bad:
            wrong.append(str(index))
        noise = fleet.real_sigma_px or fleet.sigma_px
        for point, at in seen.items():
            at_px = truth.see(at)
            at_px = at_px + rng.normal(0, noise, at_px.shape)
            blunder = rng.random(len(at_px)) < fleet.blunder_share
            at_px = at_px + blunder[:, None] * rng.normal(0, 15, at_px.shape)
            rows += [
                {
                    "pass": str(index),
                    "frame": k,
                    "point": point,
                    "x_px": x,
                    "y_px": y,
                    "sigma_px": fleet.sigma_px,
                }
                | told
                for k, (x, y) in enumerate(at_px)
            ]
    return rows, wrong


def eye_clicks(truth, distance=6.4, height=1.15, inset=0.45, board=4.0):
    """Where contact and eye of a vehicle `distance` from the camera are seen, exactly."""
    y = distance - board
    return truth.see([(0.25, y, 0.0), (0.25, y + inset, height)])
