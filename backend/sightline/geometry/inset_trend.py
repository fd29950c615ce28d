"""Insets from a survey's own vehicles: known heights, the trend with distance, two-frame solutions.

All rest on the closed form of an uncorrected height (inset 0): a target of height h, `inset` behind the side
plane D from the camera, reads m = Hc + (h - Hc) k with k = D / (D + inset) (CONVENTIONS.md, of the one-frame
height; Hc is the camera's height).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Bools, Floats
from sightline.geometry.gradient import gradient
from sightline.geometry.height import systematic_covariance
from sightline.geometry.ray_intersection import OK, intersect_rays
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.spread import mean_and_spread, outliers
from sightline.messages.said import Said

LEAST_KNOWN = 3
LEAST_TREND = 10
LEAST_FOR_SPREAD = 8
_LEAST_INSET_M, _MOST_INSET_M = -0.5, 2.5
_WIDE_U_M = 0.30  # as unknown as a target of unknown inset: such a figure says nothing
_ROUNDS = 60


@dataclass(frozen=True, eq=False)
class Sightings:
    """N uncorrected heights: camera height, distance to the side plane, height, standard uncertainty of its
    own clicks, each (N,); `shared_m2` (N, N) is the covariance of what they share: lens, pose and board.
    """

    camera_height_m: Floats
    distance_m: Floats
    measured_m: Floats
    u_m: Floats
    shared_m2: Floats

    def __len__(self) -> int:
        return len(self.measured_m)

    def only(self, chosen: Bools) -> "Sightings":
        """The rows that are `chosen` (N,)."""
        rows = np.flatnonzero(chosen)
        return Sightings(
            self.camera_height_m[rows],
            self.distance_m[rows],
            self.measured_m[rows],
            self.u_m[rows],
            self.shared_m2[np.ix_(rows, rows)],
        )


@dataclass(frozen=True)
class InsetEstimate:
    """An inset with its standard uncertainty and the number of vehicles behind it.

    `spread_m`: standard deviation between vehicles where the figures tell it. `caution`: why it should not
    be used, None where it can. `left_out`: rows that did not fit the others. `height_m`: mean height found
    with it (trend only).
    """

    inset_m: float
    u_inset_m: float
    vehicles: int
    spread_m: float | None = None
    caution: Said | None = None
    left_out: tuple[int, ...] = ()
    height_m: float | None = None


def sightings(
    pose: RoadPose, contacts_px: ArrayLike, targets_px: ArrayLike, sigma_px: ArrayLike
) -> tuple[Sightings, Bools]:
    """Uncorrected heights under one pose, `contacts_px`, `targets_px` (N, 2), `sigma_px` (N,); and which rows
    have one (N,).

    Dupuis et al. 2019, eqs. (5) to (18), corrected as in ray_intersection.py; u from the clicks sigma |g|,
    and what all share g' S g with S of `systematic_covariance` (JCGM 100:2008, 5.1.2 and 5.2.2).
    """
    contacts = np.asarray(contacts_px, dtype=np.float64).reshape(-1, 2)
    targets = np.asarray(targets_px, dtype=np.float64).reshape(-1, 2)
    sigma = np.broadcast_to(np.asarray(sigma_px, dtype=np.float64), (len(contacts),))
    fine = np.asarray(intersect_rays(pose, contacts, targets, 0.0).code == OK, dtype=np.bool_)
    intersection = intersect_rays(pose, contacts[fine], targets[fine], 0.0)
    g = gradient(pose, intersection)
    own = sigma[fine] * np.sqrt((g.target**2).sum(axis=0) + (g.contact**2).sum(axis=0))
    shared = g.parameters.T @ systematic_covariance(pose) @ g.parameters
    camera = np.full(int(fine.sum()), float(pose.centre_m[2]))
    return Sightings(
        camera, intersection.plane_m, intersection.height_m, np.asarray(own), np.asarray(shared)
    ), fine


def combine_sightings(parts: Sequence[Sightings]) -> Sightings:
    """Sightings under several poses as one; different poses share nothing that counts here."""
    total = sum(len(part) for part in parts)
    shared = np.zeros((total, total))
    at = 0
    for part in parts:
        shared[at : at + len(part), at : at + len(part)] = part.shared_m2
        at += len(part)
    return Sightings(
        np.concatenate([part.camera_height_m for part in parts]),
        np.concatenate([part.distance_m for part in parts]),
        np.concatenate([part.measured_m for part in parts]),
        np.concatenate([part.u_m for part in parts]),
        shared,
    )


def inset_from_known_heights(
    rows: Sightings, known_m: ArrayLike, u_known_m: ArrayLike
) -> InsetEstimate | Said:
    """Inset of a target whose heights are known (roofs, from the manufacturer), or the reason why there is
    none: known_m (N,), u_known_m a number or (N,), metres.

    Least squares of m - Hc - (h - Hc) k over the inset (CONVENTIONS.md, Height); the weights hold both the
    clicks' and the known height's uncertainty, u_m^2 + (k u_h)^2, with k following the inset: so errors of h
    do not draw it to one side (Deming 1943). A wrong entry of the catalogue is recognised against the median
    of the others, from five vehicles on, and left out. The uncertainty has the residuals' scatter where that
    is larger, and what all heights share.
    """
    known = np.asarray(known_m, dtype=np.float64).ravel()
    u_known = np.broadcast_to(np.asarray(u_known_m, dtype=np.float64), known.shape)
    if len(rows) < LEAST_KNOWN:
        return Said("inset-few-known", least=LEAST_KNOWN, usable=len(rows))
    used = ~_do_not_fit(rows, known, u_known)
    left_out = tuple(int(i) for i in np.flatnonzero(~used))
    rows, known, u_known = rows.only(used), known[used], u_known[used]

    def cost(inset: float) -> float:
        return float(np.square(_misfit(rows, known, u_known, inset)).sum())

    found = scipy.optimize.minimize_scalar(
        cost, bounds=(_LEAST_INSET_M, _MOST_INSET_M), options={"xatol": 1e-9}
    )
    inset = float(found.x)
    weight, slope = _weight(rows, u_known, inset), _slope(rows, known - rows.camera_height_m, inset)
    power = float(weight @ slope**2)
    if power < 1.0:  # one standard uncertainty would be a metre
        return Said("inset-known-at-camera-height")
    if not _LEAST_INSET_M + 1e-3 < inset < _MOST_INSET_M - 1e-3:
        return Said("inset-none-fits")
    answer = weight * slope / power
    scatter = max(1.0, cost(inset) / (len(rows) - 1))
    u = float(np.sqrt(scatter / power + max(float(answer @ rows.shared_m2 @ answer), 0.0)))
    caution = None
    if u > _WIDE_U_M:
        caution = Said("inset-known-vague")
    return InsetEstimate(
        inset_m=inset, u_inset_m=u, vehicles=len(rows), spread_m=None, caution=caution, left_out=left_out
    )


def _misfit(rows: Sightings, known: Floats, u_known: Floats, inset: float) -> Floats:
    """Residuals in their standard uncertainties (N,)."""
    camera, k = rows.camera_height_m, rows.distance_m / (rows.distance_m + inset)
    off = rows.measured_m - camera - (known - camera) * k
    return np.asarray(off * np.sqrt(_weight(rows, u_known, inset)), dtype=np.float64)


def _weight(rows: Sightings, u_known: Floats, inset: float) -> Floats:
    k = rows.distance_m / (rows.distance_m + inset)
    return np.asarray(1.0 / (rows.u_m**2 + np.square(k * u_known) + 1e-12), dtype=np.float64)


def _slope(rows: Sightings, above_camera: Floats, inset: float) -> Floats:
    """Derivative of an uncorrected height by the inset, h - Hc given as `above_camera`."""
    d = rows.distance_m
    return np.asarray(-above_camera * d / np.square(d + inset), dtype=np.float64)


def _do_not_fit(rows: Sightings, known: Floats, u_known: Floats) -> Bools:
    """Rows far from the fit of the least sum of absolute residuals, which one wrong height hardly moves."""
    tried = np.linspace(_LEAST_INSET_M, _MOST_INSET_M, 301)
    sums = [float(np.abs(_misfit(rows, known, u_known, float(one))).sum()) for one in tried]
    misfit = _misfit(rows, known, u_known, float(tried[int(np.argmin(sums))]))
    return outliers(misfit, least=1.0)


def inset_from_trend(rows: Sightings) -> InsetEstimate | Said:
    """Inset and mean height from how uncorrected heights trend with distance, or why there are none.

    Fits m = Hc + (h - Hc) k; vehicles differ in h, and that scatter, found from the residuals, is in the
    weights. It holds only if height and lane are unrelated, which nothing here can tell.
    """
    if len(rows) < LEAST_TREND:
        return Said("inset-few-trend", least=LEAST_TREND, usable=len(rows))
    solved = _fit_trend(rows)
    if solved is None:
        return Said("inset-no-trend")
    height, inset, covariance = solved
    u = float(np.sqrt(covariance[1, 1]))
    caution = _why_silent(rows, height) if u > _WIDE_U_M else None
    return InsetEstimate(
        inset_m=inset,
        u_inset_m=u,
        vehicles=len(rows),
        spread_m=None,
        caution=caution,
        left_out=(),
        height_m=height,
    )


def _fit_trend(rows: Sightings) -> tuple[float, float, Floats] | None:
    """Mean height, inset and their covariance (2, 2) by reweighted least squares; None without a solution."""
    d, camera = rows.distance_m, rows.camera_height_m
    height, inset, between2 = float(rows.measured_m.mean()), 0.2, 0.05**2
    for _ in range(_ROUNDS):
        k = d / (d + inset)
        off = rows.measured_m - camera - (height - camera) * k
        between2 = max(float(np.mean((off**2 - rows.u_m**2) / k**2)), 1e-8)
        weight = 1.0 / (rows.u_m**2 + k**2 * between2)
        jacobian = np.column_stack([k, _slope(rows, height - camera, inset)])
        normal = jacobian.T @ (weight[:, None] * jacobian)
        if np.linalg.cond(normal) > 1e12:
            return None
        answer = np.linalg.solve(normal, jacobian.T * weight)
        step = answer @ off
        height, moved = height + float(step[0]), float(np.clip(inset + step[1], -0.8, 4.0))
        settled = abs(moved - inset) < 1e-7
        inset = moved
        if settled:
            break
    if not -0.79 < inset < 3.99:
        return None
    freedom = len(rows) / (len(rows) - 2)
    covariance = freedom * np.linalg.inv(normal) + answer @ rows.shared_m2 @ answer.T
    return height, inset, np.asarray(covariance, dtype=np.float64)


def _why_silent(rows: Sightings, height_m: float) -> Said:
    d = rows.distance_m
    if abs(height_m - float(rows.camera_height_m.mean())) < 0.10:
        return Said("inset-trend-at-camera-height")
    if float(d.max()) < 1.4 * float(d.min()):
        nearest_m, farthest_m = round(float(d.min()), 1), round(float(d.max()), 1)
        return Said("inset-trend-one-distance", nearest_m=nearest_m, farthest_m=farthest_m)
    return Said("inset-trend-few")


def inset_from_solved(
    solved_m: ArrayLike, u_own_m: ArrayLike, shared_m2: ArrayLike = 0.0
) -> InsetEstimate | Said:
    """Mean of insets solved for on several frames, `solved_m` (N,), metres, and the spread between vehicles,
    or the reason why there is none; `u_own_m` (N,): each vehicle's own part of u, `shared_m2` (N, N):
    covariance of what they share (`shared_covariance`).

    By `mean_and_spread` (Paule and Mandel 1982), vehicles far from the others left out (`outliers`).
    """
    values = np.asarray(solved_m, dtype=np.float64).ravel()
    u = np.asarray(u_own_m, dtype=np.float64).ravel()
    shared = np.broadcast_to(np.asarray(shared_m2, dtype=np.float64), (len(values), len(values)))
    if len(values) < LEAST_KNOWN:
        return Said("inset-few-solved", least=LEAST_KNOWN, count=len(values))
    gone = outliers(values, u)
    estimate = mean_and_spread(values[~gone], u[~gone], shared[np.ix_(~gone, ~gone)])
    spread = estimate.between if estimate.count >= LEAST_FOR_SPREAD else None
    left_out = tuple(int(i) for i in np.flatnonzero(gone))
    caution = Said("inset-solved-close-frames") if estimate.u_mean > _WIDE_U_M else None
    return InsetEstimate(
        inset_m=estimate.mean,
        u_inset_m=estimate.u_mean,
        vehicles=estimate.count,
        spread_m=spread,
        caution=caution,
        left_out=left_out,
    )
